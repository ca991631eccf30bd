#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs conformance.json on the Godot addon, in each available Godot. Prints a line for each case: "ok" or "not ok", SDK, case."""

import pathlib
import sys
import tempfile

import project

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

import case_player  # noqa: E402


def main():
    failed = not project.engines()
    if failed:
        print("conformance.py: there is no godot3-server and no $GODOT4", file=sys.stderr)
    for engine in project.engines():
        with tempfile.TemporaryDirectory() as folder:
            script = (project.HERE / "conformance.gd").read_text(encoding="utf-8")
            project.make_project(folder, engine, script, [project.HERE / "listening_ball.gd"])
            if not case_player.play_all(engine, lambda environment: project.start(folder, engine, environment)):
                failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
