# SPDX-License-Identifier: MIT
"""hedgehogd --simulate for the tests of the client libraries, an address that outlives it, and a time limit for processes."""

import hashlib
import json
import os
import re
import socket
import ssl
import subprocess
import tempfile
import threading

# Far more than a busy machine needs, so that only processes that hang are killed.
LIMIT_S = 240.0
# The simulated board keeps step with the control loop: a busy machine makes both late, but does not lose the board.
SIMULATE = ("--simulate", "--speed", "1")


def limit(process):
    """Kills the process after LIMIT_S, so that a reader of its output reaches the end. Cancel the returned timer."""
    timer = threading.Timer(LIMIT_S, process.kill)
    timer.daemon = True
    timer.start()
    return timer


class LiveDaemon:
    """Listens once constructed; also with TLS at `tls_address`, with `fingerprint`, for clients with `token` (of `role`). Its pages,
    and WebSocket, are at `pages_address` if `pages` is where to listen, such as "tls://127.0.0.1:0"."""

    def __init__(self, program, role="play", pages=None):
        self._folder = tempfile.TemporaryDirectory()
        self.token = "hht_of-a-test"
        self.fingerprint = self._make_access(os.path.join(self._folder.name, "hedgehog"), role)
        environment = dict(os.environ)
        for name in ("HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"):
            environment[name] = self._folder.name
        for name in ("RUNTIME_DIRECTORY", "STATE_DIRECTORY"):
            environment.pop(name, None)
        if pages:
            with open(os.path.join(self._folder.name, "hedgehog", "hedgehogd.json"), "w", encoding="ascii") as config:
                json.dump({"http": {"listen": pages}}, config)
        self._process = subprocess.Popen([program, *SIMULATE, "--listen", "tls://127.0.0.1:0", "--listen", "127.0.0.1:0"],
                                         env=environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        timer = limit(self._process)
        self.address = ""
        self.tls_address = ""
        self.pages_address = ""
        for line in self._process.stdout:
            found = re.match(r"listening on ((tls|http|https)://)?(127\.0\.0\.1:\d+)$", line)
            if not found:
                break  # the Unix socket, the last one
            if found.group(2) == "tls":
                self.tls_address = "tls://" + found.group(3)
            elif found.group(2):
                self.pages_address = found.group(1) + found.group(3)
            else:
                self.address = found.group(3)
        timer.cancel()
        if not self.address:
            self.stop()
            raise RuntimeError("the daemon does not listen")

    def _make_access(self, state, role):
        """Creates a certificate and a token with tools other than hedgehogctl; returns the fingerprint."""
        os.makedirs(state)
        certificate = os.path.join(state, "certificate.pem")
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-days", "30",
                        "-subj", "/CN=ball-host", "-keyout", os.path.join(state, "key.pem"), "-out", certificate],
                       check=True, stderr=subprocess.DEVNULL)
        with open(os.path.join(state, "tokens"), "w", encoding="ascii") as tokens:
            tokens.write("arcade %s sha256:%s 2026-11-24\n" % (role, hashlib.sha256(self.token.encode("ascii")).hexdigest()))
        with open(certificate, encoding="ascii") as text:
            return hashlib.sha256(ssl.PEM_cert_to_DER_cert(text.read())).hexdigest()

    def stop(self):
        self._process.terminate()
        timer = limit(self._process)
        self._process.wait()
        timer.cancel()
        self._process.stdout.close()
        self._folder.cleanup()


class Tunnel:
    """`hedgehogctl tunnel` of the same build to `tls_address` of a LiveDaemon; at `address`, once it is made, no token is needed."""

    def __init__(self, program, daemon, port=0):
        ctl = os.path.join(os.path.dirname(program), "..", "clients", "ctl", "hedgehogctl")
        environment = dict(os.environ, HEDGEHOG_TOKEN=daemon.token, HEDGEHOG_FINGERPRINT=daemon.fingerprint)
        self._process = subprocess.Popen([ctl, "tunnel", daemon.tls_address, "--port", str(port)], env=environment,
                                         stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        timer = limit(self._process)
        found = re.match(r"HEDGEHOG_ADDRESS=(127\.0\.0\.1:(\d+))$", self._process.stdout.readline())
        timer.cancel()
        if not found:
            self.stop()
            raise RuntimeError("the tunnel does not listen")
        self.address = found.group(1)
        self.port = int(found.group(2))

    def stop(self):
        self._process.terminate()
        timer = limit(self._process)
        self._process.wait()
        timer.cancel()
        self._process.stdout.close()


class ForwardedAddress:
    """An address that stays the same while the daemons behind it change, as with ssh -L."""

    def __init__(self):
        self._server = socket.create_server(("127.0.0.1", 0))
        self._target = None
        self._sent = []
        self.text = "127.0.0.1:%d" % self._server.getsockname()[1]
        self._thread = threading.Thread(target=self._accept, daemon=True)
        self._thread.start()

    def lead_to(self, daemon):
        """Forwards new connections to this daemon; while it does not listen, they are closed."""
        host, _, port = daemon.address.partition(":")
        self._target = (host, int(port))

    def requests(self):
        """The lines that clients have sent, decoded, of one connection after the other."""
        return [json.loads(line) for sent in self._sent for line in bytes(sent).split(b"\n")[:-1] if line.strip()]

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
                back = threading.Thread(target=self._pump, args=(daemon, client, bytearray()), daemon=True)
                back.start()
                sent = bytearray()
                self._sent.append(sent)
                self._pump(client, daemon, sent)
                back.join()

    @staticmethod
    def _pump(source, sink, passed):
        try:
            while True:
                data = source.recv(1 << 16)
                if not data:
                    break
                passed += data
                sink.sendall(data)
        except OSError:
            pass
        for one in (source, sink):
            try:
                one.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
