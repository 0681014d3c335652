"""A language server of its own for each editor: a child with a socket, its messages as socket texts."""

import asyncio
import contextlib
import socket
from pathlib import Path

from starlette.websockets import WebSocket, WebSocketDisconnect, WebSocketState

from ropsim.studio.processes.child import Child

LARGEST = 16_000_000
"""Longest message in either direction [bytes]: a text of the largest size, escaped."""

GOODBYE = 1.0
"""How long a language server may take to end regularly [s]."""

_SERVER = "ropsim.studio.processes.language_server:serve_page"


class LanguageBridge:
    """One page and its language server; either end takes the other along."""

    def __init__(self, page: WebSocket, folder: Path) -> None:
        self._page = page
        self._folder = folder

    async def serve(self) -> None:
        """Carry messages both ways until one side ends."""
        near, far = socket.socketpair()
        child = await asyncio.to_thread(Child, "ropsim language", _SERVER, far, str(self._folder))
        source, sink = await asyncio.open_connection(sock=near, limit=LARGEST)
        up = asyncio.create_task(self._to_server(sink))
        down = asyncio.create_task(self._to_page(source))
        try:
            await asyncio.wait((up, down), return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in (up, down):
                task.cancel()
            await asyncio.gather(up, down, return_exceptions=True)
            sink.close()
            await _end(child)
            if self._page.application_state is WebSocketState.CONNECTED:
                with contextlib.suppress(RuntimeError, WebSocketDisconnect):
                    await self._page.close(1011, "the language server has ended")

    async def _to_server(self, sink: asyncio.StreamWriter) -> None:
        with contextlib.suppress(WebSocketDisconnect, ConnectionError):
            while True:
                content = (await self._page.receive_text()).encode("utf-8", "replace")
                if len(content) > LARGEST:
                    return
                sink.write(b"Content-Length: %d\r\n\r\n%b" % (len(content), content))
                await sink.drain()

    async def _to_page(self, source: asyncio.StreamReader) -> None:
        with contextlib.suppress(asyncio.IncompleteReadError, ConnectionError, RuntimeError, ValueError):
            while True:
                length = _length(await source.readuntil(b"\r\n\r\n"))
                if length > LARGEST:
                    return
                await self._page.send_text((await source.readexactly(length)).decode())


def _length(head: bytes) -> int:
    """Return the length that the head of a message announces.

    Raises:
        ValueError: it announces none.
    """
    for line in head.decode("ascii").split("\r\n"):
        name, _, value = line.partition(":")
        if name.strip().lower() == "content-length":
            return int(value)
    raise ValueError(head)


async def _end(child: Child) -> None:
    """End a server whose socket is closed, also when there is no time left to wait for it."""
    try:
        await asyncio.to_thread(child.has_ended, GOODBYE)
    finally:
        child.kill()
        child.exit_code()
