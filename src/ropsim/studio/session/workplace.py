"""The open project of a studio; another one can take its place while the pages stay."""

import asyncio
from pathlib import Path

from ropsim.studio.processes.isolation import shut_out
from ropsim.studio.processes.workers import DESK
from ropsim.studio.session.place import Place, keep_place
from ropsim.studio.session.session import Session
from ropsim.userfiles import remember_project


class Workplace:
    """Holds the session; pages and sockets request it anew each time.

    Args:
        folder: of the project that is opened first.
        neutral: working folder of the workers, where no project lies.
        place: port and secret of this studio; each project that is opened in it is found there again.
        worker: `module:function` that runs in the worker processes.
    """

    def __init__(self, folder: Path, neutral: Path, place: Place, worker: str = DESK) -> None:
        self._neutral = neutral
        self._place = place
        self._worker = worker
        self._folder = folder
        self._switching = asyncio.Lock()
        self._tasks: set[asyncio.Task[None]] = set()
        self.session = self._made(folder)

    async def open(self) -> None:
        """Open the first project."""
        await self.session.open()
        await asyncio.to_thread(remember_project, self._folder)

    async def close(self) -> None:
        """Keep unsaved texts and end the workers."""
        async with self._switching:
            await self.session.close()

    def kill(self) -> None:
        """End the workers at once."""
        self.session.kill()

    def switch(self, folder: Path) -> None:
        """Let another project take the place of the open one; its pages reconnect automatically."""
        task = asyncio.get_running_loop().create_task(self._switch(folder))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _switch(self, folder: Path) -> None:
        async with self._switching:
            if folder == self._folder:
                return
            shut_out(folder)
            after = self._made(folder)
            try:
                await after.open()
            except BaseException:
                after.kill()
                raise
            before, self.session, self._folder = self.session, after, folder
            await asyncio.to_thread(remember_project, folder)
            await asyncio.to_thread(keep_place, folder, self._place)
            await before.close()

    def _made(self, folder: Path) -> Session:
        return Session(folder, self._neutral, self._worker, self.switch)
