"""Mitsuba 3 (https://mitsuba-renderer.org, pip install mitsuba numpy) on the CPU, as one of the benchmark's rivals.

See protocol.py for the command line. The scene is converted by tests/reference/render_mitsuba.py, so this is the renderer
of the references, with its better samplers and its own Russian roulette. Metals and coated dielectrics are that script's
glTF material, which Dr.Jit traces into the same machine code as a built-in one.
"""
import importlib.util, os, sys, time

sys.dont_write_bytecode = True  # the repository stays as it is
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import protocol

# The wheel has no variant without derivatives, but a render that nobody differentiates records none.
VARIANT = "llvm_ad_rgb"
SAMPLERS = ("independent", "stratified", "multijitter", "orthogonal", "ldsampler")


def reference():
    """tests/reference/render_mitsuba.py; importing it chooses the variant."""
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "reference"))
    import render_mitsuba

    return render_mitsuba


def is_ready() -> bool:
    if not all(importlib.util.find_spec(name) for name in ("mitsuba", "numpy")):
        return False
    import mitsuba as mi

    reference()
    return mi.variant() == VARIANT  # without an LLVM it is the scalar variant, which is no rival


def main() -> None:
    # multijitter has the least error for its time in most of our scenes; ldsampler wins in veach, but its pixels err alike.
    args = protocol.arguments(is_ready, {"flag": "--sampler", "choices": SAMPLERS, "default": "multijitter"})
    import drjit as dr
    import mitsuba as mi
    import numpy as np

    start = time.perf_counter()
    scene = reference().load(args.scene, [args.width, args.height], sampler=args.sampler)
    max_depth = args.scene.get("maxBounces", 8) + 1  # Mitsuba counts the segments of a path: one more than it scatters
    integrator = mi.load_dict({"type": "path", "max_depth": max_depth})  # with its own roulette, from the fifth segment

    def render(samples: int, seed: int) -> np.ndarray:
        return np.array(mi.render(scene, integrator=integrator, spp=samples, seed=seed))

    # A first render of each count compiles its kernel (or loads it from Dr.Jit's cache on disk) and sizes its memory. One of
    # them is the set-up.
    render(1, args.seed + 1)
    dr.sync_thread()
    protocol.report_setup(f"Mitsuba {mi.__version__} ({mi.variant()}, {args.sampler})", time.perf_counter() - start)
    for samples in args.counts:
        render(samples, args.seed + 1)
    dr.sync_thread()

    for samples in args.counts:
        start = time.perf_counter()
        image = render(samples, args.seed)
        seconds = time.perf_counter() - start
        # Stratified samplers round up, to a square for instance.
        sampler = scene.sensors()[0].sampler().clone()
        sampler.set_sample_count(samples)
        protocol.report_image(args, sampler.sample_count(), seconds, image)


if __name__ == "__main__":
    main()
