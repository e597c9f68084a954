"""Blender's Cycles (https://www.cycles-renderer.org, pip install bpy, Python 3.11 for Blender 4.5) on the CPU, as a rival.

See protocol.py for the command line, cycles_scene.py for the scene and where its physics differs from the format's.

What is timed: one call of Blender's render operator with persistent data, so that the scene and its acceleration structure
stay from the first render, which counts as setup. Blender's own work around a render (the dependency graph, handing the
pixels over) cannot be taken out; it is within what one sample per pixel takes, 4 to 27 ms at 128 × 128 on two cores.
"""
import importlib.util, os, sys, tempfile, time

sys.dont_write_bytecode = True  # the repository stays as it is
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import protocol


def is_ready() -> bool:
    return all(importlib.util.find_spec(name) is not None for name in ("bpy", "numpy"))


def configure(scene, width: int, height: int, max_bounces: int) -> None:
    """Unclamped, undenoised radiance through a box filter; but for the light tree, sampling is as Blender sets it."""
    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100
    render.use_persistent_data = True
    render.use_compositing = render.use_sequencer = False
    render.threads_mode, render.threads = "FIXED", protocol.threads()
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    render.image_settings.exr_codec = "NONE"
    scene.view_settings.view_transform = "Raw"
    cycles.device = "CPU"
    cycles.use_denoising = cycles.use_adaptive_sampling = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1
    cycles.film_exposure = 1
    cycles.use_light_tree = False  # it pays with many lights; with our few it costs a fifth to a third of the speed
    # Cycles counts what comes after direct light: with 0 a path still scatters once.
    bounces = max(max_bounces - 1, 0)
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = bounces


def render(scene, samples: int, seed: int) -> float:
    """Renders into Blender's result and returns the seconds it took."""
    import bpy

    scene.cycles.samples, scene.cycles.seed = samples, seed
    scene.update_tag()  # or persistent data keeps the values of the last render
    start = time.perf_counter()
    bpy.ops.render.render()
    return time.perf_counter() - start


def result(width: int, height: int):
    """The rendered radiance; Blender hands its pixels out through a file only."""
    import bpy
    import numpy as np

    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "render.exr")
        bpy.data.images["Render Result"].save_render(file)
        image = bpy.data.images.load(file)
        pixels = np.empty(width * height * 4, np.float32)
        image.pixels.foreach_get(pixels)
        bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)[::-1, :, :3]


def main() -> None:
    args = protocol.arguments(is_ready)
    import bpy
    from cycles_scene import build_scene

    start = time.perf_counter()
    scene = build_scene(args.scene)
    configure(scene, args.width, args.height, args.scene.get("maxBounces", 8))
    render(scene, 1, args.seed + 1)
    protocol.report_setup(f"Cycles {bpy.app.version_string} (CPU)", time.perf_counter() - start)
    for samples in args.counts:
        seconds = render(scene, samples, args.seed)
        protocol.report_image(args, samples, seconds, result(args.width, args.height))


if __name__ == "__main__":
    main()
