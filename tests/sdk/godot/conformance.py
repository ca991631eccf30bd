#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""conformance.json against the Godot addon, in each Godot there is. Prints "ok" or "not ok", SDK and case, a line each."""

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
