"""Runs of a project, one at a time in the simulator, the newest wish first."""

import asyncio
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import count
from pathlib import Path

from ropsim.studio import jobs
from ropsim.studio.live_log import LiveLog
from ropsim.studio.messages import Message, RunStatus
from ropsim.studio.workers import Task, WorkerLink

QUIET = 0.25
"""How long the text must rest before it is simulated [s]."""

PATIENCE = 60.0
"""How long the simulator may take to give a job up before it is ended [s]; compiling an arm takes long."""

PACKS_KEPT = 3
"""Finished runs that a page can still fetch."""


@dataclass(frozen=True, slots=True)
class Wish:
    """A run that is wanted; live where it has a speed."""

    program: str
    fidelity: jobs.Fidelity
    speed: float | None = None


@dataclass(frozen=True, slots=True)
class Current:
    """The run that the simulator is at."""

    id: int
    wish: Wish
    task: Task


class Runs:
    """What runs, what is to run next, and what has been run.

    Args:
        folder: of the project.
        simulator: the worker.
        texts: returns the unsaved texts.
        tell: sends a message to every tab.
        show: sends a state frame to every tab.
    """

    def __init__(
        self,
        folder: Path,
        simulator: WorkerLink,
        texts: Callable[[], Mapping[str, str]],
        tell: Callable[[Message], None],
        show: Callable[[bytes], None],
    ) -> None:
        self._folder = str(folder)
        self._simulator = simulator
        self._texts = texts
        self._tell = tell
        self._show = show
        self._ids = count(1)
        self._last_wish = Wish("", "dynamic")
        self._next: tuple[int, Wish] | None = None
        self._current: Current | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._packs: dict[int, bytes] = {}
        self._done: RunStatus | None = None
        self._status: RunStatus | None = None
        self._live = LiveLog(tell)
        self._inputs: tuple[jobs.InputChange, ...] = ()

    @property
    def news(self) -> tuple[Message, ...]:
        """Return what a tab that has just come must know: the last good run, the newest one, the live one."""
        statuses = [self._done, self._status if self._status is not self._done else None]
        return (*(one for one in statuses if one is not None), *self._live.messages)

    def pack(self, run: int) -> bytes | None:
        """Return a finished run for the page."""
        return self._packs.get(run)

    def text_changed(self) -> None:
        """Simulate the last program again as soon as the text rests; a live run is not disturbed."""
        if self._timer is not None:
            self._timer.cancel()
        wish = Wish(self._last_wish.program, self._last_wish.fidelity)
        self._timer = asyncio.get_running_loop().call_later(QUIET, self._want, wish)

    def run(self, program: str, fidelity: jobs.Fidelity) -> None:
        """Simulate at once; a live run ends for it."""
        self._end_live()
        self._want(Wish(program, fidelity))

    def start_live(self, program: str, speed: float) -> None:
        """Run in real time at once; another live run ends for it."""
        self._end_live()
        self._want(Wish(program, "dynamic", speed))

    def cancel(self) -> None:
        """Give up what runs and what was to run next."""
        self._drop_next()
        if self._current is not None:
            self._give_up(self._current)

    def order_live(self, order: jobs.LiveControl | jobs.LiveSpeed | jobs.SetSignal) -> None:
        """Pass an order on to the live run; without one nothing happens."""
        if self._current is not None and self._current.wish.speed is not None:
            self._simulator.order(self._current.task, order)

    def forget_inputs(self) -> None:
        """Run without the recorded key presses."""
        self._inputs = ()
        self._want(Wish(self._last_wish.program, self._last_wish.fidelity))

    def close(self) -> None:
        """Start nothing more."""
        self._drop_next()

    def _want(self, wish: Wish) -> None:
        self._drop_next()
        self._last_wish = wish
        self._next = (next(self._ids), wish)
        if self._current is None:
            self._start_next()
            return
        self._say(RunStatus(self._next[0], "waiting", wish.program))
        if self._current.wish.speed is None:
            self._give_up(self._current)

    def _start_next(self) -> None:
        if self._next is None:
            return
        (run, wish), self._next = self._next, None
        texts = dict(self._texts())
        if wish.speed is None:
            job: jobs.Job = jobs.Simulate(self._folder, texts, wish.program, wish.fidelity, self._inputs)
            self._say(RunStatus(run, "running", wish.program, inputs=len(self._inputs)))
        else:
            job = jobs.LiveStart(self._folder, texts, wish.program, wish.speed)
            self._live.start(wish.program, wish.speed)
        task = self._simulator.submit(job, lambda report: self._heard(run, wish, report))
        self._current = Current(run, wish, task)
        task.reply.add_done_callback(lambda reply: self._over(run, wish, reply))

    def _heard(self, run: int, wish: Wish, report: jobs.Report) -> None:
        match report:
            case jobs.Progress(text) if self._next is None:  # else the one that replaces it has spoken
                self._say(RunStatus(run, "running", wish.program, text, inputs=len(self._inputs)))
            case jobs.LiveMessage(payload):
                self._live.add(payload)
            case jobs.LiveFrame(frame):
                self._show(frame)

    def _over(self, run: int, wish: Wish, done: "asyncio.Future[jobs.Reply]") -> None:
        self._current = None
        if not done.cancelled() and isinstance(reply := done.result(), jobs.RunReply):
            self._conclude(run, wish, reply)
        self._start_next()

    def _conclude(self, run: int, wish: Wish, reply: jobs.RunReply) -> None:
        if wish.speed is not None:
            self._live.end()
            self._inputs = reply.inputs if reply.state == "done" else self._inputs
        program = reply.program or wish.program
        status = RunStatus(run, reply.state, program, reply.message, reply.findings, len(self._inputs))
        if reply.state == "done" and reply.pack is not None:
            self._packs[run] = reply.pack
            for old in sorted(self._packs)[:-PACKS_KEPT]:
                del self._packs[old]
            self._done = status
        if reply.state != "cancelled" or self._next is None:
            self._say(status)

    def _say(self, status: RunStatus) -> None:
        self._status = status
        self._tell(status)

    def _end_live(self) -> None:
        if self._current is not None and self._current.wish.speed is not None:
            self._end(self._current, jobs.LiveControl("stop"))

    def _give_up(self, current: Current) -> None:
        self._end(current, jobs.Cancel())

    def _end(self, current: Current, order: jobs.Order) -> None:
        self._simulator.order(current.task, order)
        asyncio.get_running_loop().call_later(PATIENCE, self._end_deaf, current)

    def _end_deaf(self, current: Current) -> None:
        """End a simulator that has not given up its job."""
        if self._current is current:
            self._simulator.kill()

    def _drop_next(self) -> None:
        self._next = None
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
