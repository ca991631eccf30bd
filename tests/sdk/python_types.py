#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the types of the Python library and of a program that uses it strictly, for the oldest supported Python."""

import ast
import pathlib
import re
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PYTHON = HERE.parent.parent / "clients" / "python"
EXAMPLE = PYTHON.parent / "examples" / "racer.py"
OLDEST = (3, 9)


def check(*files):
    """The output of the type checker; empty: no errors."""
    with tempfile.TemporaryDirectory() as cache:
        ran = subprocess.run(["mypy", "--config-file", str(PYTHON / "pyproject.toml"), "--cache-dir", cache, "--no-error-summary",
                              *map(str, files)], cwd=PYTHON, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return ran.stdout


class Types(unittest.TestCase):
    def test_library_and_programs_type_check_and_errors_are_rejected(self):
        self.assertEqual(check("hedgehog", HERE / "python_sample.py", EXAMPLE), "")

    def test_syntax_of_a_newer_python_is_rejected(self):
        with tempfile.TemporaryDirectory() as folder:
            newer = pathlib.Path(folder) / "newer.py"
            newer.write_text("def kind(value: int) -> None:\n    match value:\n        case _:\n            pass\n", encoding="utf-8")
            self.assertIn("Python 3.10", check(newer))
            newer.write_text("from typing import NotRequired\n", encoding="utf-8")
            self.assertIn("NotRequired", check(newer))


class Oldest(unittest.TestCase):
    """The oldest Python that the library runs with; run.sh runs the library in it where $PYTHON39 is set."""

    def test_the_package_and_the_type_checker_name_it(self):
        project = (PYTHON / "pyproject.toml").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r'^(?:requires-python = ">=|python_version = ")(.*)"$', project, re.M), ["%d.%d" % OLDEST] * 2)

    def test_it_parses_the_library_and_the_example(self):
        sources = list((PYTHON / "hedgehog").glob("*.py")) + [EXAMPLE]
        self.assertGreater(len(sources), 10)
        for source in sources:
            with self.subTest(source.name):
                ast.parse(source.read_text(encoding="utf-8"), str(source), feature_version=OLDEST)

    def test_it_does_not_parse_what_is_newer(self):
        with self.assertRaises(SyntaxError):
            ast.parse("match 1:\n    case _:\n        pass\n", feature_version=OLDEST)


if __name__ == "__main__":
    unittest.main()
