"""Writes binary glTF: see make_gltf_scene.py and make_extension_gltfs.py."""
import json
import struct

import numpy as np


class Glb:
    """What lies in a file's one buffer, and the views and accessors of it."""

    def __init__(self):
        self.binary, self.views, self.accessors = b'', [], []

    def view(self, data):
        self.views.append({'buffer': 0, 'byteOffset': len(self.binary), 'byteLength': len(data)})
        self.binary += data + b'\0' * (-len(data) % 4)
        return len(self.views) - 1

    def accessor(self, values, code, kind, **more):
        view = self.view(struct.pack(f'<{len(values)}{code}', *values))
        self.accessors.append({'bufferView': view, 'componentType': {'f': 5126, 'H': 5123}[code], 'type': kind, **more})
        return len(self.accessors) - 1

    def vectors(self, values, kind):
        """Floats per vertex; bounds, which positions need."""
        v = np.float32(values)
        return self.accessor(v.ravel().tolist(), 'f', kind, count=len(v), min=v.min(0).tolist(), max=v.max(0).tolist())

    def faces(self, indices):
        flat = np.ravel(indices).tolist()
        return self.accessor(flat, 'H', 'SCALAR', count=len(flat))

    def write(self, file, gltf):
        gltf = {'asset': {'version': '2.0'}, **gltf, 'bufferViews': self.views, 'accessors': self.accessors, 'buffers': [{'byteLength': len(self.binary)}]}
        text = json.dumps(gltf, separators=(',', ':')).encode()
        text += b' ' * (-len(text) % 4)
        with open(file, 'wb') as out:
            out.write(struct.pack('<4sII', b'glTF', 2, 28 + len(text) + len(self.binary)))
            out.write(struct.pack('<I4s', len(text), b'JSON') + text + struct.pack('<I4s', len(self.binary), b'BIN\0') + self.binary)


def turned(axis, degrees):
    half = np.radians(degrees) / 2
    return [*(np.array(axis) / np.linalg.norm(axis) * np.sin(half)).tolist(), float(np.cos(half))]
