#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the types of the Python library and of a program that uses it strictly, for the oldest supported Python."""

import pathlib
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PYTHON = HERE.parent.parent / "clients" / "python"


def check(*files):
    """The output of the type checker; empty: no errors."""
    with tempfile.TemporaryDirectory() as cache:
        ran = subprocess.run(["mypy", "--config-file", str(PYTHON / "pyproject.toml"), "--cache-dir", cache, "--no-error-summary",
                              *map(str, files)], cwd=PYTHON, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return ran.stdout


class Types(unittest.TestCase):
    def test_the_library_and_programs_are_right_and_mistakes_are_refused(self):
        example = PYTHON.parent / "examples" / "racer.py"
        self.assertEqual(check("hedgehog", HERE / "python_sample.py", example), "")

    def test_what_only_a_newer_python_understands_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            newer = pathlib.Path(folder) / "newer.py"
            newer.write_text("def kind(value: int) -> None:\n    match value:\n        case _:\n            pass\n", encoding="utf-8")
            self.assertIn("Python 3.10", check(newer))
            newer.write_text("from typing import NotRequired\n", encoding="utf-8")
            self.assertIn("NotRequired", check(newer))


if __name__ == "__main__":
    unittest.main()
