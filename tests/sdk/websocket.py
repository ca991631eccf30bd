# SPDX-License-Identifier: MIT
"""The server's side of a WebSocket (RFC 6455) with the two functions that fake_daemon.py needs: to read a message as a line, and to
encode a line as a text frame. For tests only: does not validate the client's frames."""

import base64
import hashlib
import struct

GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
TEXT, CLOSE = 1, 8


class WebSocketLines:
    def __init__(self, connection):
        self._connection = connection
        self._stream = connection.makefile("rb")
        headers = {}
        for line in iter(self._stream.readline, b"\r\n"):
            name, colon, value = line.decode("ascii").partition(":")
            if colon:
                headers[name.strip().lower()] = value.strip()
        accept = hashlib.sha1((headers["sec-websocket-key"] + GUID).encode("ascii")).digest()
        connection.sendall(b"HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                           b"Sec-WebSocket-Accept: " + base64.b64encode(accept) + b"\r\n\r\n")

    def readline(self):
        """The next message, as a line; empty: the client has closed."""
        message = b""
        while True:
            head = self._stream.read(2)
            if len(head) < 2:
                return b""
            length = head[1] & 0x7F
            if length >= 126:
                size = 2 if length == 126 else 8
                length = int.from_bytes(self._stream.read(size), "big")
            mask = self._stream.read(4)
            data = bytes(byte ^ mask[at % 4] for at, byte in enumerate(self._stream.read(length)))
            if head[0] & 0x0F == CLOSE:
                self._connection.sendall(self._frame(CLOSE, data))
                return b""
            message += data
            if head[0] & 0x80:
                return message + b"\n"

    def close(self):
        self._stream.close()

    @classmethod
    def encode(cls, data):
        """Encodes a line as a text frame, without its line end, as hedgehogd does."""
        return cls._frame(TEXT, data.rstrip(b"\n"))

    @staticmethod
    def _frame(opcode, data):
        if len(data) < 126:
            size = struct.pack("!B", len(data))
        elif len(data) < 1 << 16:
            size = struct.pack("!BH", 126, len(data))
        else:
            size = struct.pack("!BQ", 127, len(data))
        return bytes([0x80 | opcode]) + size + data
