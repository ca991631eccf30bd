#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""conformance_table.py FILE: which library passes which case of conformance.json.

A line of FILE, written by the runners to the file that HEDGEHOG_CONFORMANCE_TABLE names, is library, case and "ok" or
"failed", with tabs between. Exit: 0 every library of conformance.json, and each other one that ran, passes every case that
applies to it; 1 not.
"""

import json
import pathlib
import sys

MARKS = {"ok": "ok", "failed": "FAILED", "": "missing", "apart": "-"}


def main():
    document = json.loads((pathlib.Path(__file__).parent / "conformance.json").read_text(encoding="utf-8"))
    cases = [case["name"] for case in document["cases"]]
    # A library whose runner wrote no line has failed every case.
    outcomes = {library: {} for library in document["libraries"]}
    for line in pathlib.Path(sys.argv[1]).read_text(encoding="utf-8").splitlines():
        library, case, outcome = line.split("\t")
        outcomes.setdefault(library, {})[case] = outcome
    libraries = list(outcomes)
    for number, library in enumerate(libraries, 1):
        print("%3d  %s" % (number, library))
    width = max(len(case) for case in cases)
    print("\n" + " " * width + "".join("%8d" % number for number in range(1, len(libraries) + 1)))
    passed = expected = 0
    for one in document["cases"]:
        case = one["name"]
        row = ["apart" if library in one.get("without", []) else outcomes[library].get(case, "") for library in libraries]
        passed += row.count("ok")
        expected += len(row) - row.count("apart")
        print(case.ljust(width) + "".join("%8s" % MARKS[outcome] for outcome in row))
    print("\n%d of %d" % (passed, expected))
    return 0 if passed == expected else 1


if __name__ == "__main__":
    sys.exit(main())
