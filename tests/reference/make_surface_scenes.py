"""Writes scenes/glass.json, cutouts.json and textured.json: the reference scenes of what light passes, and of textures.

Usage: python make_surface_scenes.py
"""
import numpy as np

from make_mesh_scenes import TAU, mesh, write

LAMBERT = {'ior': 1}


def tiles(half, count, materials):
    """A square floor of `count`² quads, seen from above."""
    side = 2 * half / count
    return [{'type': 'quad', 'corner': [round(i * side - half, 3), 0, round((j + 1) * side - half, 3)], 'edge1': [side, 0, 0],
             'edge2': [0, 0, -side], 'material': materials[(i + 2 * (j % 2)) % len(materials)]} for j in range(count) for i in range(count)]


def lamp(centre, size):
    """Shines down."""
    x, y, z = centre
    return {'type': 'quad', 'corner': [round(x - size / 2, 3), y, round(z - size / 2, 3)], 'edge1': [size, 0, 0], 'edge2': [0, 0, size], 'material': 'lamp'}


def sheet(corner, edge1, edge2, repeats, material):
    """A rectangle as a mesh; its texture stands upright if edge2 points up."""
    c, a, b = (np.array(v, float) for v in (corner, edge1, edge2))
    u, v = repeats
    return {**mesh([c, c + a, c + a + b, c + b], [(0, 1, 2), (0, 2, 3)], material), 'uvs': [0, v, u, v, u, 0, 0, 0]}


def picture(size, texel, **more):
    """`texel(x, y)`: red, green, blue, alpha, from 0 to 255; y from the top."""
    return {'width': size, 'height': size, 'texels': [int(c) for y in range(size) for x in range(size) for c in texel(x, y)], **more}


def glass():
    solid = {'roughness': 0, 'transmission': 1, 'thickness': 1}
    write('glass.json', {
        'camera': {'position': [0, 3.3, 4.4], 'target': [0, .35, .05], 'up': [0, 1, 0], 'verticalFov': 40},
        'materials': {
            'sand': {**LAMBERT, 'baseColor': [.8, .75, .6]},
            'brick': {**LAMBERT, 'baseColor': [.6, .2, .12]},
            'slate': {**LAMBERT, 'baseColor': [.15, .25, .4]},
            'moss': {**LAMBERT, 'baseColor': [.3, .5, .15]},
            'clay': {**LAMBERT, 'baseColor': [.85, .45, .3]},
            'lamp': {**LAMBERT, 'baseColor': [0, 0, 0], 'emission': [5, 4.6, 4]},
            'green': {**solid, 'attenuationColor': [.35, .85, .5], 'attenuationDistance': .5},
            'amber': {**solid, 'roughness': .3, 'attenuationColor': [.95, .7, .25], 'attenuationDistance': .6},
            'frosted': {**solid, 'roughness': .6, 'attenuationColor': [.5, .7, .95], 'attenuationDistance': .8},
            'rose': {**solid, 'attenuationColor': [.9, .4, .5], 'attenuationDistance': .4},
            'clear': solid,
            'core': {**solid, 'ior': 1.2, 'attenuationColor': [.2, .5, .9], 'attenuationDistance': .4},
        },
        'objects': [
            *tiles(2.2, 4, ['sand', 'brick', 'slate', 'moss']),
            lamp([-.6, 3.2, -.4], 2.4),
            {'type': 'sphere', 'center': [-1.15, .51, .7], 'radius': .5, 'material': 'green'},
            {'type': 'sphere', 'center': [0, .51, 1.05], 'radius': .5, 'material': 'amber'},
            {'type': 'box', 'center': [-.7, .46, -.65], 'size': [.9, .9, .9], 'rotationY': 25, 'material': 'frosted'},
            {'type': 'sphere', 'center': [.75, .66, -.7], 'radius': .65, 'material': 'rose'},
            {'type': 'sphere', 'center': [.85, .56, -.55], 'radius': .3, 'material': 'clay'},
            {'type': 'sphere', 'center': [1.2, .51, .65], 'radius': .5, 'material': 'clear'},
            {'type': 'sphere', 'center': [1.15, .49, .7], 'radius': .28, 'material': 'core'},
        ],
        'environment': {'radiance': [.4, .45, .5]},
        'maxBounces': 12,
    })


def cutouts():
    def leaf(x, y):
        """A ring with a bar to its right and a dot: no mirror image of it is itself. Its alpha is around the mask's cutoff."""
        r = np.hypot(x - 3, y - 4)
        there = 1.5 <= r < 3.3 or (x >= 6 and y in (4, 5)) or (x, y) == (1, 0)
        return [60 + 20 * x, 180 - 12 * y, 50, (255 if x % 2 else 178) if there else (0 if y % 2 else 168)]

    write('cutouts.json', {
        'camera': {'position': [.3, 2.6, 4.6], 'target': [0, 1, 0], 'up': [0, 1, 0], 'verticalFov': 36},
        'materials': {
            'floor': {**LAMBERT, 'baseColor': [.7, .68, .62]},
            'wall': {**LAMBERT, 'baseColor': [.55, .6, .7]},
            'clay': {**LAMBERT, 'baseColor': [.8, .35, .2]},
            'lamp': {**LAMBERT, 'baseColor': [0, 0, 0], 'emission': [14, 12.5, 10]},
            # 178 of 255 is there, 168 is not.
            'leaf': {'roughness': .5, 'baseColor': [.9, 1, .8], 'baseColorTexture': 'leaf', 'alpha': .9, 'alphaMode': 'mask', 'alphaCutoff': .61},
            'awning': {**LAMBERT, 'baseColor': [.8, .75, .3], 'baseColorTexture': 'leaf', 'alphaMode': 'mask', 'alphaCutoff': .68},
            'veil': {**LAMBERT, 'baseColor': [.3, .5, .9], 'alpha': .25, 'alphaMode': 'blend'},
            'ghost': {'roughness': .4, 'metallic': 1, 'baseColor': [.9, .7, .5], 'alpha': .5, 'alphaMode': 'blend'},
            'fade': {**LAMBERT, 'baseColorTexture': 'fade', 'alphaMode': 'blend'},
            'absent': {**LAMBERT, 'alpha': .4, 'alphaMode': 'mask'},
        },
        'textures': {
            'leaf': picture(8, leaf, filter='nearest'),
            'fade': picture(4, lambda x, y: [230, 60 * x + 40, 200 - 50 * y, [0, 90, 180, 255][x]], wrapU='clamp', wrapV='clamp'),
        },
        'objects': [
            {'type': 'quad', 'corner': [-3, 0, 3], 'edge1': [6, 0, 0], 'edge2': [0, 0, -4.2], 'material': 'floor'},
            {'type': 'quad', 'corner': [-3, 0, -1.2], 'edge1': [6, 0, 0], 'edge2': [0, 3.6, 0], 'material': 'wall'},
            lamp([.2, 3.4, 1.2], 1),
            sheet([-1.5, .1, .4], [1.3, 0, -.5], [0, 1.3, 0], (2, 2), 'leaf'),
            sheet([-.7, 1.75, .7], [1.7, .1, 0], [0, .3, -1.4], (1.5, 1.5), 'awning'),
            sheet([.1, .02, -.5], [1, 0, .3], [0, 1.4, 0], (1, 1), 'fade'),
            {'type': 'quad', 'corner': [.2, .05, 1.1], 'edge1': [1.3, 0, -.2], 'edge2': [0, .9, .1], 'material': 'veil'},
            {'type': 'quad', 'corner': [.6, .05, 1.3], 'edge1': [1.1, 0, -.1], 'edge2': [0, 1.2, 0], 'material': 'veil'},
            {'type': 'sphere', 'center': [-.55, .5, .9], 'radius': .42, 'material': 'ghost'},
            {'type': 'sphere', 'center': [1.15, .42, .35], 'radius': .4, 'material': 'clay'},
            {'type': 'box', 'center': [-1.1, .45, -.55], 'size': [.6, .9, .5], 'rotationY': 20, 'material': 'clay'},
            {'type': 'sphere', 'center': [.2, 1.6, 1], 'radius': .5, 'material': 'absent'},
        ],
        'environment': {'radiance': [.12, .14, .18]},
        'maxBounces': 5,
    })


def gourd(rows, columns):
    """A body around y, of unit height and closed above, with its normals; u runs around it, v down. A seam where u starts anew."""
    t = np.arange(1, rows + 1) / rows
    radius = lambda t: np.sqrt(t) * (.34 - .25 * t + .55 * t ** 2 - .3 * t ** 3) * (1.2 + .4 * np.sin(5.2 * t))
    profile = lambda t: np.stack([radius(t), 1 - t ** 1.5], -1)
    slope = profile(t + 1e-5) - profile(t - 1e-5)
    a = TAU * np.arange(columns + 1) / columns
    ring = lambda r, y: np.stack([r[:, None] * np.cos(a), np.broadcast_to(y[:, None], (len(r), len(a))), -r[:, None] * np.sin(a)], -1)
    body, normals = ring(*profile(t).T), ring(-slope[:, 1], slope[:, 0])
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    uvs = np.stack(np.broadcast_arrays(2 * np.arange(columns + 1) / columns, 1.5 * t[:, None]), -1)
    # The pole is a vertex in each column.
    pole = np.broadcast_to([0, 1, 0], (1, columns + 1, 3))
    pole_uvs = np.stack([(2 * np.arange(columns + 1) + 1) / columns, np.zeros(columns + 1)], -1)[None]
    at = lambda i, j: i * (columns + 1) + j
    faces = [(at(0, j), at(1, j), at(1, j + 1)) for j in range(columns)]
    faces += [f for i in range(1, rows) for j in range(columns) for f in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))]
    flat = lambda a, b, n: np.concatenate([a, b]).reshape(-1, n)
    return flat(pole, body, 3), faces, flat(pole, normals, 3), flat(pole_uvs, uvs, 2)


def textured():
    positions, faces, normals, uvs = gourd(28, 40)
    glaze = lambda x, y: [110 + 100 * np.sin(TAU * (x + y) / 16), 60 + 12 * y, 250 - 14 * x if (x - 5) ** 2 + (y - 6) ** 2 < 14 else 70, 255]
    write('textured.json', {
        'camera': {'position': [0, 2.5, 4.2], 'target': [0, .75, 0], 'up': [0, 1, 0], 'verticalFov': 36},
        'materials': {
            'gourd': {'baseColor': [.95, .9, .8], 'baseColorTexture': 'glaze', 'roughness': .4, 'metallic': .5},
            'floor': {**LAMBERT, 'baseColor': [.8, .8, .8], 'baseColorTexture': 'carpet'},
            'panel': {'baseColor': [.8, .9, 1], 'baseColorTexture': 'flag', 'roughness': .3},
        },
        'textures': {
            'glaze': picture(16, glaze),
            'carpet': picture(4, lambda x, y: [40 + 60 * x, 220 - 50 * y, 255 if x == y else 30, 255], wrapU='mirror', wrapV='mirror'),
            'flag': picture(4, lambda x, y: [255 if y < 2 else 60, 70 * x + 30, 240 if x + y == 3 else 90, 255], wrapU='clamp', wrapV='clamp', filter='nearest'),
        },
        'objects': [
            sheet([-3, 0, 2], [6, 0, 0], [0, 0, -5], (4.6, 3.8), 'floor'),
            {**mesh(1.5 * positions + [-.35, 0, .1], faces, 'gourd', normals), 'uvs': [float(f'{x:.4f}') + 0 for x in uvs.ravel()]},
            {**sheet([.5, .05, -.4], [1.1, 0, .5], [0, 1.3, -.1], (1, 1), 'panel'), 'uvs': [-.25, 1.25, 1.25, 1.25, 1.25, -.25, -.25, -.25]},
        ],
        'lights': [{'type': 'sphere', 'position': [2, 4, 2], 'radius': .5, 'power': [560, 510, 470]}],
        'environment': {'radiance': [.15, .18, .25]},
        'maxBounces': 5,
    })


def main():
    glass()
    cutouts()
    textured()


if __name__ == '__main__':
    main()
