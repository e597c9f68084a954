"""Writes what a reference is made of: see README.md."""
import json
import math
import os

import numpy as np


def write(scene, out, spp, renderer, batches):
    """`batches`: independent images of the scene, height × width × 3, `spp` samples per pixel together."""
    images = np.stack(batches)
    root = math.sqrt(len(images))
    mean, error = images.mean(0), images.std(0, ddof=1) / root
    height, width, _ = mean.shape
    base = os.path.splitext(out)[0]
    mean.astype('<f4').tofile(out)
    error.astype('<f4').tofile(f'{base}.se.f32')
    meta = {'scene': os.path.basename(scene), 'width': width, 'height': height, 'spp': spp, 'renderer': renderer,
            'mean': mean.mean((0, 1)).tolist(), 'meanStandardError': (images.mean((1, 2)).std(0, ddof=1) / root).tolist(),
            'relativePixelStandardError': float(np.sqrt((error ** 2).mean()) / mean.mean())}
    with open(f'{base}.meta.json', 'w') as file:
        json.dump(meta, file, indent=1)
    print(json.dumps(meta))
