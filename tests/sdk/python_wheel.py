#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the wheel of the Python library, installed into a virtual environment: python_wheel.py HEDGEHOGD FOLDER."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile

import live_daemon
import readme

FOLDER = pathlib.Path(sys.argv.pop(2)) if len(sys.argv) > 2 else pathlib.Path()
DAEMON = sys.argv.pop(1) if len(sys.argv) > 1 else ""


class Wheel(unittest.TestCase):
    def test_the_readme_s_example_runs_in_an_empty_folder_that_has_only_the_wheel(self):
        wheel, = FOLDER.glob("hedgehog-*.whl")
        daemon = live_daemon.LiveDaemon(DAEMON)
        self.addCleanup(daemon.stop)
        with tempfile.TemporaryDirectory() as empty:
            subprocess.run([sys.executable, "-m", "venv", "venv"], cwd=empty, check=True)
            python = pathlib.Path(empty) / "venv" / "bin" / "python"
            subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-index", "--disable-pip-version-check", wheel.resolve()],
                           cwd=empty, check=True)
            environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
            (pathlib.Path(empty) / "game.py").write_text(readme.Readme("python/README.md").program("python"), encoding="utf-8")
            printed = subprocess.run([python, "game.py"], cwd=empty, check=True, text=True, stdout=subprocess.PIPE,
                                     timeout=live_daemon.LIMIT_S, env=dict(environment, HEDGEHOG_ADDRESS=daemon.address)).stdout
            self.assertGreater(float(printed), 10.0)
            # With this file a type checker finds the types.
            found = subprocess.run([python, "-c", "import hedgehog, pathlib; print((pathlib.Path(hedgehog.__file__).parent / 'py.typed').exists())"],
                                   cwd=empty, check=True, text=True, stdout=subprocess.PIPE).stdout
            self.assertEqual(found.strip(), "True")

    def test_its_description_links_to_no_file(self):
        wheel, = FOLDER.glob("hedgehog-*.whl")
        with zipfile.ZipFile(wheel) as packed:
            metadata, = (name for name in packed.namelist() if name.endswith("/METADATA"))
            text = packed.read(metadata).decode("utf-8")
        self.assertIn("# Python", text)
        self.assertEqual(re.findall(r"\]\(([^):#]+)(?:#[^)]*)?\)", text), [])


if __name__ == "__main__":
    unittest.main()
