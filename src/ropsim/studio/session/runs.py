"""Runs of a project, one at a time in the simulator, the newest wish first."""

import asyncio
from collections.abc import Callable, Mapping
from dataclasses import replace
from itertools import count
from pathlib import Path

from msgspec import structs

from ropsim.core import frozen_dataclass
from ropsim.studio.processes.workers import Task, WorkerLink
from ropsim.studio.session.live_log import LiveLog
from ropsim.studio.wire import jobs, orders, replies
from ropsim.studio.wire.messages import Message, RunStatus, RunWays

QUIET = 0.25
"""How long the text must rest before it is simulated [s]."""

PATIENCE = 60.0
"""How long the simulator may take to cancel a job before it is ended [s]: a function compiles for long."""

PACKS_KEPT = 3
"""Finished runs that a page can still fetch."""


@frozen_dataclass
class RunRequest:
    """A requested run; live if it has a speed."""

    program: str
    fidelity: jobs.Fidelity
    speed: float | None = None
    cause: jobs.Cause = "asked"
    begin: jobs.LiveBegin = "running"


@frozen_dataclass
class Current:
    """The run that the simulator is at."""

    id: int
    request: RunRequest
    task: Task


class Runs:
    """The present run, the next one, and finished ones.

    Args:
        folder: of the project.
        simulator: the worker.
        texts: returns the unsaved texts.
        versions: returns the version of every text.
        tell: sends a message to every tab.
        show: sends a state frame to every tab.
    """

    def __init__(
        self,
        folder: Path,
        simulator: WorkerLink,
        texts: Callable[[], Mapping[str, str]],
        versions: Callable[[], Mapping[str, int]],
        tell: Callable[[Message], None],
        show: Callable[[bytes], None],
    ) -> None:
        self._folder = str(folder)
        self._simulator = simulator
        self._texts = texts
        self._versions = versions
        self._asked: dict[int, Mapping[str, int]] = {}
        self._tell = tell
        self._show = show
        self._ids = count(1)
        self._last_request = RunRequest("", "dynamic")
        self._next: tuple[int, RunRequest] | None = None
        self._current: Current | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._packs: dict[int, bytes] = {}
        self._kept: tuple[int, int] | None = None
        self._simulated = 0
        self._planned: tuple[Mapping[str, object], ...] | None = None
        self._done: RunStatus | None = None
        self._status: RunStatus | None = None
        self._look: Task | None = None
        self._ways: RunWays | None = None
        self._live = LiveLog(tell)
        self._typed_beside = False
        self._inputs: tuple[jobs.InputChange, ...] = ()

    @property
    def news(self) -> tuple[Message, ...]:
        """Return the messages for a new tab: the last good run, the newest one, the live one."""
        said = [self._done, self._ways, self._status if self._status is not self._done else None]
        return (*(one for one in said if one is not None), *self._live.messages)

    def pack(self, run: int) -> bytes | None:
        """Return a finished run for the page."""
        return self._packs.get(run)

    @property
    def newest_program(self) -> str:
        """Return the name of the program that has run last; empty before the first run."""
        return self._done.program if self._done is not None else ""

    async def file(self, run: int, form: jobs.RunForm) -> bytes | None:
        """Return a finished run as a file; None where the simulator does not have it any more."""
        if self._kept is None or self._kept[0] != run:
            return None
        reply = await self._simulator.submit(jobs.SaveRun(self._kept[1], form)).reply
        return reply.content if isinstance(reply, replies.SavedRun) else None

    def text_changed(self) -> None:
        """Simulate the last program again when the text rests; a live run goes on and stays the result."""
        if self._timer is not None:
            self._timer.cancel()
        if self._is_live_ahead:
            self._typed_beside = True
            return
        request = RunRequest(self._last_request.program, self._last_request.fidelity, cause="text")
        self._timer = asyncio.get_running_loop().call_later(QUIET, self._want, request)

    @property
    def _is_live_ahead(self) -> bool:
        """Return whether the newest run, begun or not, is a live one."""
        if self._next is not None:
            return self._next[1].speed is not None
        return self._current is not None and self._current.request.speed is not None

    def run(self, program: str, fidelity: jobs.Fidelity) -> None:
        """Simulate at once; a live run ends for it."""
        self._end_live()
        self._want(RunRequest(program, fidelity))

    def start_live(self, program: str, speed: float, begin: jobs.LiveBegin = "running") -> None:
        """Run in real time at once, or held at the start; another live run ends for it."""
        self._end_live()
        self._want(RunRequest(program, "dynamic", speed, begin=begin))

    def cancel(self) -> None:
        """Cancel the present run and the next one."""
        self._drop_next()
        if self._current is not None:
            self._give_up(self._current)

    def order_live(self, order: orders.LiveOrder) -> None:
        """Pass an order on to the live run; without one nothing happens."""
        if self._current is not None and self._current.request.speed is not None:
            self._simulator.order(self._current.task, order)

    def forget_inputs(self) -> None:
        """Run without the recorded key presses."""
        self._inputs = ()
        self._want(RunRequest(self._last_request.program, self._last_request.fidelity))

    def close(self) -> None:
        """Start nothing more."""
        self._drop_next()

    def _want(self, request: RunRequest) -> None:
        self._drop_next()
        self._last_request = request
        self._next = (next(self._ids), request)
        if self._current is None:
            self._start_next()
            return
        current = self._current
        if current.request.speed is not None:
            self._say(RunStatus(self._next[0], "waiting", request.program))
        elif request == replace(current.request, cause=request.cause):
            if request.cause == "asked":
                self._say(RunStatus(self._next[0], "waiting", request.program))
            # it may still be the same run: the simulator finds out
            self._end(current, orders.Renew(self._next[0], self._job(self._next[0], request)))
        else:
            self._say(RunStatus(self._next[0], "waiting", request.program))
            self._give_up(current)

    def _job(self, run: int, request: RunRequest) -> jobs.Simulate:
        self._asked[run] = self._versions()
        texts = dict(self._texts())
        return jobs.Simulate(
            self._folder, texts, request.program, request.fidelity, self._inputs, request.cause
        )

    def _start_next(self) -> None:
        if self._next is None:
            return
        (run, request), self._next = self._next, None
        if self._look is not None:
            self._simulator.order(self._look, orders.Cancel())
        self._planned = None
        if request.speed is None:
            job: jobs.Job = self._job(run, request)
            if request.cause == "asked":  # after a change of the text there may be nothing to do
                self._say_running(run, request)
        else:
            self._asked[run] = self._versions()
            texts = dict(self._texts())
            job = jobs.LiveStart(self._folder, texts, request.program, request.speed, request.begin)
            self._typed_beside = False
            self._live.start(request.program, request.speed)
        task = self._simulator.submit(job, self._heard)
        self._current = Current(run, request, task)
        task.reply.add_done_callback(self._over)

    def _heard(self, report: replies.Report) -> None:
        if self._current is None:
            return
        run, request = self._current.id, self._current.request
        match report:
            case replies.Progress(text) if self._next is None:  # else the one that replaces it has spoken
                self._say_running(run, request, text)
            case replies.Planned(findings):
                self._planned = findings
                if self._next is None:
                    self._say_running(run, request)
            case replies.Renewed(renewed):
                self._current = replace(self._current, id=renewed)
                if self._next is not None and self._next[0] == renewed:
                    self._next = None
                    self._say_running(renewed, request)
            case replies.LiveMessage(payload):
                self._live.add(payload)
            case replies.LiveFrame(frame):
                self._show(frame)

    def _say_running(self, run: int, request: RunRequest, text: str = "") -> None:
        self._say(
            RunStatus(
                run,
                "running",
                request.program,
                text,
                self._planned or (),
                len(self._inputs),
                self._planned is not None,
                versions=self._asked.get(run, {}),
            )
        )

    def _over(self, done: "asyncio.Future[replies.Reply]") -> None:
        if self._current is None:
            return
        run, request, task = self._current.id, self._current.request, self._current.task
        self._current = None
        reply = None if done.cancelled() else done.result()
        if isinstance(reply, replies.RunReply):
            self._conclude(run, request, task, reply)
        self._start_next()
        if self._current is None and isinstance(reply, replies.RunReply) and not reply.ways:
            self._look_at_ways()

    def _look_at_ways(self) -> None:
        """Let the simulator check the collisions of the kept run; the next run ends that."""
        if self._kept is None or self._look is not None:
            return
        run, number = self._kept
        look = self._simulator.submit(jobs.LookAtWays(number))
        self._look = look

        def over(done: "asyncio.Future[replies.Reply]") -> None:
            self._look = None
            reply = None if done.cancelled() else done.result()
            if isinstance(reply, replies.WaysReply) and self._kept == (run, number):
                self._ways = RunWays(run, reply.findings, reply.result, reply.ways)
                self._tell(self._ways)

        look.reply.add_done_callback(over)

    def _conclude(self, run: int, request: RunRequest, task: Task, reply: replies.RunReply) -> None:
        if reply.made == "nothing":
            self._stay()
            return
        if request.speed is not None:
            self._live.end()
            self._inputs = reply.inputs if reply.state == "done" else self._inputs
            if self._typed_beside and self._next is None and reply.state != "cancelled":
                cause: jobs.Cause = "text_beside_live" if reply.state == "done" else "text"
                self._next = (next(self._ids), RunRequest(request.program, "dynamic", cause=cause))
        program = reply.program or request.program
        if reply.state == "done" and reply.made == "simulated":
            self._simulated = run
        simulated = self._simulated if reply.state == "done" else 0
        status = RunStatus(
            run,
            reply.state,
            program,
            reply.message,
            reply.findings,
            len(self._inputs),
            simulated=simulated,
            versions=self._asked.get(run, {}),
            results=reply.results,
        )
        self._asked = {known: versions for known, versions in self._asked.items() if known > run}
        if reply.state == "done" and reply.pack is not None:
            self._packs[run] = reply.pack
            for old in sorted(self._packs)[:-PACKS_KEPT]:
                del self._packs[old]
            self._done, self._ways = status, None
            self._kept = (run, task.number)
        if reply.state != "cancelled" or self._next is None:
            self._say(status)

    def _stay(self) -> None:
        """Report that the live run stays the result although texts have changed."""
        if self._done is not None:
            self._done = structs.replace(self._done, age="older")
            self._say(self._done)

    def _say(self, status: RunStatus) -> None:
        self._status = status
        self._tell(status)

    def _end_live(self) -> None:
        if self._current is not None and self._current.request.speed is not None:
            self._end(self._current, orders.LiveControl("stop"))

    def _give_up(self, current: Current) -> None:
        self._end(current, orders.Cancel())

    def _end(self, current: Current, order: orders.Order) -> None:
        self._simulator.order(current.task, order)
        asyncio.get_running_loop().call_later(PATIENCE, self._end_deaf, current)

    def _end_deaf(self, current: Current) -> None:
        """End a simulator that has neither cancelled its job, nor continued under another number."""
        if self._current is current:
            self._simulator.kill(f"it has not given up an older run within {PATIENCE:g} s")

    def _drop_next(self) -> None:
        self._next = None
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
