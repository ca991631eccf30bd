# SPDX-License-Identifier: MIT
"""The client for asyncio."""

import asyncio
import os
import time
from typing import Any, AsyncIterator, Callable, Dict, Iterable, List, Mapping, Optional, Tuple

from .address import Address, MdnsAddress, TlsAddress, daemon_addresses
from .backoff import Backoff, nobody_there, share_of
from .discovery import BallNotFound, locate
from .errors import NotConnected, RequestError, SubscriptionEnded
from .exchange import Exchange
from .messages import Direction, Event, EventType, Hello, Scope, Telemetry, TelemetryField
from .methods import AsyncMethods
from .notifications import MAX_WAITING
from .rumble import rumble_params
from .subscriptions import Subscriptions
from .tls import check_certificate, tls_context

#: What a daemon that does not read may leave unsent, in bytes.
MAX_UNSENT = 1 << 20


class AsyncBall(AsyncMethods):
    """As `Ball`, in one event loop; several tasks may wait for responses at once. Its iterators end with their connection.

    async with AsyncBall() as ball:
        await ball.pulse("left", level=0.5, on_close="finish")
    """

    def __init__(self, address: Optional[str] = None, *, name: str = "python", timeout_s: float = 2.0,
                 token: Optional[str] = None, fingerprint: Optional[str] = None,
                 on_reconnect: Optional[Callable[[Hello], None]] = None,
                 on_subscription_ended: Optional[Callable[[SubscriptionEnded], None]] = None) -> None:
        self._addresses = daemon_addresses(address, fingerprint=fingerprint)
        self._hello: Dict[str, Any] = {"client": name, "protocol": "1",
                                       "token": token or os.environ.get("HEDGEHOG_TOKEN") or None}
        self._timeout_s = timeout_s
        self._backoff = Backoff()
        self._connecting = asyncio.Lock()
        self._writer: Optional[asyncio.StreamWriter] = None
        self._reader_task: Optional["asyncio.Task[None]"] = None
        self._exchange = Exchange()
        self._waiting: Dict[int, "asyncio.Future[None]"] = {}
        self._subscribers: List["asyncio.Queue[Any]"] = []
        self._subscriptions = Subscriptions()
        self._on_reconnect = on_reconnect
        self._on_subscription_ended = on_subscription_ended
        self._connections = 0
        self._welcome: Optional[Hello] = None
        #: Of the last introduction that the daemon refused.
        self._refusal: Optional[RequestError] = None
        self._closed = False

    async def __aenter__(self) -> "AsyncBall":
        await self._ensure()
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.close()

    async def close(self) -> None:
        """Ends the connection, and with it its effects."""
        self._closed = True
        task = self._reader_task
        self._end("this ball is closed")
        if task is not None:
            task.cancel()
            await asyncio.gather(task, return_exceptions=True)

    @property
    def connected(self) -> bool:
        return self._writer is not None

    @property
    def hello(self) -> Hello:
        """What the daemon said of itself: server, role, limits. REQUIRES: it was connected once."""
        assert self._welcome is not None
        return self._welcome

    async def call(self, method: str, /, **params: Any) -> Any:
        """The result of a method. Raises RequestError when the daemon refuses, NotConnected when there is none."""
        await self._ensure()
        change = self._subscriptions.sent(method, params)
        result = await self._ask(method, params)
        self._subscriptions.carried_out(change)
        return result

    async def notify(self, method: str, /, **params: Any) -> bool:
        """Sends without waiting for a response. False: nothing was sent, there is no daemon, or it refuses the introduction."""
        if not await self._is_there() or not self._write(self._exchange.notification(method, params)):
            return False
        self._subscriptions.carried_out(self._subscriptions.sent(method, params))
        return True

    async def rumble(self, slot: str, strength: float, direction: Optional[Direction] = None, **params: Any) -> bool:
        """A vibration that goes on while this is called every frame; strength 0..1, 0 ends it. As `notify`."""
        if not strength > 0.0:
            return await self.notify("effect.stop", slot=slot)
        if not await self._is_there():
            return False
        return await self.notify("effect.vibrate", direction=direction,
                                 **rumble_params(slot, strength, self.hello["limits"], params))

    async def events(self, types: Optional[Iterable[EventType]] = None, *,
                     scope: Optional[Scope] = None) -> AsyncIterator[Event]:
        """Events as they come. Raises NotConnected when the connection ends."""
        async for params in self._subscribed("event", "events.subscribe", {
                "types": list(types) if types is not None else None, "scope": scope}):
            yield params

    async def telemetry(self, rate_hz: float = 10.0,
                        fields: Optional[Iterable[TelemetryField]] = None) -> AsyncIterator[Telemetry]:
        """The status again and again. Raises NotConnected when the connection ends."""
        async for params in self._subscribed("telemetry", "telemetry.subscribe", {
                "rate_hz": rate_hz, "fields": list(fields) if fields is not None else None}):
            yield params

    async def _subscribed(self, method: str, subscribe: str,
                          params: Mapping[str, Any]) -> AsyncIterator[Any]:
        queue: "asyncio.Queue[Any]" = asyncio.Queue(MAX_WAITING)
        self._subscribers.append(queue)
        try:
            await self.call(subscribe, **params)
            while True:
                received = await queue.get()
                if isinstance(received, NotConnected):
                    raise received
                if received[0] == method:
                    yield received[1]
        finally:
            self._subscribers.remove(queue)

    async def _is_there(self) -> bool:
        try:
            await self._ensure()
        except NotConnected:
            return False
        except RequestError as error:
            if error is not self._refusal:
                raise
            return False
        return True

    async def _ensure(self) -> None:
        async with self._connecting:
            if self._closed:
                raise NotConnected("this ball is closed")
            if self._writer is not None:
                return
            wait_s = self._backoff.remaining_s(time.monotonic())
            if wait_s > 0.0:
                raise NotConnected("the daemon does not run; next attempt in %.1f s" % wait_s, wait_s)
            await self._connect()

    async def _connect(self) -> None:
        tried: List[Address] = []
        why: List[str] = []
        addresses = self._addresses
        try:
            if any(isinstance(address, MdnsAddress) for address in addresses):
                addresses = await asyncio.get_running_loop().run_in_executor(None, locate, addresses)
        except (BallNotFound, OSError) as error:
            now = time.monotonic()
            self._backoff.failed(now)
            raise NotConnected(str(error), self._backoff.remaining_s(now)) from error
        # One for all addresses and the introduction.
        deadline = time.monotonic() + self._timeout_s
        for address in addresses:
            try:
                reader, self._writer = await asyncio.wait_for(_open(address), share_of(deadline, len(addresses) - len(tried)))
                break
            except (OSError, UnicodeError, asyncio.TimeoutError) as error:
                # UnicodeError: a host name that cannot be encoded, as "a..b".
                tried.append(address)
                why.append(getattr(error, "strerror", None) or str(error) or "no answer")
        if self._writer is None:
            now = time.monotonic()
            self._backoff.failed(now)
            raise nobody_there(tried, why, self._backoff.remaining_s(now))
        self._exchange = Exchange()
        self._reader_task = asyncio.ensure_future(self._read(reader, self._writer))
        try:
            self._welcome = await self._ask("hello", self._hello, share_of(deadline))
        except BaseException as refused:
            # Refused, lost or cancelled: half a connection is none.
            if isinstance(refused, RequestError):
                self._refusal = refused
            self._end(str(refused))
            raise
        self._backoff.succeeded()
        for line in self._subscriptions.renew(self._exchange):
            self._write(line)
        self._connections += 1
        if self._connections > 1 and self._on_reconnect is not None:
            self._on_reconnect(self.hello)

    def _write(self, line: bytes) -> bool:
        """False: the connection has ended."""
        if self._writer is None:
            return False
        self._writer.write(line)
        if self._writer.transport.get_write_buffer_size() <= MAX_UNSENT:
            return True
        # What is left would be kept until the daemon reads.
        self._writer.transport.abort()
        self._end("the daemon does not read from the connection")
        return False

    async def _ask(self, method: str, params: Mapping[str, Any], timeout_s: Optional[float] = None) -> Any:
        if self._writer is None:
            raise NotConnected("the connection to the daemon has ended")
        exchange = self._exchange
        request, line = exchange.request(method, params)
        arrived = asyncio.get_running_loop().create_future()
        self._waiting[request] = arrived
        self._write(line)
        try:
            await asyncio.wait_for(arrived, self._timeout_s if timeout_s is None else timeout_s)
            response = exchange.take_response(request)
        except asyncio.TimeoutError:
            raise self._end("%s: no response within %g s" % (method, self._timeout_s)) from None
        finally:
            self._waiting.pop(request, None)
            exchange.forget(request)
        assert response is not None
        return response[0]

    async def _read(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        why, retry_after_s = "the daemon closed it", 0.0
        exchange = self._exchange
        try:
            while True:
                data = await reader.read(1 << 16)
                if not data or self._writer is not writer:
                    break
                self._sort(data)
            why, retry_after_s = exchange.reason_of_end(why)
        except OSError as error:
            why, retry_after_s = exchange.reason_of_end(error.strerror or str(error))
        except ValueError as error:
            why = "the server is not a Hedgehog daemon: %s" % error
        # Not of a connection that has followed.
        if self._writer is writer:
            self._end(why, retry_after_s)

    def _sort(self, data: bytes) -> None:
        for request in self._exchange.receive(data):
            ended = self._subscriptions.answered(request, self._exchange)
            if ended is not None and self._on_subscription_ended is not None:
                asyncio.get_running_loop().call_soon(self._on_subscription_ended, ended)
            waiting = self._waiting.get(request)
            if waiting is not None and not waiting.done():
                waiting.set_result(None)
        while True:
            received = self._exchange.notifications.take()
            if received is None:
                break
            self._publish(received)

    def _publish(self, received: Any) -> None:
        for queue in self._subscribers:
            if queue.full():
                queue.get_nowait()
            queue.put_nowait(received)

    def _end(self, why: str, retry_after_s: float = 0.0) -> NotConnected:
        """Everybody who waits is told."""
        now = time.monotonic()
        if self._writer is not None:
            self._writer.close()
            self._writer = None
            self._backoff.failed(now, retry_after_s)
        lost = NotConnected("the connection to the daemon has ended: %s" % why, self._backoff.remaining_s(now))
        for waiting in self._waiting.values():
            if not waiting.done():
                waiting.set_exception(lost)
        self._publish(lost)
        return lost


async def _open(address: Address) -> Tuple[asyncio.StreamReader, asyncio.StreamWriter]:
    if isinstance(address, str):
        if not hasattr(asyncio, "open_unix_connection"):
            raise OSError("this system has no Unix sockets")
        return await asyncio.open_unix_connection(address)
    if isinstance(address, TlsAddress):
        reader, writer = await asyncio.open_connection(address.host, address.port, ssl=tls_context(address),
                                                       server_hostname=address.host)
        try:
            check_certificate(address, writer.get_extra_info("ssl_object").getpeercert(True))
        except OSError:
            writer.close()
            raise
        return reader, writer
    # `locate` has replaced it.
    assert not isinstance(address, MdnsAddress)
    host, port = address
    return await asyncio.open_connection(host, port)
