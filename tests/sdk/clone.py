#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the way from a clone to a running daemon, by the commands of clients/README.md: clone.py [REPOSITORY].

The default repository is this one, as it is committed. The compiler's cache is empty, as on a new machine; packages that are
already installed are not installed again. Prints the seconds after each command. Exit: 1 the daemon did not start.
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

LISTENING = re.compile(r"listening on 127\.0\.0\.1:\d+$")


def wait_until_listening(daemon):
    """False: it has ended before."""
    for line in daemon.stdout:
        if LISTENING.match(line):
            return True
    return False


def main():
    repository = sys.argv[1] if len(sys.argv) > 1 else str(ROOT)
    clone, run = readme.Readme("README.md").commands()
    with tempfile.TemporaryDirectory() as folder:
        # `make run` passes ARGS to the daemon: a free port, and a home of its own.
        environment = dict(os.environ, CCACHE_DIR=str(pathlib.Path(folder) / "ccache"), ARGS="--listen 127.0.0.1:0", MAKEFLAGS="")
        for name in ("XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"):
            environment[name] = folder
        started = time.monotonic()
        subprocess.run(["bash", "-c", clone.replace("REPOSITORY", repository)], cwd=folder, env=environment, check=True)
        print("%7.0f s  %s" % (time.monotonic() - started, clone), flush=True)
        daemon = subprocess.Popen(["bash", "-c", run], cwd=folder, env=environment, stdout=subprocess.PIPE, text=True,
                                  start_new_session=True)
        listens = wait_until_listening(daemon)
        print("%7.0f s  %s" % (time.monotonic() - started, run if listens else "the daemon did not start"))
        os.killpg(daemon.pid, signal.SIGTERM)
        daemon.communicate()
    return 0 if listens else 1


if __name__ == "__main__":
    sys.exit(main())
