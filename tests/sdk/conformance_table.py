#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""conformance_table.py FILE [--write]: which library passes which case of conformance.json.

A line of FILE, written by the runners to the file that HEDGEHOG_CONFORMANCE_TABLE names, is library, case and "ok" or
"failed", with tabs between. Exit: 0 every library of conformance.json, and each other one that ran, passes every case that
applies to it, and conformance.md has this table (--write writes it there); 1 not.
"""

import json
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
PAGE = HERE / "conformance.md"
MARKS = {"ok": "ok", "failed": "FAILED", "": "missing", "apart": "-"}
HEAD = """# Conformance: libraries and cases

Which library passes which case of `conformance.json`; -: the case does not apply to it. Written by `conformance_table.py FILE --write`;
every `make test-sdk` compares it with its own results and fails if they differ.

"""


class Table:
    """Outcomes by case and library."""

    def __init__(self, lines):
        document = json.loads((HERE / "conformance.json").read_text(encoding="utf-8"))
        self.expected = document["libraries"]
        # A library whose runner wrote no line has failed every case.
        outcomes = {library: {} for library in self.expected}
        for line in lines:
            library, case, outcome = line.split("\t")
            outcomes.setdefault(library, {})[case] = outcome
        self.libraries = list(outcomes)
        self.rows = {case["name"]: ["apart" if library in case.get("without", []) else outcomes[library].get(case["name"], "")
                                    for library in self.libraries] for case in document["cases"]}

    def count(self, *marks):
        return sum(row.count(mark) for row in self.rows.values() for mark in marks)

    def print(self):
        for number, library in enumerate(self.libraries, 1):
            print("%3d  %s" % (number, library))
        width = max(len(case) for case in self.rows)
        print("\n" + " " * width + "".join("%8d" % number for number in range(1, len(self.libraries) + 1)))
        for case, row in self.rows.items():
            print(case.ljust(width) + "".join("%8s" % MARKS[outcome] for outcome in row))
        print("\n%d of %d" % (self.count("ok"), self.count("ok", "failed", "")))

    def page(self):
        """Without libraries that are not on every machine."""
        count = len(self.expected)
        text = HEAD + "| case | " + " | ".join(self.expected) + " |\n" + "|---" * (count + 1) + "|\n"
        return text + "".join("| %s | %s |\n" % (case, " | ".join(MARKS[outcome] for outcome in row[:count]))
                              for case, row in self.rows.items())


def main():
    table = Table(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8").splitlines())
    table.print()
    if "--write" in sys.argv[2:]:
        PAGE.write_text(table.page(), encoding="utf-8")
    if table.count("failed", "") > 0:
        return 1
    if PAGE.read_text(encoding="utf-8") == table.page():
        return 0
    print("tests/sdk/conformance.md has another table: run again with --write")
    return 1


if __name__ == "__main__":
    sys.exit(main())
