"""Reference images from Blender's Cycles for glTF files, as Blender's own importer reads them.

Usage: python render_cycles_gltf.py SCENE.glb OUT.f32 [--size 128] [--spp 4096] [--batches 16] [--bounces 8] [--multiscatter]
Writes what render_mitsuba.py writes. Needs: pip install bpy numpy (Python 3.11 for Blender 4.5).

A point light of 1 cd becomes a lamp of 4π W, which is 1 W/sr: `COMPAT`. By Blender's default, `SPEC`, candelas are divided by
683 lm/W while emission is not, so that the file's lamps and lights would no longer compare.

Microfacets reflect once, as glTF has it, unless `--multiscatter` leaves them as Blender imports them. Volumes absorb what
KHR_materials_volume says, for Blender's node is not what its importer takes it for: see `absorb`.
"""
import argparse, math, os, sys

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


def nodes(kind): return [node for m in bpy.data.materials if m.use_nodes for node in m.node_tree.nodes if node.bl_idname == kind]


def absorb(node):
    """Volume Absorption has the extinction (1 - color)·density; the importer writes attenuationColor and 1 / attenuationDistance there."""
    color, density = node.inputs['Color'], node.inputs['Density']
    sigma = [-math.log(max(c, 1e-6)) * density.default_value for c in color.default_value[:3]]
    density.default_value = max(sigma)
    color.default_value = [1 - s / (max(sigma) or 1) for s in sigma] + [1]


def main():
    a = argparse.ArgumentParser(); a.add_argument('scene'); a.add_argument('out'); a.add_argument('--size', type=int, default=128)
    a.add_argument('--spp', type=int, default=4096); a.add_argument('--batches', type=int, default=16); a.add_argument('--bounces', type=int, default=8)
    a.add_argument('--multiscatter', action='store_true')
    a = a.parse_args(); scene = load(a.scene); configure(scene, a.size, a.size, a.bounces)
    scene.cycles.transmission_bounces, scene.cycles.transparent_max_bounces = scene.cycles.max_bounces, 64
    for node in nodes('ShaderNodeVolumeAbsorption'): absorb(node)
    if not a.multiscatter:
        for node in nodes('ShaderNodeBsdfPrincipled'): node.distribution = 'GGX'
    batches = []
    for seed in range(a.batches):
        render(scene, a.spp // a.batches, seed)
        batches.append(result(a.size, a.size).astype(np.float64))
    write(a.scene, a.out, a.spp, f'Cycles {bpy.app.version_string}', batches)


if __name__ == '__main__':
    main()
