"""A tab of the browser: its queue of messages. All messages arrive, of state frames the newest."""

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable

from ropsim.studio.wire.messages import Message, wire

MOST_FRAMES = 3
MOST_WAITING = 64_000_000
"""A tab that lets more wait has stopped reading [bytes]."""


class Tab:
    """One connection. `name` is the name of the browser's tab, empty until it has said it."""

    def __init__(self) -> None:
        self.name = ""
        self._messages: deque[bytes] = deque()
        self._frames: deque[bytes] = deque(maxlen=MOST_FRAMES)
        self._waiting = 0
        self._something = asyncio.Event()
        self._closed = asyncio.Event()

    def send(self, message: Message) -> None:
        """Queue a message."""
        self.send_text(wire(message))

    @property
    def closed(self) -> bool:
        """Return whether nothing is sent any more."""
        return self._closed.is_set()

    def send_text(self, text: bytes) -> None:
        """Queue a message that is JSON already."""
        if self.closed:
            return
        self._messages.append(text)
        self._waiting += len(text)
        self._something.set()
        if self._waiting > MOST_WAITING:
            self.close()

    def send_frame(self, frame: bytes) -> None:
        """Queue a state frame; the oldest waiting one is dropped."""
        if not self.closed:
            self._frames.append(frame)
            self._something.set()

    def close(self) -> None:
        """Let `pump` end and drop unsent messages."""
        self._closed.set()
        self._messages.clear()
        self._frames.clear()

    async def wait_closed(self) -> None:
        """Return as soon as the tab is closed."""
        await self._closed.wait()

    async def pump(
        self, send_text: Callable[[str], Awaitable[None]], send_bytes: Callable[[bytes], Awaitable[None]]
    ) -> None:
        """Send the queue, messages first, until the tab is closed, even if the page reads nothing."""
        if self.closed:
            return
        sending = asyncio.create_task(self._send_all(send_text, send_bytes))
        closing = asyncio.create_task(self.wait_closed())
        try:
            await asyncio.wait((sending, closing), return_when=asyncio.FIRST_COMPLETED)
        finally:
            sending.cancel()
            closing.cancel()
        if sending.done():
            sending.result()  # raises the error of the socket

    async def _send_all(
        self, send_text: Callable[[str], Awaitable[None]], send_bytes: Callable[[bytes], Awaitable[None]]
    ) -> None:
        while True:
            await self._something.wait()
            self._something.clear()
            while self._messages or self._frames:
                if self._messages:
                    text = self._messages.popleft()
                    self._waiting -= len(text)
                    await send_text(text.decode())
                else:
                    await send_bytes(self._frames.popleft())
