"""Embree (https://www.embree.org, pip install embreex) on the same rays, one thread.

Usage: python embree_rays.py VERTICES TRIANGLES RAYS OUT
Raw files: float32 x, y, z per vertex; uint32, three per triangle; float32, origin and direction per ray. OUT: float32, the distance
to the closest hit per ray, 1e37 for none.
stdout: {"renderer": NAME, "buildSeconds": n, "seconds": n}
"""
import json, sys, time
from importlib.metadata import version

import numpy
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene

RUNS = 3


def main() -> None:
    vertices, triangles, rays, out = sys.argv[1:]
    positions = numpy.fromfile(vertices, numpy.float32).reshape(-1, 3)
    indices = numpy.fromfile(triangles, numpy.uint32).reshape(-1, 3).astype(numpy.int32)
    segments = numpy.fromfile(rays, numpy.float32).reshape(-1, 6)
    origins, directions = (numpy.ascontiguousarray(part) for part in (segments[:, :3], segments[:, 3:]))

    scene = EmbreeScene()
    TriangleMesh(scene, positions, indices)
    start = time.perf_counter()
    scene.run(origins[:1], directions[:1], query="DISTANCE")  # the first query builds
    build_seconds = time.perf_counter() - start
    seconds = []
    for _ in range(RUNS):
        start = time.perf_counter()
        distances = scene.run(origins, directions, query="DISTANCE")
        seconds.append(time.perf_counter() - start)
    numpy.asarray(distances, numpy.float32).tofile(out)
    print(json.dumps({"renderer": f"Embree, embreex {version('embreex')}", "buildSeconds": build_seconds, "seconds": min(seconds)}))


main()
