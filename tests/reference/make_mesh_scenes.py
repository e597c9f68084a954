"""Writes scenes/knot.json and scenes/glow.json: the reference scenes with meshes.

Usage: python make_mesh_scenes.py
Positions and normals are rounded to 3 decimals: what the file says is the mesh, for every renderer that reads it.
"""
import json
import os

import numpy as np

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'scenes')
TAU = 2 * np.pi


def grid(rows, columns, closes_rows):
    """Triangles of a grid of vertices that closes on itself along its columns, and perhaps along its rows."""
    faces = []
    for i in range(rows if closes_rows else rows - 1):
        for j in range(columns):
            a, b = i * columns + j, i * columns + (j + 1) % columns
            c, d = (i + 1) % rows * columns + j, (i + 1) % rows * columns + (j + 1) % columns
            faces += [(a, c, b), (b, c, d)]
    return faces


def knot(segments, sides, tube):
    """A (2, 3) torus knot of about unit radius, standing upright, with the normals of its tube."""
    t = TAU * np.arange(segments) / segments
    path = lambda t: np.stack([(1 + .45 * np.cos(3 * t)) * np.cos(2 * t), (1 + .45 * np.cos(3 * t)) * np.sin(2 * t), .45 * np.sin(3 * t)], 1)
    along = path(t + 1e-5) - path(t - 1e-5)
    along /= np.linalg.norm(along, axis=1)[:, None]
    out = path(t) * [1, 1, 0]
    across = np.cross(along, out)
    across /= np.linalg.norm(across, axis=1)[:, None]
    up = np.cross(across, along)
    s = TAU * np.arange(sides) / sides
    normals = across[:, None] * np.cos(s)[None, :, None] + up[:, None] * np.sin(s)[None, :, None]
    positions = path(t)[:, None] + tube * normals
    return positions.reshape(-1, 3), normals.reshape(-1, 3), grid(segments, sides, True)


def gem():
    """An icosahedron of unit radius, each face split into four: 80 flat triangles."""
    g = (1 + 5 ** .5) / 2
    v = [np.array(p, float) / np.hypot(1, g) for p in [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
                                                         (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    middles = {}

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in middles:
            m = v[a] + v[b]
            v.append(m / np.linalg.norm(m))
            middles[key] = len(v) - 1
        return middles[key]

    split = []
    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        split += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.array(v), split


def ring(segments, sides, tube):
    """A bumpy torus of unit radius around y."""
    a, b = np.meshgrid(TAU * np.arange(segments) / segments, TAU * np.arange(sides) / sides, indexing='ij')
    r = tube * (1 + .25 * np.sin(4 * a) * np.cos(2 * b))
    p = np.stack([(1 + r * np.cos(b)) * np.cos(a), r * np.sin(b), (1 + r * np.cos(b)) * np.sin(a)], -1)
    return p.reshape(-1, 3), [(i, k, j) for i, j, k in grid(segments, sides, True)]


def ribbon(segments):
    """A ribbon that runs up in a helix around y, bright on its inner side only."""
    t = np.arange(segments + 1) / segments
    a = np.pi - .3 + 3.6 * t
    low = np.stack([np.cos(a), t, np.sin(a)], 1)
    positions = np.stack([low, low + [0, .3, 0]], 1).reshape(-1, 3)
    return positions, [f for i in range(segments) for f in [(2 * i, 2 * i + 2, 2 * i + 1), (2 * i + 1, 2 * i + 2, 2 * i + 3)]]


def mesh(positions, faces, material, normals=None):
    numbers = lambda values: [float(f'{x:.3f}') + 0 for x in np.ravel(values)]
    smooth = {} if normals is None else {'normals': numbers(normals)}
    return {'type': 'mesh', 'positions': numbers(positions), 'indices': [int(i) for i in np.ravel(faces)], **smooth, 'material': material}


def write(name, scene):
    """One line per value or object, numbers without spaces."""
    compact = lambda value: json.dumps(value, separators=(',', ':')).replace('.0,', ',').replace('.0]', ']')
    lines = [f' "{key}": ' + ('[\n  ' + ',\n  '.join(map(compact, value)) + '\n ]' if isinstance(value, list) else compact(value))
             for key, value in scene.items()]
    with open(os.path.join(FOLDER, name), 'w') as file:
        file.write('{\n "$schema": "../../../dist/scene.schema.json",\n' + ',\n'.join(lines) + '\n}\n')


def main():
    positions, normals, faces = knot(200, 20, .17)
    stone, stone_faces = gem()
    write('knot.json', {
        'camera': {'position': [0, 3.2, 4.4], 'target': [0, .75, 0], 'up': [0, 1, 0], 'verticalFov': 36},
        'materials': {
            'floor': {'baseColor': [.6, .6, .6], 'ior': 1},
            'copper': {'baseColor': [.95, .64, .54], 'metallic': 1, 'roughness': .4},
            'plastic': {'baseColor': [.1, .3, .7], 'roughness': .45, 'ior': 1.5},
        },
        'objects': [
            {'type': 'plane', 'point': [0, 0, 0], 'normal': [0, 1, 0], 'material': 'floor'},
            mesh(.6 * positions + [-.35, 1.05, -.2], faces, 'copper', normals),
            mesh(.42 * stone + [1.0, .45, .75], stone_faces, 'plastic'),
        ],
        'lights': [{'type': 'sphere', 'position': [2, 4, 2], 'radius': .5, 'power': [560, 510, 470]}],
        'environment': {'radiance': [.15, .18, .25]},
        'maxBounces': 6,
    })
    donut, donut_faces = ring(24, 10, .35)
    strip, strip_faces = ribbon(24)
    write('glow.json', {
        'camera': {'position': [0, 3.0, 4.6], 'target': [0, .75, 0], 'up': [0, 1, 0], 'verticalFov': 36},
        'materials': {
            'floor': {'baseColor': [.7, .7, .7], 'ior': 1},
            'clay': {'baseColor': [.75, .45, .3], 'ior': 1},
            'metal': {'baseColor': [.9, .9, .85], 'metallic': 1, 'roughness': .4},
            'plastic': {'baseColor': [.15, .5, .2], 'roughness': .5, 'ior': 1.5},
            'warm': {'baseColor': [.3, .3, .3], 'ior': 1, 'emission': [4, 2.8, 1.6]},
            'cold': {'baseColor': [.3, .3, .3], 'ior': 1, 'emission': [1.2, 2, 3.4]},
        },
        'objects': [
            {'type': 'plane', 'point': [0, 0, 0], 'normal': [0, 1, 0], 'material': 'floor'},
            mesh(.45 * donut @ [[1, 0, 0], [0, .8, .6], [0, -.6, .8]] + [0, 1.45, -.1], donut_faces, 'warm'),
            mesh(.55 * strip * [1, 1.2, 1] + [1.05, .08, .3], strip_faces, 'cold'),
            {'type': 'sphere', 'center': [-1.1, .45, .5], 'radius': .44, 'material': 'metal'},
            {'type': 'sphere', 'center': [1.05, .31, .45], 'radius': .3, 'material': 'clay'},
            {'type': 'box', 'center': [-1.35, .41, -1.1], 'size': [.7, .8, .7], 'rotationY': 30, 'material': 'clay'},
            mesh(.35 * stone + [-.1, .38, .95], stone_faces, 'plastic'),
        ],
        'maxBounces': 5,
    })


if __name__ == '__main__':
    main()
