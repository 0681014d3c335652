"""The sockets of a page: `/ws/studio` for the session, `/ws/lsp` for the language server."""

import asyncio
import contextlib
from pathlib import Path

from starlette.routing import WebSocketRoute
from starlette.types import Message
from starlette.websockets import WebSocket, WebSocketDisconnect

from ropsim.studio.processes.language_bridge import LanguageBridge
from ropsim.studio.session.tab import Tab
from ropsim.studio.session.workplace import Workplace
from ropsim.studio.web.entry import Entry

PARTING = 1.0
"""How long a page may take to hear that its socket is closed [s]."""

MOST_LANGUAGE_SERVERS = 12
"""Editors that are served at the same time; each has a process of its own."""


def routes(workplace: Workplace, entry: Entry, neutral: Path) -> list[WebSocketRoute]:
    """Return both sockets, on which pages enter first; language servers work in the `neutral` folder."""

    async def studio(socket: WebSocket) -> None:
        await socket.accept()
        if not await entry.admits(socket):
            return
        tab, session = Tab(), workplace.session
        pumping = asyncio.create_task(_pump(tab, socket))
        try:
            while (message := await _received(tab, socket)) is not None:
                await session.receive(tab, message.get("text") or message.get("bytes") or b"")
        finally:
            tab.close()
            with contextlib.suppress(asyncio.CancelledError):
                await pumping
            await session.leave(tab)

    places = asyncio.Semaphore(MOST_LANGUAGE_SERVERS)

    async def language(socket: WebSocket) -> None:
        if places.locked():
            await socket.close()  # not accepted: the page tries again later, and ever less often
            return
        async with places:
            await socket.accept()
            if await entry.admits(socket):
                await LanguageBridge(socket, neutral).serve()

    return [WebSocketRoute("/ws/studio", studio), WebSocketRoute("/ws/lsp", language)]


async def _pump(tab: Tab, socket: WebSocket) -> None:
    with contextlib.suppress(WebSocketDisconnect, RuntimeError):  # the page was closed during sending
        await tab.pump(socket.send_text, socket.send_bytes)
    with contextlib.suppress(WebSocketDisconnect, RuntimeError, TimeoutError):
        await asyncio.wait_for(socket.close(1013), PARTING)


async def _received(tab: Tab, socket: WebSocket) -> Message | None:
    """Return the next message of the page, None once it is closed or the tab is closed from this side."""
    receiving = asyncio.create_task(socket.receive())
    closing = asyncio.create_task(tab.wait_closed())
    try:
        await asyncio.wait((receiving, closing), return_when=asyncio.FIRST_COMPLETED)
        message = receiving.result() if receiving.done() else None
    finally:
        receiving.cancel()
        closing.cancel()
    return None if message is None or message["type"] == "websocket.disconnect" else message
