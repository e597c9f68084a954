"""Reference images from Blender's Cycles for glTF files, as Blender's own importer reads them.

Usage: python render_cycles_gltf.py SCENE.glb OUT.f32 [--size 128] [--spp 4096] [--batches 16] [--bounces 8]
Writes what render_mitsuba.py writes. Needs: pip install bpy numpy (Python 3.11 for Blender 4.5).

A point light of 1 cd becomes a lamp of 4π W, which is 1 W/sr: `COMPAT`. By Blender's default, `SPEC`, candelas are divided by
683 lm/W while emission is not, so that the file's lamps and lights would no longer compare.
"""
import argparse, os, sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'bench', 'rivals'))
import bpy
import numpy as np
from cycles_rival import configure, render, result
from reference_files import write


def load(file):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=os.path.abspath(file), export_import_convert_lighting_mode='COMPAT')
    scene = bpy.context.scene
    scene.camera = next(o for o in scene.objects if o.type == 'CAMERA')
    return scene


def main():
    a = argparse.ArgumentParser(); a.add_argument('scene'); a.add_argument('out'); a.add_argument('--size', type=int, default=128)
    a.add_argument('--spp', type=int, default=4096); a.add_argument('--batches', type=int, default=16); a.add_argument('--bounces', type=int, default=8)
    a = a.parse_args(); scene = load(a.scene); configure(scene, a.size, a.size, a.bounces)
    batches = []
    for seed in range(a.batches):
        render(scene, a.spp // a.batches, seed)
        batches.append(result(a.size, a.size).astype(np.float64))
    write(a.scene, a.out, a.spp, f'Cycles {bpy.app.version_string}', batches)


if __name__ == '__main__':
    main()
