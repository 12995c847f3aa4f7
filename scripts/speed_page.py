"""What scripts/speed writes: the tables of docs/performance.md, and its plot."""

import math
import os
import platform
import re
import statistics
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent.parent / "docs"
PAGE, PLOT = DOCS / "performance.md", DOCS / "performance.svg"

# The plot's size and its margins (left, right, top, bottom), pixels.
WIDTH, HEIGHT = 640, 360
LEFT, RIGHT, TOP, BOTTOM = 56, 16, 40, 48
# Okabe and Ito's colours, which the colour-blind can tell apart.
SERIES = [("planform on one thread", "#0072b2"), ("on two", "#d55e00")]


def machine():
    """The processor and its cores."""
    try:
        name = re.search(r"^model name\s*:\s*(.*)$", Path("/proc/cpuinfo").read_text(), re.M)
    except OSError:
        name = None
    name = name[1] if name else platform.processor() or "unknown processor"
    return f"{name}, {os.cpu_count()} cores"


def table(header, rows, left=1):
    """A table in Markdown; columns after so many are numbers."""
    line = lambda cells: "| " + " | ".join(cells) + " |"
    rule = ["---"] * left + ["---:"] * (len(header) - left)
    return "\n".join(map(line, [header, rule, *rows]))


def compared(maps, rounds, version):
    """The table of what scripts/speed measured, and the medians."""
    header = ["map", "megapixels", "OpenCV, ms", "planform, ms", "on two threads, ms", "ratio", "on two threads"]
    numbers = [[size, cv, one, two, one / cv, two / cv] for _, size, cv, one, two in maps]
    medians = [statistics.median(column) for column in zip(*numbers)]
    rows = [row(name, cells) for name, cells in zip([name for name, *_ in maps], numbers)]
    rounds = "one round" if rounds == 1 else f"the best of {rounds} rounds"
    note = f"{machine()}; OpenCV {version} on one thread; {rounds}. The ratio is planform's time divided by OpenCV's."
    return f"{note}\n\n{table(header, [*rows, row('median', medians)])}"


def row(name, cells):
    size, *times, one, two = cells
    return [name, f"{size:.2f}", *(f"{1e3 * t:.1f}" for t in times), f"{one:.2f}", f"{two:.2f}"]


def steps(chosen, found):
    """The share of each step."""
    name, size, *_ = chosen
    whole = sum(seconds for _, seconds in found)
    rows = [[step, f"{1e3 * seconds:.0f}", f"{100 * seconds / whole:.0f}"] for step, seconds in found]
    return f"{name}, {size:.2f} megapixels, on one thread:\n\n{table(['step', 'ms', 'percent'], rows)}"


def program(start, size):
    return f"`planform --version` takes {1e3 * start:.1f} ms; the program has {size / 1e6:.1f} MB."


def write(texts, maps):
    """Puts the texts between their markers, and draws the plot."""
    page = PAGE.read_text()
    for name, text in texts.items():
        page = between(page, name, text)
    PAGE.write_text(page)
    PLOT.write_text(plot(maps))


def between(page, name, text):
    begin, end = f"<!-- {name}:begin -->", f"<!-- {name}:end -->"
    before, found, rest = page.partition(begin)
    _, closed, after = rest.partition(end)
    if not (found and closed):
        sys.exit(f"error: {PAGE.name} has no {begin} with {end} after it")
    return f"{before}{begin}\n\n{text.strip()}\n\n{end}{after}"


def plot(maps):
    """The ratios over the maps' sizes, as SVG."""
    sizes = [size for _, size, *_ in maps]
    ratios = [[(size, times[i] / cv) for _, size, cv, *times in maps] for i in range(len(SERIES))]
    highest = max(ratio for points in ratios for _, ratio in points)
    most = 2 if highest <= 2 else 4 * math.ceil(highest / 4)
    low, high = math.log10(min(sizes)) - 0.05, math.log10(max(sizes)) + 0.05
    x = lambda size: LEFT + (math.log10(size) - low) / (high - low) * (WIDTH - LEFT - RIGHT)
    y = lambda ratio: HEIGHT - BOTTOM - ratio / most * (HEIGHT - TOP - BOTTOM)
    dots = [
        f'<circle cx="{x(size):.1f}" cy="{y(ratio):.1f}" r="4" fill="{colour}" fill-opacity="0.8"/>'
        for (_, colour), points in zip(SERIES, ratios)
        for size, ratio in points
    ]
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif">'
    ground = f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    return "\n".join([head, ground, *axes(x, y, (low, high), most), *dots, *legend(), "</svg>"]) + "\n"


def axes(x, y, ends, most):
    """Lines at round ratios and sizes, the one at 1 stronger, and what the axes are."""
    for i in range(5):
        ratio = most * i / 4
        yield line((LEFT, y(ratio)), (WIDTH - RIGHT, y(ratio)), "#e1e1e1")
        yield text(LEFT - 8, y(ratio) + 4, f"{ratio:g}", "end")
    yield line((LEFT, y(1)), (WIDTH - RIGHT, y(1)), "#5a5a5a")
    for size in (base * 10**power for power in range(-3, 4) for base in (1, 2, 5)):
        if ends[0] <= math.log10(size) <= ends[1]:
            yield line((x(size), y(0)), (x(size), TOP), "#e1e1e1")
            yield text(x(size), y(0) + 18, f"{size:g}", "middle")
    yield text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 10, "megapixels", "middle")


def legend():
    yield text(LEFT, 22, "Time of planform divided by OpenCV's:", "start")
    for i, (name, colour) in enumerate(SERIES):
        yield f'<circle cx="{332 + 180 * i}" cy="18" r="4" fill="{colour}"/>'
        yield text(342 + 180 * i, 22, name, "start")


def line(a, b, colour):
    return f'<path d="M{a[0]:.1f} {a[1]:.1f}L{b[0]:.1f} {b[1]:.1f}" stroke="{colour}"/>'


def text(x, y, words, anchor):
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="13" text-anchor="{anchor}">{words}</text>'
