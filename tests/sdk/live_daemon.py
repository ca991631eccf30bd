# SPDX-License-Identifier: MIT
"""hedgehogd --simulate for the tests of the client libraries, an address that outlives it, and a limit for what a test starts."""

import hashlib
import os
import re
import socket
import ssl
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
    """Listens once it is made; also with TLS at `tls_address`, with `fingerprint`, for who has `token` (the role play).

    `options`: of hedgehogd, besides --simulate.
    """

    def __init__(self, program, options=()):
        self._folder = tempfile.TemporaryDirectory()
        self.token = "hht_of-a-test"
        self.fingerprint = self._make_access(os.path.join(self._folder.name, "hedgehog"))
        environment = dict(os.environ)
        for name in ("HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"):
            environment[name] = self._folder.name
        for name in ("RUNTIME_DIRECTORY", "STATE_DIRECTORY"):
            environment.pop(name, None)
        self._process = subprocess.Popen([program, "--simulate", *options, "--listen", "tls://127.0.0.1:0", "--listen", "127.0.0.1:0"],
                                         env=environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        timer = limit(self._process)
        self.address = ""
        self.tls_address = ""
        for line in self._process.stdout:
            found = re.match(r"listening on ((tls://)?127\.0\.0\.1:\d+)$", line)
            if found and found.group(2):
                self.tls_address = found.group(1)
            elif found:
                self.address = found.group(1)
                break
        timer.cancel()
        if not self.address:
            self.stop()
            raise RuntimeError("the daemon does not listen")

    def _make_access(self, state):
        """A certificate and a token as other tools than hedgehogctl make them; the fingerprint."""
        os.makedirs(state)
        certificate = os.path.join(state, "certificate.pem")
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-days", "30",
                        "-subj", "/CN=ball-host", "-keyout", os.path.join(state, "key.pem"), "-out", certificate],
                       check=True, stderr=subprocess.DEVNULL)
        with open(os.path.join(state, "tokens"), "w", encoding="ascii") as tokens:
            tokens.write("arcade play sha256:%s 2026-11-24\n" % hashlib.sha256(self.token.encode("ascii")).hexdigest())
        with open(certificate, encoding="ascii") as text:
            return hashlib.sha256(ssl.PEM_cert_to_DER_cert(text.read())).hexdigest()

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
