"""Tasks that tabs choose: a separate worker answers, started on the first request."""

import asyncio
from collections.abc import Callable, Mapping
from itertools import count
from pathlib import Path
from weakref import WeakKeyDictionary

from ropsim.studio.processes.workers import Task, WorkerLink
from ropsim.studio.session.tab import Tab
from ropsim.studio.wire import commands, jobs, orders, replies
from ropsim.studio.wire.messages import Message
from ropsim.studio.wire.task_messages import (
    FormFault,
    TaskFormChecked,
    TaskFormOpened,
    TaskList,
    TasksChecked,
    WorldNow,
)

PATIENCE = 60.0
"""How long an answer may take before the worker is ended [s]; each check has its own, shorter limit."""

NOTHING = WorldNow("", "", (), ())


class ChosenTasks:
    """Queries the worker for tabs.

    Args:
        folder: of the project.
        worker: worker for tasks.
        texts: returns the unsaved texts.
    """

    def __init__(self, folder: Path, worker: WorkerLink, texts: Callable[[], Mapping[str, str]]) -> None:
        self._folder = str(folder)
        self._worker = worker
        self._texts = texts
        self._estimates: dict[int, Task] = {}
        self._newest: WeakKeyDictionary[Tab, int] = WeakKeyDictionary()
        self._checks = count(1)

    async def answer(self, tab: Tab, command: commands.OpenTasks | commands.CheckTasks) -> None:
        """Answer a tab; the time of its program follows a check, unless the tab requests a newer one."""
        self._give_up()
        if isinstance(command, commands.OpenTasks):
            tab.send(await self._list())
            return
        number = self._newest[tab] = next(self._checks)
        message = await self._check(command)
        tab.send(message)
        program = message.get("text") if isinstance(message, Mapping) else None
        if isinstance(program, str) and program:
            await self._time(tab, number, command.id, program)

    async def answer_form(self, tab: Tab, command: commands.OpenTaskForm | commands.CheckTaskForm) -> None:
        """Answer a tab that fills in the form of a task."""
        self._give_up()
        if isinstance(command, commands.OpenTaskForm):
            job: jobs.Job = jobs.OpenTaskForm(self._folder, self._texts(), command.task)
        else:
            fields = (command.id, command.document, command.task, command.form)
            job = jobs.CheckTaskForm(self._folder, self._texts(), *fields)
        reply = await self._reply(job)
        if isinstance(reply, replies.TasksReply):
            tab.send(reply.payload)
        elif isinstance(command, commands.OpenTaskForm):
            tab.send(TaskFormOpened(command.task, "", None, _why(reply), ()))
        else:
            tab.send(TaskFormChecked(command.id, "", "", (FormFault("name", 0, "error", _why(reply), ""),)))

    async def _time(self, tab: Tab, number: int, answered: int, program: str) -> None:
        """Send a tab the time of a program; an estimate cancelled for another request is repeated."""
        while self._newest.get(tab) == number and not tab.closed:
            job = jobs.EstimateTasks(self._folder, self._texts(), answered, program)
            task = self._worker.submit(job)
            self._estimates[task.number] = task
            reply = await task.reply
            if isinstance(reply, replies.TasksReply):
                tab.send(reply.payload)
            if self._estimates.pop(task.number, None) is not None:  # it was not cancelled
                return

    async def _list(self) -> Message:
        reply = await self._reply(jobs.ListTasks(self._folder, self._texts()))
        if isinstance(reply, replies.TasksReply):
            return reply.payload
        return TaskList(0, (), (), (), NOTHING, (), _why(reply))

    async def _check(self, command: commands.CheckTasks) -> Message:
        reply = await self._reply(jobs.CheckTasks(self._folder, self._texts(), command.id, command.steps))
        if isinstance(reply, replies.TasksReply):
            return reply.payload
        return TasksChecked(command.id, 0, (), (), "", "", _why(reply), "")

    async def _reply(self, job: jobs.Job) -> replies.Reply:
        reply = self._worker.submit(job).reply
        done, _ = await asyncio.wait((reply,), timeout=PATIENCE)
        if not done:
            self._worker.kill()
            await reply
            return replies.Failed(f"it took longer than {PATIENCE:g} s; the machine may be busy")
        return await reply

    def _give_up(self) -> None:
        """Cancel estimates for a request that a tab waits for."""
        for task in self._estimates.values():
            self._worker.order(task, orders.Cancel())
        self._estimates.clear()


def _why(reply: replies.Reply) -> str:
    return reply.message if isinstance(reply, replies.Failed) else "the tasks cannot be asked now"
