"""Writes mirrored.glb: a glTF file whose nodes turn, stretch and mirror two meshes, lit by a point light and a lamp.

Usage: python make_gltf_scene.py
Everything is Lambert (KHR_materials_ior 1) and faceted: what renderers agree on to the last digit. The lamp is one of the
mirrored: to shine outwards its triangles must be turned around.
"""
import os

import numpy as np

from glb import Glb, turned

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'mirrored.glb')

FLOOR = [(-3, 0, -3), (-3, 0, 3), (3, 0, 3), (3, 0, -3)], [0, 1, 2, 0, 2, 3]
# A tetrahedron with a skewed top: no mirror image of it is itself.
SHARD = [(-1, 0, -.6), (1, 0, -.6), (.1, 0, 1), (.6, 1.6, .3)], [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0]


def lambert(name, colour, **more):
    return {'name': name, 'pbrMetallicRoughness': {'baseColorFactor': [*colour, 1], 'metallicFactor': 0},
            'extensions': {'KHR_materials_ior': {'ior': 1}, **more.pop('extensions', {})}, 'doubleSided': True, **more}


def main():
    glb = Glb()

    def mesh(positions, indices, *materials):
        attributes, faces = {'POSITION': glb.vectors(positions, 'VEC3')}, glb.faces(indices)
        return [{'primitives': [{'attributes': attributes, 'indices': faces, 'material': m}]} for m in materials]

    glb.write(FILE, {
        'extensionsUsed': ['KHR_lights_punctual', 'KHR_materials_ior', 'KHR_materials_emissive_strength'],
        'materials': [
            lambert('floor', [.7, .7, .7]), lambert('clay', [.8, .35, .2]), lambert('moss', [.25, .6, .3]),
            lambert('lamp', [.2, .2, .2], emissiveFactor=[1, .8, .5], extensions={'KHR_materials_emissive_strength': {'emissiveStrength': 6}}),
        ],
        'meshes': mesh(*FLOOR, 0) + mesh(*SHARD, 1, 2, 3),
        'cameras': [{'type': 'perspective', 'perspective': {'yfov': float(np.radians(40)), 'aspectRatio': 1, 'znear': .01, 'zfar': 100}}],
        'extensions': {'KHR_lights_punctual': {'lights': [{'type': 'point', 'color': [.6, .8, 1], 'intensity': 9}]}},
        'nodes': [
            {'mesh': 0},
            {'mesh': 1, 'translation': [-1.2, .02, -.3], 'rotation': turned([0, 1, 0], 25)},
            # Mirrored, and stretched within a turned and stretched parent: skewed.
            {'translation': [1.1, .02, -.4], 'rotation': turned([0, 1, 0], -50), 'scale': [.8, .8, 1.3], 'children': [3]},
            {'mesh': 2, 'rotation': turned([0, 1, 0], 35), 'scale': [-1, 1.2, .7]},
            # Mirrored thrice, upside down.
            {'mesh': 3, 'translation': [.1, 2.1, .5], 'rotation': turned([1, 0, 1], 20), 'scale': [-.35, -.35, -.35]},
            {'translation': [-1.6, 2.6, 1.8], 'extensions': {'KHR_lights_punctual': {'light': 0}}},
            {'camera': 0, 'translation': [0, 3.1, 4.9], 'rotation': turned([1, 0, 0], -27)},
        ],
        'scenes': [{'nodes': [0, 1, 2, 4, 5, 6]}], 'scene': 0,
    })


if __name__ == '__main__':
    main()
