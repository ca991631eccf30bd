#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Conditions under which the table of libraries and cases is a failure."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
DOCUMENT = json.loads((HERE / "conformance.json").read_text(encoding="utf-8"))
LINES = [(library, case["name"], "ok") for library in DOCUMENT["libraries"] for case in DOCUMENT["cases"]
         if library not in case.get("without", [])]


class Table(unittest.TestCase):
    def table(self, lines, folder=HERE, *options):
        with tempfile.NamedTemporaryFile("w", encoding="utf-8") as file:
            file.writelines("\t".join(line) + "\n" for line in lines)
            file.flush()
            return subprocess.run([sys.executable, str(folder / "conformance_table.py"), file.name, *options],
                                  stdout=subprocess.PIPE, text=True, check=False)

    def test_every_library_passes_every_case(self):
        self.assertEqual(self.table(LINES).returncode, 0)

    def test_a_library_that_did_not_run(self):
        table = self.table([line for line in LINES if line[0] != "unreal"])
        self.assertEqual(table.returncode, 1)
        self.assertIn("missing", table.stdout)

    def test_no_library_ran(self):
        self.assertEqual(self.table([]).returncode, 1)

    def test_a_case_that_was_left_out_or_failed(self):
        self.assertEqual(self.table(LINES[1:]).returncode, 1)
        self.assertEqual(self.table([LINES[0][:2] + ("failed",)] + LINES[1:]).returncode, 1)

    def test_a_case_that_does_not_apply_is_not_expected(self):
        self.assertRegex(self.table(LINES).stdout, r"a late acceptance [^\n]* - ")
        self.assertNotIn("missing", self.table(LINES).stdout)

    def test_a_library_that_is_not_expected_has_to_pass_too(self):
        others = [("godot4", case["name"], "ok") for case in DOCUMENT["cases"]]
        self.assertEqual(self.table(LINES + others).returncode, 0)
        self.assertEqual(self.table(LINES + others[1:]).returncode, 1)

    def test_a_page_with_another_table_is_refused_until_it_is_written(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for file in ("conformance.json", "conformance.md", "conformance_table.py"):
                shutil.copy(HERE / file, folder)
            page = folder / "conformance.md"
            page.write_text(page.read_text(encoding="utf-8").replace("| ok |", "| - |", 1), encoding="utf-8")
            self.assertEqual(self.table(LINES, folder).returncode, 1)
            self.assertEqual(self.table(LINES, folder, "--write").returncode, 0)
            self.assertEqual(page.read_text(encoding="utf-8"), (HERE / "conformance.md").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
