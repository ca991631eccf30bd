# SPDX-License-Identifier: MIT
"""The client that blocks."""

import contextlib
import os
import socket
import ssl
import threading
import time
from collections import deque
from typing import Any, Callable, Deque, Dict, Iterable, Iterator, List, Mapping, Optional, Tuple, cast

from .address import Address, daemon_addresses
from .backoff import Backoff, nobody_there, share_of
from .discovery import BallNotFound, locate
from .errors import NotConnected, RequestError, SubscriptionEnded
from .exchange import Exchange
from .messages import Direction, Event, EventType, Hello, Scope, Telemetry, TelemetryField
from .methods import Methods
from .rumble import rumble_params
from .sockets import open_socket
from .subscriptions import Subscriptions

#: The longest that waiting for a notification keeps other threads from calling.
SLICE_S = 0.02


class Ball(Methods):
    """A connection to the daemon; the effects of a connection end with it.

    address: "127.0.0.1:7586", "/run/hedgehog/hedgehogd.sock", "mdns://ball-7"; None: found as by every client (address.py).
    name: of this program, as the daemon's log and `hedgehogctl clients` show it. timeout_s: the longest that
    connecting, and waiting for a response, take. token: of roles beyond those of this machine, else HEDGEHOG_TOKEN.
    fingerprint: of the daemon's certificate with "tls://host:port", else HEDGEHOG_FINGERPRINT.
    on_reconnect: called with the daemon's introduction after each connection but the first.
    May be used from several threads; their calls go one after the other. After a lost connection the next call
    connects anew, no more often than its back-off allows. What the program subscribed to is subscribed to again;
    its effects are not made again.
    """

    def __init__(self, address: Optional[str] = None, *, name: str = "python", timeout_s: float = 2.0,
                 token: Optional[str] = None, fingerprint: Optional[str] = None,
                 on_reconnect: Optional[Callable[[Hello], None]] = None,
                 on_subscription_ended: Optional[Callable[[SubscriptionEnded], None]] = None) -> None:
        self._addresses = daemon_addresses(address, fingerprint=fingerprint)
        self._hello: Dict[str, Any] = {"client": name, "protocol": "1",
                                       "token": token or os.environ.get("HEDGEHOG_TOKEN") or None}
        self._timeout_s = timeout_s
        self._lock = threading.RLock()
        self._backoff = Backoff()
        self._socket: Optional[socket.socket] = None
        self._exchange = Exchange()
        self._subscriptions = Subscriptions()
        self._on_subscription_ended = on_subscription_ended
        self._unreported: Deque[SubscriptionEnded] = deque()
        self._on_reconnect: Optional[Callable[[Hello], None]] = None
        self._welcome: Optional[Hello] = None
        #: Of the last introduction that the daemon refused.
        self._refusal: Optional[RequestError] = None
        self._closed = False
        self._connect()
        self._on_reconnect = on_reconnect

    def __enter__(self) -> "Ball":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Ends the connection, and with it its effects."""
        with self._lock:
            self._closed = True
            self._drop()

    @property
    def connected(self) -> bool:
        return self._socket is not None

    @property
    def hello(self) -> Hello:
        """What the daemon said of itself: server, role, limits."""
        assert self._welcome is not None
        return self._welcome

    def call(self, method: str, /, **params: Any) -> Any:
        """The result of a method. Raises RequestError when the daemon refuses, NotConnected when there is none."""
        with self._turn():
            self._ensure()
            change = self._subscriptions.sent(method, params)
            result = self._ask(method, params)
            self._subscriptions.carried_out(change)
            return result

    def notify(self, method: str, /, **params: Any) -> bool:
        """Sends without waiting for a response. False: nothing was sent, there is no daemon, or it refuses the introduction. Waits
        up to `timeout_s` while it connects anew, and when the daemon does not read: a frame loop takes AsyncBall, or a thread."""
        with self._turn():
            try:
                self._ensure()
                self._send(self._exchange.notification(method, params))
                self._subscriptions.carried_out(self._subscriptions.sent(method, params))
                self._drain()
            except NotConnected:
                return False
            except RequestError as error:
                if error is not self._refusal:
                    raise
                return False
            return True

    def rumble(self, slot: str, strength: float, direction: Optional[Direction] = None, **params: Any) -> bool:
        """A vibration that goes on while this is called every frame; strength 0..1, 0 ends it. As `notify`."""
        with self._turn():
            if not strength > 0.0:
                return self.notify("effect.stop", slot=slot)
            return self.notify("effect.vibrate", direction=direction,
                               **rumble_params(slot, strength, self.hello["limits"], params))

    def events(self, types: Optional[Iterable[EventType]] = None, *, scope: Optional[Scope] = None,
               timeout_s: Optional[float] = None) -> Iterator[Event]:
        """Events as they come; ends when none came for `timeout_s` (None: never). Raises NotConnected, and SubscriptionEnded when
        a new connection could not renew them."""
        self.call("events.subscribe", types=list(types) if types is not None else None, scope=scope)
        return cast(Iterator[Event], self._notifications("event", "events", timeout_s))

    def telemetry(self, rate_hz: float = 10.0, fields: Optional[Iterable[TelemetryField]] = None, *,
                  timeout_s: Optional[float] = None) -> Iterator[Telemetry]:
        """The status again and again. Raises as `events`."""
        self.call("telemetry.subscribe", rate_hz=rate_hz, fields=list(fields) if fields is not None else None)
        return cast(Iterator[Telemetry], self._notifications("telemetry", "telemetry", timeout_s))

    def next_notification(self, timeout_s: float = 0.0) -> Optional[Tuple[str, Mapping[str, Any]]]:
        """The next notification, as method and parameters; None: none came. Raises NotConnected."""
        return self._next(timeout_s)

    def _next(self, timeout_s: float, method: str = "", kind: str = "") -> Optional[Tuple[str, Mapping[str, Any]]]:
        """`method`: of which notifications, "": of all. `kind`: raises when that subscription has ended and nothing is left of it."""
        deadline = time.monotonic() + timeout_s
        while True:
            # Others may call in between.
            with self._turn():
                received = self._exchange.notifications.take(method)
                if received is None:
                    ended = self._subscriptions.ended(kind)
                    if ended is not None:
                        raise ended
                    self._receive(min(SLICE_S, max(0.0, deadline - time.monotonic())))
                    received = self._exchange.notifications.take(method)
                if received is not None:
                    return received
            if time.monotonic() >= deadline:
                return None
            time.sleep(0)

    def _notifications(self, method: str, kind: str, timeout_s: Optional[float]) -> Iterator[Mapping[str, Any]]:
        while True:
            received = self._next(timeout_s if timeout_s is not None else 3600.0, method, kind)
            if received is not None:
                yield received[1]
            elif timeout_s is not None:
                return

    @contextlib.contextmanager
    def _turn(self) -> Iterator[None]:
        """One thread at a time; at the end what it has read is reported."""
        with self._lock:
            try:
                yield
            finally:
                while self._unreported:
                    ended = self._unreported.popleft()
                    if self._on_subscription_ended is not None:
                        self._on_subscription_ended(ended)

    def _connect(self) -> None:
        tried: List[Address] = []
        why: List[str] = []
        try:
            addresses = locate(self._addresses)
        except (BallNotFound, OSError) as error:
            now = time.monotonic()
            self._backoff.failed(now)
            raise NotConnected(str(error), self._backoff.remaining_s(now)) from error
        # One for all addresses and the introduction.
        deadline = time.monotonic() + self._timeout_s
        for address in addresses:
            try:
                self._socket = open_socket(address, share_of(deadline, len(addresses) - len(tried)))
                break
            except (OSError, UnicodeError) as error:
                # UnicodeError: a host name that cannot be encoded, as "a..b".
                tried.append(address)
                why.append(getattr(error, "strerror", None) or str(error))
        if self._socket is None:
            now = time.monotonic()
            self._backoff.failed(now)
            raise nobody_there(tried, why, self._backoff.remaining_s(now))
        self._exchange = Exchange()
        try:
            self._welcome = self._ask("hello", self._hello, deadline)
        except RequestError as error:
            self._refusal = error
            self._drop()
            self._backoff.failed(time.monotonic())
            raise
        self._backoff.succeeded()
        for line in self._subscriptions.renew(self._exchange):
            self._send(line)
        if self._on_reconnect is not None:
            self._on_reconnect(self.hello)

    def _ensure(self) -> None:
        if self._closed:
            raise NotConnected("this Ball is closed")
        if self._socket is not None:
            return
        wait_s = self._backoff.remaining_s(time.monotonic())
        if wait_s > 0.0:
            raise NotConnected("the daemon does not run; next attempt in %.1f s" % wait_s, wait_s)
        self._connect()

    def _ask(self, method: str, params: Mapping[str, Any], deadline: Optional[float] = None) -> Any:
        request, line = self._exchange.request(method, params)
        if deadline is None:
            deadline = time.monotonic() + self._timeout_s
        self._send(line, deadline)
        while True:
            response = self._exchange.take_response(request)
            if response is not None:
                return response[0]
            if not self._receive(deadline - time.monotonic()):
                self._exchange.forget(request)
                raise self._lost("%s: no response within %g s" % (method, self._timeout_s))

    def _send(self, line: bytes, deadline: Optional[float] = None) -> None:
        assert self._socket is not None
        try:
            self._socket.settimeout(self._timeout_s if deadline is None else share_of(deadline))
            self._socket.sendall(line)
        except socket.timeout as error:
            raise self._lost("the daemon does not read from the connection") from error
        except OSError as error:
            self._read_rest()
            raise self._lost(*self._exchange.reason_of_end(error.strerror or str(error))) from error

    def _receive(self, timeout_s: float) -> bool:
        """Whether something came."""
        if self._socket is None:
            raise NotConnected("the connection to the daemon has ended")
        try:
            self._socket.settimeout(max(timeout_s, 0.0))
            data = self._socket.recv(1 << 16)
        except (socket.timeout, BlockingIOError, ssl.SSLWantReadError):
            return False
        except OSError as error:
            raise self._lost(*self._exchange.reason_of_end(error.strerror or str(error))) from error
        if not data:
            raise self._lost(*self._exchange.reason_of_end("the daemon closed it"))
        try:
            arrived = self._exchange.receive(data)
        except ValueError as error:
            raise self._lost("the server is not a Hedgehog daemon: %s" % error) from error
        for request in arrived:
            ended = self._subscriptions.answered(request, self._exchange)
            if ended is not None:
                self._unreported.append(ended)
        return True

    def _drain(self) -> None:
        """What the daemon sends is read, or it would cut this connection."""
        while self._receive(0.0):
            pass

    def _read_rest(self) -> None:
        """What the daemon sent before it closed the connection: it may say why."""
        assert self._socket is not None
        try:
            self._socket.settimeout(0.0)
            while True:
                data = self._socket.recv(1 << 16)
                if not data:
                    return
                self._exchange.receive(data)
        except (OSError, ValueError):
            return

    def _lost(self, why: str, retry_after_s: float = 0.0) -> NotConnected:
        self._drop()
        now = time.monotonic()
        self._backoff.failed(now, retry_after_s)
        return NotConnected("the connection to the daemon has ended: %s" % why, self._backoff.remaining_s(now))

    def _drop(self) -> None:
        if self._socket is not None:
            self._socket.close()
            self._socket = None
