"""Writes small glTF files that show material extensions, to be looked at beside Blender's pictures of them.

Usage: python make_extension_gltfs.py FOLDER
Each has three balls (or sheets) on a floor, below a lamp, in a large box that shines evenly: glTF has no environment. Render
them with render_cycles_gltf.py. Blender's materials are not the extensions', so the pictures are alike, not equal.
"""
import os
import struct
import sys
import zlib

import numpy as np

from glb import Glb, turned

FLOOR = [(-3, 0, 2), (3, 0, 2), (3, 0, -3), (-3, 0, -3)], [(0, 1, 2), (0, 2, 3)]
LAMP = [(-.9, 3.2, -.4), (.3, 3.2, -.4), (.3, 3.2, .8), (-.9, 3.2, .8)], [(0, 1, 2), (0, 2, 3)]
SHEET = [(-.5, -.5, 0), (.5, -.5, 0), (.5, .5, 0), (-.5, .5, 0)], [(0, 1, 2), (0, 2, 3)]
SHEET_UVS = [(0, 2), (2, 2), (2, 0), (0, 0)]


def box(half):
    """Its fronts are inside."""
    corners = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    return corners, [t for a, b, c, d in [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)] for t in ((a, b, c), (a, c, d))]


def ball(rows=48, columns=96):
    """Of unit radius; its vertices are its normals."""
    t, a = np.meshgrid(np.pi * np.arange(1, rows) / rows, 2 * np.pi * np.arange(columns) / columns, indexing='ij')
    body = np.stack([np.sin(t) * np.cos(a), np.cos(t), -np.sin(t) * np.sin(a)], -1).reshape(-1, 3)
    at, top, bottom = lambda i, j: i * columns + j % columns, len(body), len(body) + 1
    faces = [(top, at(0, j), at(0, j + 1)) for j in range(columns)] + [(bottom, at(rows - 2, j + 1), at(rows - 2, j)) for j in range(columns)]
    faces += [f for i in range(rows - 2) for j in range(columns) for f in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))]
    return np.concatenate([body, [(0, 1, 0), (0, -1, 0)]]), faces


def png(texels):
    """RGBA bytes, height × width × 4."""
    height, width, _ = texels.shape
    chunk = lambda name, data: struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))
    rows = b''.join(b'\0' + row.tobytes() for row in texels)
    return b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 6, 0, 0, 0)) + chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b'')


def surface(colour, roughness=1, metallic=0, alpha=1, **extensions):
    return {'pbrMetallicRoughness': {'baseColorFactor': [*colour, alpha], 'roughnessFactor': roughness, 'metallicFactor': metallic},
            'extensions': {f'KHR_materials_{name}': values for name, values in extensions.items()}}


def lambert(colour, **more): return {**surface(colour, ior={'ior': 1}), **more}


def write(file, shown, sheets=False):
    """`shown`: three materials."""
    glb = Glb()
    materials = [lambert([.55, .5, .45]), lambert([0, 0, 0], emissiveFactor=[1, .95, .85]), lambert([0, 0, 0], emissiveFactor=[.4, .43, .47]), *shown]
    materials[1]['extensions']['KHR_materials_emissive_strength'] = {'emissiveStrength': 8}
    mesh = lambda shape, material, **more: {'primitives': [{'attributes': {'POSITION': glb.vectors(shape[0], 'VEC3'), **more}, 'indices': glb.faces(shape[1]), 'material': material}]}
    shape = SHEET if sheets else ball()
    more = {'TEXCOORD_0': glb.vectors(SHEET_UVS, 'VEC2')} if sheets else {'NORMAL': glb.vectors(shape[0], 'VEC3')}
    meshes = [mesh(FLOOR, 0), mesh(LAMP, 1), mesh(box(12), 2), *(mesh(shape, 3 + i, **more) for i in range(len(shown)))]
    x, y = np.meshgrid(np.arange(8), np.arange(8))
    leaf = np.stack([60 + 20 * x, 180 - 12 * y, 50 + 0 * x, 255 * ((np.hypot(x - 3, y - 4) < 3.3) & (np.hypot(x - 3, y - 4) >= 1.5))], -1).astype(np.uint8)
    places = [(-1.15, .5 + .02, .1), (0, .52, .55), (1.15, .52, .1)]
    size = [1, 1, 1] if sheets else [.5, .5, .5]
    nodes = [{'mesh': i} for i in range(3)] + [{'mesh': 3 + i, 'translation': places[i], 'scale': size, 'rotation': turned([0, 1, 0], 20 * i - 20)} for i in range(len(shown))]
    nodes.append({'camera': 0, 'translation': [0, 2.2, 4.4], 'rotation': turned([1, 0, 0], -22)})
    used = {name for material in materials for name in material['extensions']}
    picture = {'images': [{'bufferView': glb.view(png(leaf)), 'mimeType': 'image/png'}], 'samplers': [{'magFilter': 9728, 'minFilter': 9728}], 'textures': [{'source': 0, 'sampler': 0}]}
    glb.write(file, {'extensionsUsed': sorted(used), 'materials': materials, 'meshes': meshes, **(picture if sheets else {}), 'nodes': nodes,
                     'cameras': [{'type': 'perspective', 'perspective': {'yfov': float(np.radians(43)), 'aspectRatio': 1, 'znear': .01, 'zfar': 100}}],
                     'scenes': [{'nodes': list(range(len(nodes)))}], 'scene': 0})


FILES = {
    'clearcoat': [
        surface([.6, .05, .03], .6, clearcoat={'clearcoatFactor': 1, 'clearcoatRoughnessFactor': .1}),
        surface([.05, .1, .4], .5, 1, clearcoat={'clearcoatFactor': 1, 'clearcoatRoughnessFactor': .3}),
        surface([.5, .5, .5], 1, clearcoat={'clearcoatFactor': .5, 'clearcoatRoughnessFactor': .2}),
    ],
    'sheen': [
        surface([.05, .05, .1], 1, sheen={'sheenColorFactor': [.8, .8, .9], 'sheenRoughnessFactor': .3}),
        surface([.3, .03, .05], 1, sheen={'sheenColorFactor': [.9, .4, .4], 'sheenRoughnessFactor': .5}),
        surface([.2, .2, .2], 1, sheen={'sheenColorFactor': [.2, .7, .3], 'sheenRoughnessFactor': .9}),
    ],
    'volume': [
        surface([1, 1, 1], .0, transmission={'transmissionFactor': 1}, volume={'thicknessFactor': 1, 'attenuationColor': [.35, .85, .5], 'attenuationDistance': .5}),
        surface([1, 1, 1], .3, transmission={'transmissionFactor': 1}, volume={'thicknessFactor': 1, 'attenuationColor': [.95, .7, .25], 'attenuationDistance': .6}),
        surface([.8, .6, .9], .6, transmission={'transmissionFactor': 1}, volume={'thicknessFactor': 1}, ior={'ior': 1.3}),
    ],
    'specgloss': [
        {'extensions': {'KHR_materials_pbrSpecularGlossiness': {'diffuseFactor': [.5, .3, .1, 1], 'specularFactor': [.04, .04, .04], 'glossinessFactor': .6}}},
        {'extensions': {'KHR_materials_pbrSpecularGlossiness': {'diffuseFactor': [0, 0, 0, 1], 'specularFactor': [.9, .6, .3], 'glossinessFactor': .7}}},
        {'extensions': {'KHR_materials_pbrSpecularGlossiness': {'diffuseFactor': [.1, .3, .4, 1], 'specularFactor': [.2, .2, .25], 'glossinessFactor': .5}}},
    ],
}


def leafy(mode, alpha=1, **more):
    material = lambert([1, 1, 1], alphaMode=mode, doubleSided=True, **more)
    material['pbrMetallicRoughness'] = {'baseColorFactor': [.9, .95, .8, alpha], 'metallicFactor': 0, 'baseColorTexture': {'index': 0}}
    return material


def main():
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    for name, shown in FILES.items(): write(os.path.join(folder, f'{name}.glb'), shown)
    plain = lambert([.3, .5, .9], alphaMode='BLEND', doubleSided=True)
    plain['pbrMetallicRoughness']['baseColorFactor'][3] = .4
    # Everything is Lambert: what renderers agree on.
    write(os.path.join(folder, 'alpha.glb'), [leafy('MASK', alphaCutoff=.5), plain, leafy('BLEND', .7)], sheets=True)


if __name__ == '__main__':
    main()
