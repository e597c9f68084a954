"""How a renderer written in Python talks to the benchmark: a scene in, JSON lines on stdout and images in files out.

Usage: python RIVAL.py SCENE.json --size 256 --samples 16,64 --seed 1 --out DIR
       python RIVAL.py --check     exits 0 where this Python has what the renderer needs, else 1

stdout: {"renderer": NAME, "setupSeconds": n, "threads": n}, then by rising sample count, a line for each,
{"samples": n, "seconds": s, "file": PATH}.
An image is raw float32, little endian, RGB, top row first: linear Rec. 709 radiance.

Import this before the renderer: from here on, whatever else writes to stdout, native code included, lands on stderr.
"""
import argparse, json, os, sys
from typing import Any, Callable

_lines = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)


def threads() -> int:
    """The cores this process may use; fewer than the machine's inside a container or under taskset."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def arguments(is_ready: Callable[[], bool], *options: dict[str, Any]) -> argparse.Namespace:
    """Reads the command line: `scene` (parsed), `width`, `height`, `counts`, `seed`, `out`, and the renderer's own options.

    With --check it leaves the process here, with the answer of `is_ready` as its status.
    """
    parser = argparse.ArgumentParser()
    parser.add_argument("scene", nargs="?")
    parser.add_argument("--size", default="256", help="256 or 256x128")
    parser.add_argument("--samples", default="16,64")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", default=".")
    parser.add_argument("--check", action="store_true")
    for option in options:
        parser.add_argument(option.pop("flag"), **option)
    args = parser.parse_args()
    if args.check:
        sys.exit(0 if is_ready() else 1)
    if args.scene is None:
        parser.error("expected a scene file")
    args.name = os.path.splitext(os.path.basename(args.scene))[0]
    with open(args.scene) as file:
        args.scene = json.load(file)
    size = [int(edge) for edge in args.size.split("x")]
    args.width, args.height = size[0], size[-1]
    args.counts = sorted(int(count) for count in args.samples.split(","))
    os.makedirs(args.out, exist_ok=True)
    return args


def report_setup(renderer: str, seconds: float) -> None:
    """The first line of the answer. `seconds`: everything before the first timed sample."""
    _report({"renderer": renderer, "setupSeconds": seconds, "threads": threads()})


def report_image(args: argparse.Namespace, samples: int, seconds: float, image: Any) -> None:
    """One timed image, a height × width × 3 array. `samples`: per pixel, as rendered, which may be more than was asked."""
    assert image.shape == (args.height, args.width, 3), image.shape
    file = os.path.abspath(os.path.join(args.out, f"{args.name}.{samples}.f32"))
    image.astype("<f4").tofile(file)
    _report({"samples": samples, "seconds": seconds, "file": file})


def _report(line: dict[str, Any]) -> None:
    print(json.dumps(line), file=_lines, flush=True)
