"""A language server of its own for each editor: `ropsim lsp` as a child, its messages as socket texts."""

import asyncio
import contextlib
import os
import subprocess
import sys
from pathlib import Path

from starlette.websockets import WebSocket, WebSocketDisconnect, WebSocketState

LARGEST = 16_000_000
"""Longest message in either direction [bytes]: a text of the largest size, escaped."""

GOODBYE = 1.0
"""How long a language server may take to end by itself [s]."""


class LanguageBridge:
    """One socket and its language server; either end takes the other along."""

    def __init__(self, socket: WebSocket, folder: Path) -> None:
        self._socket = socket
        self._folder = folder

    async def serve(self) -> None:
        """Carry messages both ways until one side ends."""
        process = await _start(self._folder)
        if process.stdin is None or process.stdout is None:
            raise RuntimeError("a child that was started with pipes has them")
        up = asyncio.create_task(self._to_server(process.stdin))
        down = asyncio.create_task(self._to_page(process.stdout))
        try:
            await asyncio.wait((up, down), return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in (up, down):
                task.cancel()
            await asyncio.gather(up, down, return_exceptions=True)
            process.stdin.close()
            await _end(process)
            if self._socket.application_state is WebSocketState.CONNECTED:
                with contextlib.suppress(RuntimeError, WebSocketDisconnect):
                    await self._socket.close(1011, "the language server has ended")

    async def _to_server(self, sink: asyncio.StreamWriter) -> None:
        with contextlib.suppress(WebSocketDisconnect, ConnectionError):
            while True:
                content = (await self._socket.receive_text()).encode("utf-8", "replace")
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
                await self._socket.send_text((await source.readexactly(length)).decode())


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


async def _start(folder: Path) -> asyncio.subprocess.Process:
    """Start a language server that no Ctrl+C of the terminal reaches: it ends with its pipe."""
    flags = 0
    if sys.platform == "win32":
        flags = subprocess.CREATE_NEW_PROCESS_GROUP
    return await asyncio.create_subprocess_exec(
        sys.executable,
        "-P",
        "-m",
        "ropsim",
        "lsp",
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        cwd=folder,
        env={**os.environ, "PYTHONSAFEPATH": "1"},
        start_new_session=sys.platform != "win32",
        creationflags=flags,
        limit=LARGEST,
    )


async def _end(process: asyncio.subprocess.Process) -> None:
    """End a server whose pipe is closed, also when there is no time left to wait for it."""
    try:
        await asyncio.wait_for(process.wait(), GOODBYE)
    except (TimeoutError, asyncio.CancelledError) as error:
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        if isinstance(error, asyncio.CancelledError):
            raise
        await process.wait()
