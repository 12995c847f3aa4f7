"""Watches the memory of a batch and of all its processes: batch_memory.py PROCESS BUDGET_MIB

Fails if they ever hold more than the budget. What they share, such as the program itself, is counted once (PSS).
"""

import pathlib
import sys
import time

root, budget = int(sys.argv[1]), int(sys.argv[2])


def parents():
    table = {}
    for folder in pathlib.Path("/proc").iterdir():
        if folder.name.isdigit():
            try:
                table[int(folder.name)] = int((folder / "stat").read_text().rsplit(")", 1)[1].split()[1])
            except (OSError, IndexError):
                pass
    return table


def held(process):
    try:
        lines = pathlib.Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
        return sum(int(line.split()[1]) for line in lines if line.startswith("Pss:"))
    except OSError:
        return 0


def below(table):
    found, grown = {root}, True
    while grown:
        new = {child for child, parent in table.items() if parent in found} - found
        found, grown = found | new, bool(new)
    return found - {root}


most = at_once = 0
while pathlib.Path(f"/proc/{root}/stat").exists() and ") Z " not in pathlib.Path(f"/proc/{root}/stat").read_text():
    processes = below(parents())
    most = max(most, sum(map(held, processes)))
    at_once = max(at_once, len(processes))
    time.sleep(0.05)
print(f"memory budget {budget} MiB: the documents in work, {at_once} at a time, held {most / 1024:.0f} MiB at most")
sys.exit(0 if most / 1024 <= budget else 1)
