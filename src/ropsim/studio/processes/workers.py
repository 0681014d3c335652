"""Jobs for a worker process, from the event loop: send, follow, await; a dead worker is replaced."""

import asyncio
from collections.abc import Callable, Iterable
from dataclasses import field
from itertools import count
from typing import Literal

from ropsim.core import frozen_dataclass
from ropsim.studio.processes.pipe import Pipe
from ropsim.studio.wire.jobs import Job, LiveStart, Simulate
from ropsim.studio.wire.orders import Order, Request
from ropsim.studio.wire.replies import (
    Answer,
    Failed,
    JogReply,
    OfferedReply,
    Reply,
    Report,
    RunReply,
    SavedRun,
    SceneReply,
    TasksReply,
    ToldReply,
    WaysReply,
)

REPLIES = (SceneReply, RunReply, SavedRun, WaysReply, JogReply, TasksReply, ToldReply, OfferedReply, Failed)

DESK = "ropsim.studio.desk:main"
"""The worker that simulates, draws and jogs."""


@frozen_dataclass
class Task:
    """A job on its way; `reply` is done when the worker has answered or has died."""

    number: int
    job: Job
    report: Callable[[Report], None]
    reply: "asyncio.Future[Reply]" = field(compare=False)


class WorkerLink:
    """The event loop's end of one worker process, which is started with the first job.

    Args:
        name: name of the worker in messages.
        folder: working folder of the process.
        lost: called with a text when the worker has ended unexpectedly.
        target: function that runs in the process.
    """

    def __init__(self, name: str, folder: str, lost: Callable[[str], None], target: str = DESK) -> None:
        self._name = name
        self._folder = folder
        self._lost = lost
        self._target = target
        self._numbers = count(1)
        self._tasks: dict[int, Task] = {}
        self._pipe: Pipe | None = None
        self._asked_to_die = False
        self._why = ""
        self._closed = False

    def start(self) -> None:
        """Start the process if it does not run, so that it is warm for the first job."""
        if self._pipe is None and not self._closed:
            self._pipe = self._open()

    @property
    def process_id(self) -> int | None:
        """Return the number of the process, None where none runs."""
        return self._pipe.process_id if self._pipe is not None else None

    def submit(self, job: Job, report: Callable[[Report], None] = lambda _: None) -> Task:
        """Send a job; `report` receives reports of the worker before its reply."""
        self.start()
        task = Task(next(self._numbers), job, report, asyncio.get_running_loop().create_future())
        if self._closed:
            task.reply.set_result(_failure(job, f"the {self._name} has been ended"))
        else:
            self._tasks[task.number] = task
            self._send(Request(task.number, job))
        return task

    def order(self, task: Task, order: Order) -> None:
        """Send an order for a job; nothing happens when it is done already."""
        if task.number in self._tasks:
            self._send(Request(task.number, order))

    def kill(self, why: str = "") -> None:
        """End the process at once, during any work; its jobs end too, and the next job starts a new one.

        Args:
            why: it is ended, for users.
        """
        if self._pipe is not None:
            self._asked_to_die, self._why = True, why
            self._pipe.kill()

    async def close(self) -> None:
        """End the process for good."""
        self._closed = True
        if self._pipe is not None:
            self._asked_to_die = True
            await asyncio.to_thread(self._pipe.close)

    def _open(self) -> Pipe:
        loop = asyncio.get_running_loop()
        self._asked_to_die = False

        def arrived(answer: Answer) -> None:
            _on_loop(loop, lambda: self._arrived(answer))

        def ended(code: int) -> None:
            _on_loop(loop, lambda: self._ended(pipe, code))

        pipe = Pipe(f"ropsim {self._name}", self._target, self._folder, arrived, ended)
        return pipe

    def _send(self, request: Request) -> None:
        if self._pipe is not None:
            self._pipe.send(request)

    def _arrived(self, answer: Answer) -> None:
        task = self._tasks.get(answer.number)
        if task is None:
            return
        if isinstance(answer.content, REPLIES):
            del self._tasks[answer.number]
            if not task.reply.done():
                task.reply.set_result(answer.content)
        else:
            task.report(answer.content)

    def _ended(self, pipe: Pipe, code: int) -> None:
        if pipe is not self._pipe:
            return
        self._pipe = None
        tasks, self._tasks = self._tasks, {}
        if self._asked_to_die:
            words = f"the {self._name} has been ended{': ' if self._why else ''}{self._why}"
            _end(tasks.values(), words, "cancelled")
            return
        words = f"the {self._name} has ended unexpectedly ({_exit_words(code)})"
        _end(tasks.values(), words, "failed")
        self._lost(words)


def _on_loop(loop: asyncio.AbstractEventLoop, call: Callable[[], None]) -> None:
    try:
        loop.call_soon_threadsafe(call)
    except RuntimeError:
        if not loop.is_closed():
            raise


def _end(tasks: Iterable[Task], words: str, state: Literal["failed", "cancelled"]) -> None:
    for task in tasks:
        if not task.reply.done():
            task.reply.set_result(_failure(task.job, words, state))


def _failure(job: Job, words: str, state: Literal["failed", "cancelled"] = "failed") -> Reply:
    if isinstance(job, Simulate | LiveStart):
        return RunReply(state, job.program, words)
    return Failed(words)


def _exit_words(code: int) -> str:
    if code in (-9, 137):
        return "killed by the system, most likely because the memory ran out"
    return f"signal {-code}" if code < 0 else f"exit code {code}"
