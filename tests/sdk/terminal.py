# SPDX-License-Identifier: MIT
"""A terminal into which the commands of a README are pasted, `hedgehogd --simulate &` too."""

import os
import pathlib
import shlex
import signal
import socket
import subprocess

from live_daemon import LIMIT_S, SIMULATE

# What `hedgehogd` is in the terminal: the program with an address, a clock and a home of the test.
DAEMON = """#!/bin/sh
sleep %(late_s)g
export HOME=%(home)s XDG_CONFIG_HOME=%(home)s XDG_STATE_HOME=%(home)s XDG_RUNTIME_DIR=%(home)s
unset RUNTIME_DIRECTORY STATE_DIRECTORY
exec %(program)s "$@" %(options)s >/dev/null 2>&1
"""


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as server:
        return server.getsockname()[1]


def tool_of(program):
    """hedgehogctl of the same build, or installed beside hedgehogd."""
    folder = pathlib.Path(program).resolve().parent
    beside = folder / "hedgehogctl"
    return beside if beside.exists() else folder.parent / "clients" / "ctl" / "hedgehogctl"


class Terminal:
    """`folder`: an empty one, for programs and the daemon's home. `late_s`: how much later the daemon starts, as on a slow machine."""

    def __init__(self, program, folder, late_s=0.0):
        programs, home = folder / "programs", folder / "home"
        programs.mkdir(parents=True)
        home.mkdir()
        self.address = "127.0.0.1:%d" % free_port()
        options = [word for word in SIMULATE if word != "--simulate"] + ["--listen", self.address]
        daemon = programs / "hedgehogd"
        daemon.write_text(DAEMON % {"late_s": late_s, "home": shlex.quote(str(home)), "options": shlex.join(options),
                                    "program": shlex.quote(str(pathlib.Path(program).resolve()))}, encoding="utf-8")
        daemon.chmod(0o755)
        (programs / "hedgehogctl").symlink_to(tool_of(program))
        self.environment = dict(os.environ, HEDGEHOG_ADDRESS=self.address, HOME=str(home), PYTHONDONTWRITEBYTECODE="1",
                                PATH="%s:%s" % (programs, os.environ["PATH"]), npm_config_offline="true", npm_config_audit="false",
                                npm_config_fund="false", npm_config_update_notifier="false")
        self._shell = None
        self._ended, self._running = os.pipe()

    def paste(self, commands, folder):
        """Runs all of them in one shell, until the last has ended; what they start in the background goes on."""
        self._shell = subprocess.Popen(["bash", "-ec", "\n".join(commands)], cwd=folder, env=self.environment,
                                       stdout=subprocess.DEVNULL, start_new_session=True, pass_fds=[self._running])
        if self._shell.wait(LIMIT_S) != 0:
            raise subprocess.CalledProcessError(self._shell.returncode, commands)

    def close(self):
        """Ends what still runs, and waits for it."""
        os.close(self._running)
        if self._shell is not None:
            try:
                os.killpg(self._shell.pid, signal.SIGTERM)
            except ProcessLookupError:
                pass
            self._shell.wait()
        # The end of the pipe: no process has it any more.
        os.read(self._ended, 1)
        os.close(self._ended)
