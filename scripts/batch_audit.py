"""Audits every DXF in a folder with ezdxf: batch_audit.py FOLDER. Fails if one has an error, or needs a repair."""

import pathlib
import sys

import ezdxf

files = sorted(pathlib.Path(sys.argv[1]).rglob("*.dxf"))
wrong = {}
for file in files:
    audit = ezdxf.readfile(file).audit()
    if audit.errors or audit.fixes:
        wrong[file] = [entry.message for entry in audit.errors + audit.fixes]
print(f"{len(files)} DXF files, {len(wrong)} with errors or repairs")
for file, messages in wrong.items():
    print(file, *messages, sep="\n  ")
sys.exit(1 if wrong or not files else 0)
