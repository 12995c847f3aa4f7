"""Holds planform's time against that of OpenCV on the same maps, in the same run: scripts/speed [OPTION]... [MAP...]

Of OpenCV that part is run, with one thread, with which the paper that `--method paper` follows begins: reading the picture,
Canny's edges, Hough's segments, contours. Its import is not counted. Of planform the whole process is counted, from the map to
a GeoJSON, on one thread and on two. Each round runs the three one after the other on every map; the best round counts.

Maps are pictures: PGM, PNG or what else both read. Without any, maps of made-up buildings are measured.
"""

import argparse
import json
import math
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import cv2

import speed_page

ROOT = Path(__file__).resolve().parent.parent
BUILDINGS = [(size, seed) for size in ("house", "office", "school") for seed in (1, 2, 3)]
# How often it is timed how long planform takes to say its version.
STARTS = 20


def build():
    """Compiles planform and the maker of buildings, and returns these programs."""
    cargo = ["cargo", "build", "--release", "--message-format", "json-render-diagnostics"]
    packages = ["-p", "planform", "-p", "planform-synth", "--bins"]
    done = subprocess.run(cargo + packages, cwd=ROOT, stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit("error: planform does not compile")
    messages = [json.loads(line) for line in done.stdout.splitlines()]
    made = {Path(m["executable"]).stem: m["executable"] for m in messages if m.get("executable")}
    return made["planform"], made["planform-synth"]


def made_up(synth):
    """The maps of some buildings of each size."""
    for size, seed in BUILDINGS:
        folder = ROOT / "target" / "speed-maps" / f"{size}-{seed}"
        command = [synth, "--size", size, "--seed", str(seed), "--out", folder]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        yield folder / "map.pgm"


def megapixels(path):
    if not path.is_file():
        sys.exit(f"error: {path}: no such file")
    picture = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
    if picture is None:
        sys.exit(f"error: {path}: OpenCV cannot read it; give a map's picture, such as a PGM or a PNG")
    return picture.size / 1e6


def opencv(path):
    """Seconds that OpenCV takes."""
    start = time.perf_counter()
    grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
    edges = cv2.Canny(grey, 90, 100, apertureSize=5)
    cv2.HoughLinesP(edges, 1, math.pi / 180, 20, minLineLength=7, maxLineGap=3)
    _, free = cv2.threshold(grey, 150, 255, cv2.THRESH_BINARY)
    cv2.findContours(free, cv2.RETR_TREE, cv2.CHAIN_APPROX_SIMPLE)
    return time.perf_counter() - start


def run(command):
    """Seconds that the program takes, and what it says."""
    start = time.perf_counter()
    done = subprocess.run(command, capture_output=True, text=True)
    took = time.perf_counter() - start
    if done.returncode != 0:
        sys.exit(done.stderr.strip())
    return took, done.stderr


def convert(planform, path, out, threads, voice="-q"):
    return run([planform, "convert", path, "-o", out, "--force", voice, "--threads", str(threads)])


def compare(planform, maps, rounds, out):
    """For each map its name, its megapixels and the least seconds of OpenCV and of planform on one thread and on two."""
    sizes = [megapixels(path) for path in maps]
    opencv(maps[0])
    times = [[] for _ in maps]
    for _ in range(rounds):
        for path, found in zip(maps, times):
            found.append([opencv(path), *(convert(planform, path, out, n)[0] for n in (1, 2))])
    names = ["/".join(path.parts[-2:]) for path in maps]
    return [(name, size, *map(min, zip(*found))) for name, size, found in zip(names, sizes, times)]


def steps(planform, path, rounds, out):
    """The steps of the quickest run on one thread, each with its seconds, and what remains of the whole."""
    whole, told = min(convert(planform, path, out, 1, "-v") for _ in range(rounds))
    found = [(name, float(seconds)) for name, seconds in re.findall(r"^(\w+) +(\d+\.\d+) s$", told, re.M)]
    return [*found, ("start, telling the format, saving the file", whole - sum(seconds for _, seconds in found))]


def typical(compared):
    """The number of the map of median size."""
    size = statistics.median_low(row[1] for row in compared)
    return next(i for i, row in enumerate(compared) if row[1] == size)


def bench(rounds):
    """The tables of the bench `speed`."""
    command = ["cargo", "bench", "--bench", "speed", "--", "--runs", str(rounds)]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit("error: `cargo bench --bench speed` failed")
    return done.stdout


def arguments():
    parser = argparse.ArgumentParser(
        prog="scripts/speed", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("maps", nargs="*", type=Path, metavar="MAP")
    parser.add_argument("--runs", type=int, default=5, metavar="N", help="rounds, and runs of the bench; 5 without this")
    parser.add_argument("--write", action="store_true", help="also run the bench `speed`, and write docs/performance.md")
    args = parser.parse_args()
    if args.runs < 1:
        parser.error("--runs is how often each is run: 1 or more")
    return args


def main():
    args = arguments()
    cv2.setNumThreads(1)
    planform, synth = build()
    maps = [path.resolve() for path in args.maps] or list(made_up(synth))
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "rooms.geojson"
        compared = compare(planform, maps, args.runs, out)
        chosen = typical(compared)
        shares = steps(planform, maps[chosen], args.runs, out)
    start = min(run([planform, "--version"])[0] for _ in range(STARTS))
    size = Path(planform).stat().st_size
    texts = {
        "compared": speed_page.compared(compared, args.runs, cv2.__version__),
        "steps": speed_page.steps(compared[chosen], shares),
        "program": speed_page.program(start, size),
    }
    print("\n\n".join(texts.values()))
    if args.write:
        speed_page.write({**texts, "bench": bench(args.runs)}, compared)


main()
