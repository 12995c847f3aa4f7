#!/usr/bin/env python3
"""Holds the accuracy floor on real maps with ground truth, and checks our `evaluate` against an independent scorer.

    accuracy.py DATA SCORER PLANFORM

DATA is a folder of map sets, each with a `manifest.json`; SCORER a Python program that takes the same manifests;
PLANFORM the program to be tested. Every map of every set has to convert. Fails with status 1 when a floor is broken
or the two scorers differ by more than TOLERANCE.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

# Method, set, key of the map in the manifest, least means. What has no floor only has to convert, and both scorers have
# to agree on it.
SETS = [
    ("basins", "bormann", "map", {"A_FC": 0.97, "A_BC": 0.965, "P": 0.98, "R": 0.98, "mIoU": 0.93}),
    ("basins", "bormann", "map_furnished", {"A_FC": 0.955, "A_BC": 0.95, "P": 0.97, "R": 0.97, "mIoU": 0.90}),
    ("basins", "school", "map", {"A_FC": 0.955, "A_BC": 0.945, "P": 0.915, "R": 0.915}),
    ("basins", "school_lowres", "map", {"A_FC": 0.93, "A_BC": 0.90}),
    ("basins", "school_rotated", "map", {}),
    ("basins", "real", "map", {"A_FC": 0.89, "A_BC": 0.77, "P": 0.93, "R": 0.80}),
    ("basins", "partial", "map", {}),
    ("basins", "ros", "map", {}),
    ("basins", "blueprints", "map", {"A_FC": 0.80, "A_BC": 0.795}),
    ("paper", "bormann", "map", {"P": 0.90, "R": 0.92}),
    ("paper", "bormann", "map_furnished", {"P": 0.88, "R": 0.90}),
]
TOLERANCE = 0.005
MEASURES = ("A_FC", "A_BC", "P", "R", "mIoU")


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nfailed with status {done.returncode}:\n{done.stderr}")


def convert(planform, method, folder, entry, document, out):
    command = [planform, "convert", folder / document, "-o", out, "--method", method, "--quiet"]
    command += ["--set", "boundary=centre"]
    if "resolution" in entry and not document.endswith(".yaml"):
        command += ["--resolution", entry["resolution"]]
    run(*command)


def documents(entry):
    """The other maps of the same building: without some rooms, with a YAML, furnished."""
    return [v for k, v in entry.items() if k == "yaml" or (k.startswith("map_") and isinstance(v, str))]


def mean(scores, measure):
    values = [s["clipped"][measure] for s in scores.values()]
    return sum(values) / len(values)


def compare(ours, theirs):
    """The largest difference between two scorers over all maps and measures."""
    if ours.keys() != theirs.keys():
        sys.exit(f"the scorers see different maps: {sorted(ours)} and {sorted(theirs)}")
    sides = [(ours[m][k], theirs[m][k]) for m in ours for k in ("clipped", "raw")]
    return max(abs(a[x] - b[x]) for a, b in sides for x in MEASURES)


def score(planform, scorer, manifest, predictions):
    """The scores of all maps, by planform and by the independent scorer."""
    ours, theirs = predictions / "ours.json", predictions / "theirs.json"
    run(planform, "evaluate", "--manifest", manifest, "--predictions", predictions, "--json", ours)
    run(sys.executable, scorer, "--manifest", manifest, "--pred-dir", predictions, "--units", "m", "--json", theirs)
    return (json.loads(path.read_text())["maps"] for path in (ours, theirs))


def hold(planform, scorer, method, folder, key, floors):
    """Converts and scores one set; returns what is wrong with it."""
    manifest = folder / "manifest.json"
    maps = json.loads(manifest.read_text())["maps"]
    title = f"{method:7} {folder.name:15} {key:14} {len(maps):3} maps"
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)
        for entry in maps:
            convert(planform, method, folder, entry, entry[key], scratch / f"{entry['name']}.geojson")
            for i, document in enumerate(documents(entry) if key == "map" else []):
                convert(planform, method, folder, entry, document, scratch / f"{entry['name']}.{i}.geojson")
        if not any("gt" in entry for entry in maps):
            print(f"{title}  converted; no truth to compare with")
            return []
        ours, theirs = score(planform, scorer, manifest, scratch)
    apart = compare(ours, theirs)
    means = {m: mean(theirs, m) for m in MEASURES}
    shown = "  ".join(f"{m} {100 * v:5.1f}" for m, v in means.items())
    print(f"{title}  {shown}  scorers differ by {apart:.1e}")
    wrong = [f"{title}: the scorers differ by {apart}"] if apart > TOLERANCE else []
    low = [m for m, floor in floors.items() if means[m] < floor]
    return wrong + [f"{title}: {m} is {means[m]:.4f}, the floor is {floors[m]}" for m in low]


def main():
    data, scorer, planform = (Path(a).resolve() for a in sys.argv[1:4])
    wrong = [w for method, name, key, floors in SETS for w in hold(planform, scorer, method, data / name, key, floors)]
    sys.exit("\n".join(wrong) if wrong else 0)


main()
