"""Supervision of real processes that run a toy in place of the simulator."""

import asyncio
import os
import signal
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path

import pytest

from ropsim.studio.testing import WorkerLink, jobs, orders, replies
from support.patience import PATIENCE

TOY = "support.toy_worker:main"


def with_link(folder: Path, use: Callable[[WorkerLink], Awaitable[None]]) -> list[str]:
    """Use a link to a toy worker and return what was told about lost workers."""
    lost: list[str] = []

    async def run() -> None:
        link = WorkerLink("toy", str(folder), lost.append, TOY)
        try:
            await asyncio.wait_for(use(link), PATIENCE)
        finally:
            await link.close()

    asyncio.run(run())
    return lost


def simulate(program: str) -> jobs.Simulate:
    return jobs.Simulate("", {"programs/main.task": "x"}, program, "dynamic")


def test_a_job_is_answered_after_its_reports(tmp_path: Path) -> None:
    heard: list[replies.Report] = []

    async def use(link: WorkerLink) -> None:
        reply = await link.submit(simulate("main"), heard.append).reply
        assert reply == replies.RunReply("done", "main", pack=b"x|0")
        assert heard == [replies.Progress("half way")]

    assert with_link(tmp_path, use) == []


def test_a_worker_that_dies_fails_its_job_in_words_and_the_next_job_has_a_new_one(tmp_path: Path) -> None:
    async def use(link: WorkerLink) -> None:
        reply = await link.submit(simulate("crash")).reply
        assert isinstance(reply, replies.RunReply)
        assert reply.state == "failed"
        assert "exit code 3" in reply.message
        again = await link.submit(jobs.JogJoints("robot", (1.0,), "")).reply
        assert isinstance(again, replies.JogReply)

    assert with_link(tmp_path, use) == ["the toy has ended unexpectedly (exit code 3)"]


def test_a_worker_that_does_not_listen_is_ended_on_request(tmp_path: Path) -> None:
    async def use(link: WorkerLink) -> None:
        task = link.submit(simulate("deaf"), lambda _: link.kill("it does not listen"))
        reply = await task.reply
        assert reply == replies.RunReply("cancelled", "deaf", "the toy has been ended: it does not listen")

    assert with_link(tmp_path, use) == []  # nobody is told of what was asked for


def test_an_order_reaches_the_job_that_runs(tmp_path: Path) -> None:
    async def use(link: WorkerLink) -> None:
        task = link.submit(simulate("endless"))
        link.order(task, orders.Cancel())
        assert await task.reply == replies.RunReply("cancelled", "endless")
        link.order(task, orders.Cancel())  # too late: nothing happens

    assert with_link(tmp_path, use) == []


def test_closing_ends_also_a_worker_that_does_not_listen(tmp_path: Path) -> None:
    pids: list[int] = []

    async def use(link: WorkerLink) -> None:
        started = asyncio.Event()
        link.submit(simulate("deaf"), lambda _: started.set())
        await started.wait()
        assert link.process_id is not None
        pids.append(link.process_id)

    with_link(tmp_path, use)
    assert not _alive(pids[0])


def _alive(pid: int) -> bool:
    try:
        os.kill(pid, signal.SIG_DFL)
    except ProcessLookupError:
        return False
    return True


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has other signals")
@pytest.mark.parametrize("number", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_what_ends_a_whole_group_leaves_the_end_of_workers_to_the_server(tmp_path: Path, number: str) -> None:
    async def use(link: WorkerLink) -> None:
        link.start()  # signals that come while it starts count, too
        for _ in range(20):
            os.kill(link.process_id or 0, getattr(signal, number))
            await asyncio.sleep(0.02)
        assert isinstance(await link.submit(jobs.JogJoints("robot", (1.0,), "")).reply, replies.JogReply)
        os.kill(link.process_id or 0, getattr(signal, number))
        assert isinstance(await link.submit(jobs.JogJoints("robot", (1.0,), "")).reply, replies.JogReply)

    assert with_link(tmp_path, use) == []


def test_a_link_that_is_closed_starts_no_process_any_more(tmp_path: Path) -> None:
    async def use(link: WorkerLink) -> None:
        await link.submit(jobs.JogJoints("robot", (1.0,), "")).reply
        await link.close()
        assert isinstance(await link.submit(jobs.JogJoints("robot", (1.0,), "")).reply, replies.Failed)
        assert link.process_id is None

    assert with_link(tmp_path, use) == []


def test_killing_ends_a_worker_at_once_and_silently(tmp_path: Path) -> None:
    async def use(link: WorkerLink) -> None:
        task = link.submit(simulate("deaf"))
        link.kill()
        assert isinstance(await task.reply, replies.RunReply)

    assert with_link(tmp_path, use) == []
