"""The sockets of a page: `/ws/studio` for the session, `/ws/lsp` for the language server."""

import asyncio
import contextlib
from pathlib import Path

from starlette.routing import WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from ropsim.studio.language_bridge import LanguageBridge
from ropsim.studio.session import Session
from ropsim.studio.tab import Tab


def routes(session: Session, neutral: Path) -> list[WebSocketRoute]:
    """Return both sockets; language servers work in the `neutral` folder."""

    async def studio(socket: WebSocket) -> None:
        await socket.accept()
        tab = Tab()
        pumping = asyncio.create_task(_pump(tab, socket))
        try:
            while True:
                message = await socket.receive()
                if message["type"] == "websocket.disconnect":
                    break
                await session.receive(tab, message.get("text") or message.get("bytes") or b"")
        finally:
            tab.close()
            pumping.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await pumping
            await session.leave(tab)

    async def language(socket: WebSocket) -> None:
        await socket.accept()
        await LanguageBridge(socket, neutral).serve()

    return [WebSocketRoute("/ws/studio", studio), WebSocketRoute("/ws/lsp", language)]


async def _pump(tab: Tab, socket: WebSocket) -> None:
    with contextlib.suppress(WebSocketDisconnect, RuntimeError):  # the page has gone while something was sent
        await tab.pump(socket.send_text, socket.send_bytes)
        await socket.close(1013)
