"""What a tab is told of tasks when the process that knows them fails, and when it is asked again."""

import asyncio
from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

import pytest

from ropsim.core import RopsimError
from ropsim.prolog.diagnostics import CRASHED, ENGINE_FILES_MISSING
from ropsim.studio.testing import (
    Failed,
    Reply,
    Tab,
    Task,
    TaskList,
    TasksReply,
    WorkerLink,
    answered,
    commands,
    jobs,
    tasks,
)


class Worker:
    """A link to a worker that gives these replies, one after the other, and none where None stands."""

    def __init__(self, replies: Sequence[Reply | None]) -> None:
        self._replies = iter(replies)
        self._open: list[asyncio.Future[Reply]] = []

    def submit(self, job: jobs.Job) -> Task:
        reply, future = next(self._replies), asyncio.get_running_loop().create_future()
        self._open.append(future)
        if reply is not None:
            future.set_result(reply)
        return Task(1, job, lambda _: None, future)

    def kill(self) -> None:
        self._open[-1].set_result(Failed("the checker of tasks has ended unexpectedly (signal 9)"))


class Listening:
    """A tab that keeps what it is told."""

    closed = False

    def __init__(self) -> None:
        self.told: list[Any] = []

    def send(self, message: Any) -> None:
        self.told.append(message)


def told(replies: Sequence[Reply | None], times: int = 1) -> list[Any]:
    """Return what a tab is told that asks for the tasks so often."""

    async def run() -> list[Any]:
        chosen = tasks.ChosenTasks(Path("cell"), cast(WorkerLink, Worker(replies)), dict)
        tab = Listening()
        for _ in range(times):
            await chosen.answer(cast(Tab, tab), commands.OpenTasks())
        return tab.told

    return asyncio.run(run())


def test_a_list_that_cannot_be_had_says_why_and_the_next_one_is_asked_for_anew() -> None:
    lost = Failed("the checker of tasks has ended unexpectedly (exit code 3)")
    first, second = told([lost, TasksReply({"type": "task_list"})], times=2)
    assert isinstance(first, TaskList)
    assert first.problem == lost.message
    assert (first.tasks, first.findings) == ((), ())
    assert second == {"type": "task_list"}


def test_a_worker_that_is_ended_for_its_slowness_is_not_said_to_lack_memory(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(tasks, "PATIENCE", 0.0)
    (only,) = told([None])
    assert only.problem == "it took longer than 0 s; the machine may be busy"


@pytest.mark.parametrize("kind", [CRASHED, ENGINE_FILES_MISSING])
def test_what_happens_to_the_engine_is_told_in_words_of_who_knows_none(
    kind: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    from ropsim.studio.desk.tasks import bench
    from ropsim.studio.testing import Desk

    def fails(*_: object) -> None:
        raise RopsimError(kind.at(None, "Prolog ended in the middle of its work: trap in swipl"))

    monkeypatch.setattr(bench, "open_overlaid", fails)
    reply = answered(Desk(), jobs.ListTasks(str(tmp_path), {}), cast(Any, None))
    assert isinstance(reply, Failed)
    assert not any(word in reply.message for word in ("Prolog", "swipl", "bench"))
    assert "tasks" in reply.message
