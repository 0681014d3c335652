"""Live runs: a program in real time whose inputs come from keys, exact to run again."""

import time
from collections.abc import Callable

from ropsim.core import frozen_dataclass
from ropsim.flow import OverrideChange
from ropsim.simulation import RunOptions, planned_anew
from ropsim.simulation import run as run_program
from ropsim.studio.desk.clock import PacedClock
from ropsim.studio.desk.content import content_of
from ropsim.studio.desk.finished import FinishedRun, Origin, Shelf
from ropsim.studio.desk.line import Line
from ropsim.studio.desk.live.hand import Hand
from ropsim.studio.desk.live.watch import LivePace
from ropsim.studio.desk.runnable import MOST_ROWS, Runnable, run_job, used_inputs
from ropsim.studio.wire.jobs import LiveStart
from ropsim.studio.wire.replies import RunReply
from ropsim.workbench import Workspace

LONGEST = 24 * 3600.0
"""Simulated time after which a live run ends, and for which it may wait for a key [s]."""


@frozen_dataclass
class Clocks:
    """Where a live run has its time from.

    Attributes:
        wall: returns a time that never goes back [s].
        day: returns the time since 1970 [s].
    """

    wall: Callable[[], float] = time.monotonic
    day: Callable[[], float] = time.time


REAL = Clocks()


def run_live(
    job: LiveStart,
    line: Line,
    clocks: Clocks = REAL,
    shelf: Shelf | None = None,
    workspace: Workspace | None = None,
) -> RunReply:
    """Return the reply to a live run, with the inputs that it was given.

    The run is computed slice by slice, each when the one before it has been shown. Orders in between act from
    the next tick on that no station has reached, and are recorded with it; a run with the interventions of
    the recording makes the same recording, bit for bit.

    Args:
        job: folder, texts, program and speed.
        line: orders in; layout, frames and messages out.
        clocks: the time of the wall.
        shelf: keeps the run.
        workspace: that has read the project before.

    Raises:
        Cancelled: it was given up.
    """

    def run(ready: Runnable) -> RunReply:
        clock = PacedClock(clocks.wall, job.speed)
        hand = Hand.at_start(job.begin)
        pace = LivePace(ready.name, ready.codes, clock, line, clocks.wall, clocks.day, hand=hand)
        options = RunOptions(
            longest=LONGEST,
            longest_wait=LONGEST,
            most_rows=MOST_ROWS,
            watch=pace,
            plan=shelf.known_in(ready.cell).plans.plan if shelf is not None else planned_anew,
            overrides=(OverrideChange(0.0, 0.0),) if hand.is_held else (),
        )
        recording = run_program(ready.cell, ready.codes, options)
        if shelf is not None:
            content = content_of(ready.cell, ready.codes, "dynamic", used_inputs(recording))
            shelf.run = FinishedRun(line.number, content, ready, recording, Origin.LIVE)
        return ready.finished(recording)

    return run_job(job, workspace or Workspace(), run)
