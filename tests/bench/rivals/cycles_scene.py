"""A scene in rt-viewer's format as a Blender scene for Cycles."""
import math

import bpy
from mathutils import Matrix, Vector

WHITE = (1.0, 1.0, 1.0)
PLANE_EXTENT = 1e4  # half the edge of the square that stands for an infinite plane, metres


def build_scene(source: dict):
    """Replaces whatever Blender has loaded by the scene; returns Blender's scene, with no render settings made yet."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    _add_camera(scene, source["camera"])
    _set_environment(scene, source.get("environment", {}).get("radiance", (0, 0, 0)))
    scatters = source.get("maxBounces", 8) > 0
    materials = {name: _material(name, m, scatters) for name, m in source.get("materials", {}).items()}
    for shape in source["objects"]:
        mesh = _add_mesh(scene, *_faces(shape), materials[shape["material"]], is_smooth=shape["type"] == "sphere")
        if shape.get("normals"):
            mesh.normals_split_custom_set_from_vertices(_triples(shape["normals"]))
    for light in source.get("lights", []):
        _add_light(scene, light)
    return scene


def _add_camera(scene, camera: dict) -> None:
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.angle = "VERTICAL", math.radians(camera.get("verticalFov", 45))
    data.clip_start, data.clip_end = 1e-3, 1e7
    position, target = Vector(camera["position"]), Vector(camera.get("target", (0, 0, 0)))
    back = (position - target).normalized()
    right = Vector(camera.get("up", (0, 1, 0))).cross(back).normalized()
    axes = Matrix((right, back.cross(right), back)).transposed()
    node = bpy.data.objects.new("camera", data)
    node.matrix_world = Matrix.Translation(position) @ axes.to_4x4()
    scene.collection.objects.link(node)
    scene.camera = node


def _set_environment(scene, radiance) -> None:
    scene.world = bpy.data.worlds.new("environment")
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (*radiance, 1)


def _material(name: str, source: dict, scatters: bool):
    """`scatters`: False leaves the emission only, for maxBounces 0, which Cycles does not have."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    surface = _scattering(nodes, source).outputs[0] if scatters else None
    if any(source.get("emission", (0, 0, 0))):
        # From the front side only: the other side is black.
        kinds = ("NewGeometry", "Emission", "Emission", "MixShader")
        geometry, emission, black, sides = (nodes.new(f"ShaderNode{kind}") for kind in kinds)
        emission.inputs["Color"].default_value = (*source["emission"], 1)
        black.inputs["Strength"].default_value = 0
        links.new(geometry.outputs["Backfacing"], sides.inputs[0])
        links.new(emission.outputs[0], sides.inputs[1])
        links.new(black.outputs[0], sides.inputs[2])
        material.cycles.emission_sampling = "FRONT"
        if surface is None or not any(source.get("baseColor", WHITE)) and source.get("ior", 1.5) == 1:
            surface = sides.outputs[0]
        else:
            both = nodes.new("ShaderNodeAddShader")
            links.new(surface, both.inputs[0])
            links.new(sides.outputs[0], both.inputs[1])
            surface = both.outputs[0]
    if surface is not None:
        links.new(surface, nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def _scattering(nodes, source: dict):
    """The node that scatters.

    The metal is the format's: GGX, correlated Smith, and F82 with a white tint, which is Schlick. The dielectric has the
    exact Fresnel term where the format has Schlick's, and its diffuse part gets what an albedo table says is left.
    """
    if source.get("masking", "smith") != "smith":
        raise ValueError(f'masking: Cycles has "smith" only, got "{source["masking"]}"')
    colour = (*source.get("baseColor", WHITE), 1)
    metallic, ior = source.get("metallic", 0), source.get("ior", 1.5)
    if metallic == 0 and ior == 1:
        node = nodes.new("ShaderNodeBsdfDiffuse")
        node.inputs["Color"].default_value = colour
        return node
    node = nodes.new("ShaderNodeBsdfPrincipled")
    node.distribution = "MULTI_GGX" if source.get("multiscatter") else "GGX"
    values = {"Base Color": colour, "Metallic": metallic, "Roughness": source.get("roughness", 1), "IOR": ior}
    for name, value in values.items():
        node.inputs[name].default_value = value
    return node


def _add_mesh(scene, vertices, faces, material, is_smooth: bool):
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(vertices, [], faces)
    mesh.polygons.foreach_set("use_smooth", [is_smooth] * len(mesh.polygons))
    mesh.materials.append(material)
    scene.collection.objects.link(bpy.data.objects.new("mesh", mesh))
    return mesh


def _add_light(scene, source: dict) -> None:
    """Blender's point lamp: sampled by solid angle, of radiance power / (4π² radius²) like the format's."""
    radius, power = source.get("radius", 0), source["power"]
    data = bpy.data.lights.new("light", "POINT")
    data.energy = max(power)
    data.color = [watts / max(data.energy, 1e-30) for watts in power]
    data.shadow_soft_size, data.use_soft_falloff = radius, False
    lamp = bpy.data.objects.new("light", data)
    lamp.location = source["position"]
    scene.collection.objects.link(lamp)
    if radius > 0:
        # Light passes through a lamp, so a black ball inside stops it.
        black = bpy.data.materials.get("black") or _material("black", {"baseColor": (0, 0, 0), "ior": 1}, True)
        _add_mesh(scene, *_sphere(source["position"], radius * 0.999), black, is_smooth=True)


def _faces(shape: dict):
    """Vertices and faces of an object, counter-clockwise seen from its front."""
    match shape["type"]:
        case "sphere":
            return _sphere(shape["center"], shape["radius"])
        case "plane":
            normal = Vector(shape["normal"]).normalized()
            u = normal.orthogonal().normalized() * PLANE_EXTENT
            v = normal.cross(u)
            return _quad(Vector(shape["point"]) - u - v, 2 * u, 2 * v)
        case "quad":
            return _quad(*(Vector(shape[key]) for key in ("corner", "edge1", "edge2")))
        case "triangle":
            return shape["vertices"], [(0, 1, 2)]
        case "box":
            return _box(shape)
        case "mesh":
            return _triples(shape["positions"]), _triples(shape["indices"])
        case other:
            raise ValueError(f"cannot convert an object of type {other}")


def _triples(values) -> list[tuple]:
    return [tuple(values[i : i + 3]) for i in range(0, len(values), 3)]


def _quad(corner, edge1, edge2):
    return [corner, corner + edge1, corner + edge1 + edge2, corner + edge2], [(0, 1, 2, 3)]


def _box(shape: dict):
    turn = Matrix.Rotation(math.radians(shape.get("rotationY", 0)), 3, "Y")
    half = [edge / 2 for edge in shape["size"]]
    vertices = [
        Vector(shape["center"]) + turn @ Vector((x * half[0], y * half[1], z * half[2]))
        for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)
    ]
    return vertices, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def _sphere(center, radius: float, segments: int = 256, rings: int = 128):
    """Cycles' only exact spheres are points of a cloud, which Python cannot make; this one is off by 8e-5 of its radius."""
    c, vertices, faces = Vector(center), [], []
    for j in range(1, rings):
        theta = math.pi * j / rings
        for i in range(segments):
            phi = 2 * math.pi * i / segments
            x, y, z = math.sin(theta) * math.sin(phi), math.cos(theta), math.sin(theta) * math.cos(phi)
            vertices.append(c + radius * Vector((x, y, z)))

    def at(j, i):
        return j * segments + i % segments

    for j in range(rings - 2):
        faces += [(at(j, i), at(j + 1, i), at(j + 1, i + 1), at(j, i + 1)) for i in range(segments)]
    top, bottom = len(vertices), len(vertices) + 1
    vertices += [c + Vector((0, radius, 0)), c - Vector((0, radius, 0))]
    for i in range(segments):
        faces += [(top, at(0, i), at(0, i + 1)), (bottom, at(rings - 2, i + 1), at(rings - 2, i))]
    return vertices, faces
