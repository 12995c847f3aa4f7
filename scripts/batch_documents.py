"""Makes the documents of scripts/batch-1000: batch_documents.py SYNTH FOLDER COUNT

Of the COUNT documents 5 % are broken, 5 hang and 5 take all memory; of the others one in forty is a drawn plan, one in ten a
laser log, and the rest are robots' maps. Each kind has a few that differ; the others are these under other names, with a pixel,
a line or a comment changed so that no two are the same.
"""

import math
import random
import shutil
import subprocess
import sys
from pathlib import Path

synth, folder, count = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3])
rng = random.Random(8)
scratch = folder / ".originals"
MAPS, PLANS, LOGS = 24, 4, 6


def write(path, data):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


def drawn(seed, *arguments):
    out = scratch / str(seed)
    subprocess.run([synth, "--seed", str(seed), "--out", out, *arguments], check=True, capture_output=True)
    return out


def log(seed):
    """A laser that drives and turns in a room of its own size."""
    width, height = 3 + seed % 4, 4 + seed % 3
    lines = []
    for i in range(60):
        heading, x, y = i * 0.1, math.cos(i / 10) * 0.4, math.sin(i / 10) * 0.4

        def reach(angle):
            c, s = math.cos(angle), math.sin(angle)
            across = (math.copysign(width / 2, c) - x) / c if abs(c) > 1e-9 else 99
            up = (math.copysign(height / 2, s) - y) / s if abs(s) > 1e-9 else 99
            return min(across, up)

        ranges = " ".join(f"{reach(heading + math.radians(j - 90)):.2f}" for j in range(181))
        lines.append(f"FLASER 181 {ranges} {x:.4f} {y:.4f} {heading:.4f} {x:.4f} {y:.4f} {heading:.4f} {i} host {i}")
    return "\n".join(lines) + "\n"


houses = [drawn(n, "--size", "house" if n % 3 else "office", "--furniture", str(n % 4 / 5)) for n in range(MAPS)]
plans = [drawn(100 + n, "--plan", "blueprint" if n % 2 else "evacuation") for n in range(PLANS)]
logs = [log(n) for n in range(LOGS)]


def put_map(n):
    source, place = houses[n % MAPS], folder / "maps" / f"{n % 7}"
    write(place / f"{n}.pgm", (source / "map.pgm").read_bytes())
    yaml = (source / "map.yaml").read_text().replace("map.pgm", f"{n}.pgm")
    write(place / f"{n}.yaml", f"{yaml}# number {n}\n".encode())


def put_plan(n):
    source = next(plans[n // 40 % PLANS].glob("plan.*"))
    # What follows a picture's end is no part of it, and makes it another document.
    write(folder / "plans" / f"{n}{source.suffix}", source.read_bytes() + str(n).encode())


def put_log(n):
    write(folder / "logs" / f"{n}.log", f"# number {n}\n{logs[n // 10 % LOGS]}".encode())


def put_broken(n):
    source = houses[n % MAPS]
    kinds = [
        (".png", b""),
        (".pdf", b"%PDF-1.7\nno PDF at all " + str(n).encode()),
        (".pgm", (source / "map.pgm").read_bytes()[: 400 + n]),
        (".yaml", f"image: nowhere-{n}.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n".encode()),
        (".dxf", b"0\nSECTION\n2\nENTITIES\n0\nLINE\n" + rng.randbytes(60)),
        (".log", b"FLASER 181 " + rng.randbytes(80)),
        (".svg", b"<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0" + b" " * n),
        (".jpg", b"\xff\xd8\xff\xe0" + rng.randbytes(300)),
    ]
    suffix, data = kinds[n % len(kinds)]
    write(folder / "broken" / f"{n}{suffix}", data)


broken = count // 20
for n in range(broken):
    put_broken(n)
for n in range(5):
    write(folder / "plugins" / f"{n}.sleep", b"sleep" + str(n).encode())
    write(folder / "plugins" / f"{n}.exhaust", b"exhaust" + str(n).encode())
for n in range(count - broken - 10):
    (put_plan if n % 40 == 0 else put_log if n % 10 == 5 else put_map)(n)
shutil.rmtree(scratch)
