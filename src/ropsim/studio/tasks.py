"""Tasks that tabs choose: a worker of their own answers, started when the first tab asks."""

import asyncio
from collections.abc import Callable, Mapping
from pathlib import Path

from ropsim.studio import commands, jobs
from ropsim.studio.diagnostics import WORKER_LOST
from ropsim.studio.messages import Message
from ropsim.studio.task_messages import TaskList, TasksChecked, WorldNow
from ropsim.studio.workers import Task, WorkerLink

PATIENCE = 20.0
"""How long an answer may take before the worker is ended [s]; each check has its own, shorter limit."""

NOTHING = WorldNow("", "", (), ())


class ChosenTasks:
    """Asks the worker for tabs.

    Args:
        folder: of the project.
        worker: that knows the tasks.
        texts: returns the unsaved texts.
    """

    def __init__(self, folder: Path, worker: WorkerLink, texts: Callable[[], Mapping[str, str]]) -> None:
        self._folder = str(folder)
        self._worker = worker
        self._texts = texts
        self._estimate: Task | None = None
        self._asked = 0

    async def answer(
        self, command: commands.OpenTasks | commands.CheckTasks, send: Callable[[Message], None]
    ) -> None:
        """Answer a tab; the time of a program follows its check, unless something newer is asked."""
        self._asked += 1
        asked = self._asked
        self._give_up()
        if isinstance(command, commands.OpenTasks):
            send(await self._list())
            return
        message = await self._check(command)
        send(message)
        program = message.get("text") if isinstance(message, Mapping) else None
        if asked != self._asked or not isinstance(program, str) or not program:
            return
        job = jobs.EstimateTasks(self._folder, self._texts(), command.id, program)
        self._estimate = self._worker.submit(job)
        reply = await self._estimate.reply
        if isinstance(reply, jobs.TasksReply) and asked == self._asked:
            send(reply.payload)

    async def _list(self) -> Message:
        reply = await self._reply(jobs.ListTasks(self._folder, self._texts()))
        if isinstance(reply, jobs.TasksReply):
            return reply.payload
        finding = {
            "code": WORKER_LOST.code,
            "severity": "error",
            "message": _why(reply),
            "hint": "mend the project, or open the panel again",
            "span": None,
            "time": None,
        }
        return TaskList(0, (), (), NOTHING, (finding,))

    async def _check(self, command: commands.CheckTasks) -> Message:
        reply = await self._reply(jobs.CheckTasks(self._folder, self._texts(), command.id, command.steps))
        if isinstance(reply, jobs.TasksReply):
            return reply.payload
        return TasksChecked(command.id, 0, (), (), "", _why(reply))

    async def _reply(self, job: jobs.Job) -> jobs.Reply:
        reply = self._worker.submit(job).reply
        done, _ = await asyncio.wait((reply,), timeout=PATIENCE)
        if not done:
            self._worker.kill()
        return await reply

    def _give_up(self) -> None:
        """End an estimate that nobody waits for any more."""
        if self._estimate is not None:
            self._worker.order(self._estimate, jobs.Cancel())
            self._estimate = None


def _why(reply: jobs.Reply) -> str:
    return reply.message if isinstance(reply, jobs.Failed) else "the tasks cannot be asked now"
