# SPDX-License-Identifier: MIT
"""hedgehogd --simulate for the tests of the client libraries, an address that outlives it, and a limit for what a test starts."""

import os
import re
import socket
import subprocess
import tempfile
import threading

# Far beyond what a busy machine takes: only what hangs is ended.
LIMIT_S = 240.0


def limit(process):
    """Ends the process when it takes too long, so that whoever reads its output comes to the end. Cancel the timer that is returned."""
    timer = threading.Timer(LIMIT_S, process.kill)
    timer.daemon = True
    timer.start()
    return timer


class LiveDaemon:
    """Listens once it is made."""

    def __init__(self, program):
        self._folder = tempfile.TemporaryDirectory()
        environment = dict(os.environ)
        for name in ("HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"):
            environment[name] = self._folder.name
        for name in ("RUNTIME_DIRECTORY", "STATE_DIRECTORY"):
            environment.pop(name, None)
        self._process = subprocess.Popen([program, "--simulate", "--listen", "127.0.0.1:0"], env=environment,
                                         stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        timer = limit(self._process)
        self.address = ""
        for line in self._process.stdout:
            found = re.match(r"listening on (127\.0\.0\.1:\d+)$", line)
            if found:
                self.address = found.group(1)
                break
        timer.cancel()
        if not self.address:
            self.stop()
            raise RuntimeError("the daemon does not listen")

    def stop(self):
        self._process.terminate()
        timer = limit(self._process)
        self._process.wait()
        timer.cancel()
        self._process.stdout.close()
        self._folder.cleanup()


class ForwardedAddress:
    """Stays the test's own while daemons behind it come and go, as ssh -L forwards one."""

    def __init__(self):
        self._server = socket.create_server(("127.0.0.1", 0))
        self._target = None
        self.text = "127.0.0.1:%d" % self._server.getsockname()[1]
        self._thread = threading.Thread(target=self._accept, daemon=True)
        self._thread.start()

    def lead_to(self, daemon):
        """New connections go to this daemon; while it does not listen, they are closed."""
        host, _, port = daemon.address.partition(":")
        self._target = (host, int(port))

    def end(self):
        self._server.shutdown(socket.SHUT_RDWR)
        self._thread.join()
        self._server.close()

    def _accept(self):
        while True:
            try:
                client, _ = self._server.accept()
            except OSError:
                return
            threading.Thread(target=self._forward, args=(client,), daemon=True).start()

    def _forward(self, client):
        with client:
            try:
                daemon = socket.create_connection(self._target)
            except OSError:
                return
            with daemon:
                back = threading.Thread(target=self._pump, args=(daemon, client), daemon=True)
                back.start()
                self._pump(client, daemon)
                back.join()

    @staticmethod
    def _pump(source, sink):
        try:
            while True:
                data = source.recv(1 << 16)
                if not data:
                    break
                sink.sendall(data)
        except OSError:
            pass
        for one in (source, sink):
            try:
                one.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
