#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests the quick starts, from an installed daemon to the first pulse: quick_starts.py HEDGEHOGD [LIBRARY...].

Each README's program is written to an empty folder beside the sources, and its commands are pasted verbatim into one shell, in which
`hedgehogd` is at a free port. Commands that wait for the daemon get one that starts LATE_S later, so that they fail if they do not
wait. The printed table has the number of commands and the time until the daemon started the first pulse, without LATE_S. Exit: 1 a
quick start fails, has more than ten lines, its push is cut off, or the table of clients/libraries.md has another number of commands.
"""

import itertools
import pathlib
import re
import sys
import tempfile
import threading
import time

import readme
from readme import CLIENTS, ROOT

sys.path[:0] = [str(CLIENTS / "python"), str(ROOT / "tests" / "sdk" / "godot"), str(ROOT / "tests" / "sdk" / "unreal")]

import hedgehog  # noqa: E402
import project  # noqa: E402
import quick_start  # noqa: E402
from live_daemon import LIMIT_S  # noqa: E402
from terminal import Terminal  # noqa: E402

START = "hedgehogd --simulate &"
# Programs that make one attempt to connect, and that nothing slow precedes.
WAITING = ("Python",)
LATE_S = 1.0
MAX_LINES = 10
# README, language, files. C++ needs an installed library, therefore tests/install runs it.
LIBRARIES = {"Python": ("python/README.md", "python", ["game.py"]), "JavaScript": ("js/README.md", "js", ["game.mjs"]),
             "C#": ("unity/README.md", "csharp", ["game.cs"]), "C++": ("lib/README.md", "cpp", ["game.cpp"]),
             "Godot": ("godot/README.md", "gdscript", ["main.gd"]), "Unreal": ("unreal/README.md", "cpp", quick_start.FILES)}
FROM_CLONE = "the daemon, from a clone"
NOTES = {"Unreal": "  with the stub of the engine"}


class FirstPulse:
    """The time at which the daemon started the first effect without a slot, each program's push, and why it ended."""

    def __init__(self, address):
        self._address = address
        self._at = None
        self._reason = None
        self._closed = threading.Event()
        self._connected = threading.Event()
        self._thread = threading.Thread(target=self._wait)
        self._thread.start()

    def _connect(self):
        """None: closed before there was a daemon."""
        while not self._closed.is_set():
            try:
                return hedgehog.Ball(self._address, name="observer", timeout_s=LIMIT_S)
            except hedgehog.NotConnected:
                self._closed.wait(0.02)
        return None

    def _wait(self):
        ball = self._connect()
        if ball is None:
            return
        with ball:
            try:
                kinds = ["effect_started", "effect_ended"]
                events = ball.events(kinds, scope="all", timeout_s=LIMIT_S)
                # What was played before this subscription.
                past = ball.events_history(types=kinds)["events"]
                self._connected.set()
                pushed = None
                for event in itertools.chain(past, events):
                    if event["type"] == "effect_started" and event.get("slot") is None and pushed is None:
                        self._at = time.monotonic()
                        pushed = event["effect"]
                    if event["type"] == "effect_ended" and event["effect"] == pushed:
                        self._reason = event["reason"]
                        return
            except hedgehog.NotConnected:
                # The daemon has ended.
                return

    def wait_until_connected(self):
        self._connected.wait(LIMIT_S)

    def result(self):
        """Its time, and the reason of its end; None: there was no push, or no end."""
        self._thread.join()
        return self._at, self._reason

    def close(self):
        self._closed.set()
        self._thread.join()


def start_engine(library, game, environment):
    """The game in its engine; None: the commands have run it."""
    if library == "Godot":
        return project.start(game, "godot3", environment)
    return quick_start.start(game, environment) if library == "Unreal" else None


def time_quick_start(daemon_program, library, commands, game):
    """Seconds until the first pulse, and the reason of its end; None: there was none."""
    assert commands[0].startswith(START), commands
    late_s = LATE_S if library in WAITING else 0.0
    started = time.monotonic()
    terminal = Terminal(daemon_program, game.parent / "terminal", late_s)
    first = FirstPulse(terminal.address)
    try:
        terminal.paste(commands, game)
        # An engine is started by hand, later than its daemon.
        first.wait_until_connected()
        running = start_engine(library, game, terminal.environment)
        at, reason = first.result()
        if running:
            running.kill()
            running.communicate()
    finally:
        terminal.close()
        first.close()
    return (at - started - late_s if at else None), reason


def measure_quick_start(daemon_program, library):
    """The number of commands, the seconds until the first pulse, and the reason of its end."""
    path, language, files = LIBRARIES[library]
    guide = readme.Readme(path)
    with tempfile.TemporaryDirectory() as folder:
        game = guide.project(folder, language, files)
        assert guide.program(language).count("\n") <= MAX_LINES, "%s: more than %d lines" % (path, MAX_LINES)
        if library == "Godot":
            # The editor's part: a scene, to whose node the script is attached.
            project.make_scene(game, "godot3")
        return (len(guide.commands()), *time_quick_start(daemon_program, library, guide.commands(), game))


def documented():
    """The number of commands in the table of clients/libraries.md, by library; and from a clone to the daemon."""
    text = (CLIENTS / "libraries.md").read_text(encoding="utf-8")
    return {name: int(count) for name, count in re.findall(r"^\| \[?([^]|]+?)(?:\]\([a-z]+/README\.md\))? \| (\d+) \|", text, re.M)}


def print_row(name, commands, seconds, note):
    """False: the table of clients/libraries.md has another number of commands."""
    known = documented().get(name)
    if known != commands:
        note += "  clients/libraries.md says %s commands" % known
    print("%-24s %9d %9s%s" % (name, commands, seconds, note), flush=True)
    return known == commands


def main():
    libraries = sys.argv[2:] or [one for one in LIBRARIES if one != "C++"]
    print("%-24s %9s %9s" % ("", "commands", "seconds"))
    well = print_row(FROM_CLONE, len(readme.Readme("libraries.md").commands()), "-", "  measured by clone.py")
    for library in libraries:
        commands, seconds, reason = measure_quick_start(sys.argv[1], library)
        note = NOTES.get(library, "") + ("" if reason == "completed" else "  its push: %s" % (reason or "none"))
        row = print_row(library, commands, "-" if seconds is None else "%.1f" % seconds, note)
        well = well and row and reason == "completed"
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
