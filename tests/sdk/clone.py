#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the way from a clone to the first push, by the commands of clients/libraries.md: clone.py [REPOSITORY].

The default repository is this one, as it is committed. The compiler's cache is empty, as on a new machine; packages that are
already installed are not installed again. Prints the seconds after each command, and for each library all commands and seconds
from the clone: C++ needs `make release` and `make install` too, here into a folder. Exit: 1 the daemon did not start, or a push
was not felt.
"""

import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

import readme
from readme import ROOT

LIBRARIES = ("Python", "JavaScript", "C#", "Godot", "Unreal")
LISTENING = re.compile(r"listening on 127\.0\.0\.1:\d+$")


def wait_until_listening(daemon):
    """False: it has ended before."""
    for line in daemon.stdout:
        if LISTENING.match(line):
            return True
    return False


def run_in(folder, environment, command, started):
    subprocess.run(["bash", "-c", command], cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)
    print("%7.0f s  %s" % (time.monotonic() - started, command), flush=True)


def start_daemon(folder, environment, command, started):
    """Seconds until it listens; None: it did not start. It is ended."""
    daemon = subprocess.Popen(["bash", "-c", command], cwd=folder, env=environment, stdout=subprocess.PIPE, text=True,
                              start_new_session=True)
    listens = wait_until_listening(daemon)
    took_s = time.monotonic() - started
    print("%7.0f s  %s" % (took_s, command if listens else "the daemon did not start"), flush=True)
    os.killpg(daemon.pid, signal.SIGTERM)
    daemon.communicate()
    return took_s if listens else None


def print_libraries(clone, prefix, daemon_s, library_s):
    """False: a push was not felt. The first command of a README, the daemon's start, is replaced by two, clone and `make run`."""
    program = [clone / "tests" / "sdk" / "quick_starts.py", prefix / "bin" / "hedgehogd", "C++", *LIBRARIES]
    environment = dict(os.environ, PKG_CONFIG_PATH=str(next(prefix.rglob("hedgehog-client.pc")).parent))
    measured = subprocess.run(program, env=environment, stdout=subprocess.PIPE, text=True)
    print("%-12s %9s %9s" % ("", "commands", "seconds"))
    for name, commands, seconds in re.findall(r"^(\S+) +(\d+) +([0-9.]+)", measured.stdout, re.M):
        built, more_s = (2, library_s) if name == "C++" else (0, 0.0)
        print("%-12s %9d %9.0f" % (name, int(commands) + 1 + built, daemon_s + more_s + float(seconds)))
    return measured.returncode == 0


def main():
    repository = sys.argv[1] if len(sys.argv) > 1 else str(ROOT)
    clone, run = readme.Readme("libraries.md").commands()
    with tempfile.TemporaryDirectory() as folder:
        # `make run` passes ARGS to the daemon: a free port, and a home of its own.
        environment = dict(os.environ, CCACHE_DIR=str(pathlib.Path(folder) / "ccache"), ARGS="--listen 127.0.0.1:0", MAKEFLAGS="")
        for name in ("XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"):
            environment[name] = folder
        started = time.monotonic()
        run_in(folder, environment, clone.replace("REPOSITORY", repository), started)
        daemon_s = start_daemon(folder, environment, run, started)
        if daemon_s is None:
            return 1
        started = time.monotonic()
        prefix = pathlib.Path(folder) / "prefix"
        run_in(folder, environment, "make -C hedgehog release", started)
        run_in(folder, environment, "make -C hedgehog install PREFIX=%s" % prefix, started)
        library_s = time.monotonic() - started
        return 0 if print_libraries(pathlib.Path(folder) / "hedgehog", prefix, daemon_s, library_s) else 1


if __name__ == "__main__":
    sys.exit(main())
