"""The scene of the cell, and jogged arms, as answered by the desk worker."""

import asyncio
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import cast

from ropsim.studio.diagnostics import WORKER_LOST
from ropsim.studio.processes.workers import WorkerLink
from ropsim.studio.wire import commands, jobs, replies
from ropsim.studio.wire.messages import JogBody, Jogged, JogWords, SceneMessage

UNIT_POSE: jobs.PoseNumbers = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)


class Scenes:
    """The newest scene of a project and its meshes.

    Args:
        folder: of the project.
        desk: the worker.
        texts: returns the unsaved texts.
        tell: sends a scene to every tab.
    """

    def __init__(
        self,
        folder: Path,
        desk: WorkerLink,
        texts: Callable[[], Mapping[str, str]],
        tell: Callable[[SceneMessage], None],
    ) -> None:
        self._folder = folder
        self._desk = desk
        self._texts = texts
        self._tell = tell
        self._again = False
        self._refreshing: asyncio.Task[None] | None = None
        self._meshes: Mapping[str, bytes] = {}
        self._newest_meshes: Mapping[str, bytes] = {}
        self.newest: SceneMessage | None = None

    def refresh(self) -> None:
        """Request the scene of the present texts; while one is made, once more afterwards."""
        self._again = True
        if self._refreshing is None or self._refreshing.done():
            self._refreshing = asyncio.get_running_loop().create_task(self._refresh())

    def recover(self) -> None:
        """Open the scene in a new worker, unless the old one has died of it."""
        if self._refreshing is None or self._refreshing.done():
            self.refresh()

    def mesh(self, address: str) -> bytes | None:
        """Return a GLB file by its content address."""
        return self._meshes.get(address)

    async def jog(self, command: commands.JogJoints | commands.JogTcp) -> Jogged:
        """Move the arm of a station; where the worker cannot, the answer says so and the arm stays."""
        tcp = command.target if isinstance(command, commands.JogTcp) else UNIT_POSE
        reply = await self._desk.submit(command).reply
        if not isinstance(reply, replies.JogReply):
            words = reply.message if isinstance(reply, replies.Failed) else "the arm cannot be moved now"
            return Jogged(command.id, command.q, tcp, (), reached=False, words=(JogWords("error", words),))
        bodies = tuple(JogBody(body, pose) for body, pose in reply.bodies)
        words_ = tuple(JogWords(level, text) for level, text in reply.words)
        return Jogged(
            command.id, reply.q, reply.tcp, bodies, reply.reached, words_, reply.location, reply.typed
        )

    async def _refresh(self) -> None:
        while self._again:
            self._again = False
            reply = await self._desk.submit(jobs.OpenScene(str(self._folder), self._texts())).reply
            self.newest = self._message(cast("replies.SceneReply | replies.Failed", reply))
            self._tell(self.newest)

    def _message(self, reply: replies.SceneReply | replies.Failed) -> SceneMessage:
        if isinstance(reply, replies.SceneReply):
            # a page may still request a mesh of the scene before
            self._meshes = {**self._newest_meshes, **reply.meshes}
            self._newest_meshes = reply.meshes
            return SceneMessage(reply.scene, reply.findings)
        finding = {
            "code": WORKER_LOST.code,
            "severity": "error",
            "message": reply.message,
            "hint": "change the cell file, or start the studio again",
            "span": None,
            "time": None,
        }
        return SceneMessage(None, (finding,))
