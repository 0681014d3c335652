"""Tabs of a studio whose simulator is a toy: what they say and hear."""

import asyncio
import json
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

from ropsim.studio.testing import Session, Tab
from support.patience import PATIENCE


class Page:
    """A tab whose messages are read as they are sent."""

    def __init__(self, session: Session, name: str) -> None:
        self.session = session
        self.name = name
        self.tab = Tab()
        self.got: list[dict[str, Any]] = []
        self._news = asyncio.Event()
        self._pump = asyncio.create_task(self.tab.pump(self._take, self._take_frame))

    async def say(self, **message: object) -> None:
        await self.session.receive(self.tab, json.dumps(message))

    async def hear(self, kind: str, **fields: object) -> dict[str, Any]:
        """Wait for a message with these fields, and forget it and all before it."""
        while True:
            for index, one in enumerate(self.got):
                if one["type"] == kind and all(one.get(name) == value for name, value in fields.items()):
                    del self.got[: index + 1]
                    return one
            self._news.clear()
            await self._news.wait()

    async def leave(self) -> None:
        self.tab.close()
        await self._pump
        await self.session.leave(self.tab)

    async def _take(self, text: str) -> None:
        self.got.append(json.loads(text))
        self._news.set()

    async def _take_frame(self, frame: bytes) -> None:
        self.got.append({"type": "frame", "content": frame})
        self._news.set()


def in_session(folder: Path, play: Callable[[Callable[[str], Awaitable[Page]]], Awaitable[None]]) -> None:
    """Play with pages of a session, which ends afterwards."""

    async def run() -> None:
        session = Session(folder, folder.parent, "support.toy_worker:main")
        await session.open()

        async def page(name: str) -> Page:
            page = Page(session, name)
            await page.say(type="hello", tab=name)
            return page

        try:
            await asyncio.wait_for(play(page), PATIENCE)
        finally:
            await session.close()

    asyncio.run(run())
