"""Holds the report of scripts/batch-1000 against the documents: batch_check.py REPORT.jsonl FOLDER"""

import collections
import json
import sys

rows = [json.loads(line) for line in open(sys.argv[1], encoding="utf-8")]
kinds = collections.Counter()
for row in rows:
    kind = row["name"].split("/")[0]
    expected = "failed" if kind in ("broken", "plugins") else "skipped" if row["name"].endswith(".pgm") else "converted"
    if row["state"] != expected:
        sys.exit(f"{row['name']} is {row['state']}, not {expected}: {row['reason']}")
    if expected == "failed" and not (row["reason"] or "").startswith("in/"):
        sys.exit(f"{row['name']} failed without a sentence")
    kinds[kind, row["state"]] += 1
for (kind, state), number in sorted(kinds.items()):
    print(f"{kind:8} {number:4} {state}")
print(f"most memory of one document: {max(r['memory_mib'] for r in rows)} MiB")
