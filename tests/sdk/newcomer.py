#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the quick starts, from an installed daemon to the first pulse: newcomer.py HEDGEHOGD [LIBRARY...].

Each README's program is written to an empty folder beside the sources, and its commands are run verbatim. The printed table has the
number of commands and the time until the daemon started the first effect. Exit: 1 a quick start fails, or the table of
clients/README.md has another number of commands.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import time

import readme
from readme import CLIENTS, ROOT

sys.path[:0] = [str(CLIENTS / "python"), str(ROOT / "tests" / "sdk" / "godot")]

import hedgehog  # noqa: E402
import project  # noqa: E402
from live_daemon import LIMIT_S, LiveDaemon  # noqa: E402

START = "hedgehogd --simulate &"
# README, language, file. C++ needs an installed library, therefore tests/install runs it.
LIBRARIES = {"Python": ("python/README.md", "python", "game.py"), "JavaScript": ("js/README.md", "js", "game.mjs"),
             "C#": ("unity/README.md", "csharp", "game.cs"), "C++": ("lib/README.md", "cpp", "game.cpp"),
             "Godot": ("godot/README.md", "gdscript", "main.gd")}


class FirstEffect:
    """The time at which the daemon started its first effect."""

    def __init__(self, address):
        self._ball = hedgehog.Ball(address, name="observer", patience_s=LIMIT_S)
        self._events = self._ball.events(["effect_started"], scope="all", patience_s=LIMIT_S)
        self.at = None
        self._thread = threading.Thread(target=self._wait)
        self._thread.start()

    def _wait(self):
        for _ in self._events:
            self.at = time.monotonic()
            break

    def result(self):
        self._thread.join()
        self._ball.close()
        return self.at


def take_way(daemon_program, commands, game):
    """Seconds until the first effect; None: no effect started."""
    started = time.monotonic()
    assert commands[0] == START, commands
    daemon = LiveDaemon(daemon_program)
    environment = dict(os.environ, HEDGEHOG_ADDRESS=daemon.address, HOME=str(game.parent), PYTHONDONTWRITEBYTECODE="1",
                       npm_config_offline="true", npm_config_audit="false", npm_config_fund="false",
                       npm_config_update_notifier="false")
    try:
        first = FirstEffect(daemon.address)
        for command in commands[1:]:
            subprocess.run(["bash", "-c", command], cwd=game, env=environment, check=True, timeout=LIMIT_S, stdout=subprocess.DEVNULL)
        if (game / "project.godot").exists():
            running = project.start(game, "godot3", environment)
            at = first.result()
            running.kill()
            running.communicate()
        else:
            at = first.result()
    finally:
        daemon.stop()
    return at - started if at else None


def way_of(daemon_program, library):
    """The number of commands, and the seconds until the first effect."""
    path, language, file = LIBRARIES[library]
    guide = readme.Readme(path)
    assert guide.names(file), "clients/%s does not name %s" % (path, file)
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(ROOT, pathlib.Path(folder) / "hedgehog")
        game = pathlib.Path(folder) / "game"
        if library == "Godot":
            # The editor's part: a project with a scene, to whose node the script is attached.
            project.make_project(game, "godot3", guide.program(language))
            subprocess.run(["rm", "-r", str(game / "addons")], check=True)
        else:
            game.mkdir()
            (game / file).write_text(guide.program(language), encoding="utf-8")
        return len(guide.commands()), take_way(daemon_program, guide.commands(), game)


def documented():
    """The number of commands in the table of clients/README.md, by library."""
    text = (CLIENTS / "README.md").read_text(encoding="utf-8")
    return {name: int(count) for name, count in re.findall(r"^\| \[([^]]+)\]\([a-z]+/README\.md\) \| (\d+) \|", text, re.M)}


def main():
    libraries = sys.argv[2:] or [one for one in LIBRARIES if one != "C++"]
    well = True
    print("%-12s %9s %9s" % ("", "commands", "seconds"))
    for library in libraries:
        commands, seconds = way_of(sys.argv[1], library)
        known = documented().get(library)
        problem = "" if seconds is not None else "  nothing was felt"
        if known != commands:
            problem += "  clients/README.md says %s commands" % known
        print("%-12s %9d %9s%s" % (library, commands, "-" if seconds is None else "%.1f" % seconds, problem), flush=True)
        well = well and not problem
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
