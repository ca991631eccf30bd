#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs conformance.json on the Unreal plugin's core: conformance.py PROGRAM. Prints a line for each case: "ok" or "not ok", SDK, case."""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

import case_player  # noqa: E402


def start(environment):
    return subprocess.Popen([sys.argv[1]], env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


if __name__ == "__main__":
    sys.exit(0 if case_player.play_all("unreal", start) else 1)
