"""Reads two maps as ROS map servers do, with PyYAML and numpy, and compares them: how alike they are as JSON."""

import json
import sys
from pathlib import Path

try:
    import numpy as np
    import yaml
except ImportError as e:
    sys.exit(f"this test needs {e.name}: python3 -m pip install numpy PyYAML")


def picture(path):
    magic, size, depth, cells = path.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    assert (magic, depth, len(cells)) == (b"P5", b"255", width * height), path
    return np.frombuffer(cells, np.uint8).reshape(height, width)


def read(path):
    keys = yaml.safe_load(path.read_text())
    greys = picture(path.parent / keys["image"])
    occupancy = (255 - greys.astype(float)) / 255
    cells = np.full(greys.shape, -1)
    cells[occupancy > keys["occupied_thresh"]] = 100
    cells[occupancy < keys["free_thresh"]] = 0
    return keys, greys, cells


def overlap(a, b):
    return (a & b).sum() / (a | b).sum()


first, second = map(Path, sys.argv[1:3])
(mine, greys, cells), (theirs, _, input_cells) = read(first), read(second)
frame = ["resolution", "origin"]
same_frame = cells.shape == input_cells.shape and all(mine[k] == theirs[k] for k in frame)
report = {
    "keys": mine,
    "greys": sorted(int(g) for g in np.unique(greys)),
    "same_frame": same_frame,
    "free": float(overlap(cells == 0, input_cells == 0)) if same_frame else 0.0,
    "walls_on_walls": float((input_cells[cells == 100] != 0).mean()) if same_frame else 0.0,
}
print(json.dumps(report))
