"""Finished runs: plan first, then simulate as fast as it goes; report progress, listen for newer texts."""

import time
from dataclasses import dataclass, replace
from enum import Enum

from ropsim.codegen import compiling_reported, compiling_text
from ropsim.core import RopsimError
from ropsim.flow import Interventions, Recording
from ropsim.records import with_inputs
from ropsim.simulation import Fidelity, InputChange, KeptRuns, RunOptions, RunView
from ropsim.simulation import run as run_program
from ropsim.studio.desk.content import content_of
from ropsim.studio.desk.finished import FinishedRun, Shelf
from ropsim.studio.desk.line import Cancelled, Line
from ropsim.studio.desk.runnable import MOST_ROWS, Runnable, made_ready, run_job
from ropsim.studio.wire.jobs import Simulate
from ropsim.studio.wire.orders import Renew
from ropsim.studio.wire.replies import Planned, Progress, Renewed, RunReply
from ropsim.views import Stage, plain_findings
from ropsim.workbench import Workspace, engine_note

LISTEN = 0.05
"""How often a run listens for being given up [s]."""

TELL = 0.5
"""Interval of progress reports of a run [s]."""

PLANNING_ROWS = 1
"""Recorded rows per second of the run that only plans: they are not used, each tick is judged anyway."""


def simulate(job: Simulate, line: Line, shelf: Shelf, workspace: Workspace) -> RunReply:
    """Return the reply to a run. One of the same content is not made again, but shown on the new lines.

    Args:
        job: run to execute.
        line: connection to the sender.
        shelf: keeps the newest run.
        workspace: that has read the project before.

    Raises:
        Cancelled: it was given up.
    """

    def run(ready: Runnable) -> RunReply:
        content = content_of(ready.cell, ready.codes, job.fidelity, job.inputs)
        kept = shelf.run
        if kept is not None and kept.is_result_of(content, job.cause):
            shelf.run = kept.shown_on(line.number, ready)
            return replace(ready.finished(shelf.run.recording), made="kept")
        if kept is not None and kept.stays_beside(content, job.cause):
            shelf.run = replace(kept, beside=content)
            return RunReply("done", ready.name, made="nothing")
        line.report(Progress(engine_note() or "preparing the arm"))
        listener = Listener(line, content, ready)
        known = shelf.known_in(ready.cell)
        with compiling_reported(lambda count: line.report(Progress(compiling_text(count)))):
            if job.fidelity == Fidelity.DYNAMIC.value:
                planned = _carried_out(job, ready, listener, known, Purpose.PLANNING)
                found = plain_findings(listener.ready.findings)
                line.report(Planned((*found, *plain_findings(planned.findings, Stage.RUN))))
            recording = _carried_out(job, ready, listener, known, Purpose.RUN)
        made = FinishedRun(line.number, content, ready, recording)
        shelf.run = made.shown_on(line.number, listener.ready)
        return listener.ready.finished(shelf.run.recording)

    return run_job(job, workspace, run)


class Purpose(Enum):
    """Purpose of executing a program."""

    PLANNING = "planning"
    RUN = "run"


def _carried_out(
    job: Simulate, ready: Runnable, listener: "Listener", known: KeptRuns, purpose: Purpose
) -> Recording:
    inputs = tuple(InputChange(one.time, one.signal, one.value) for one in job.inputs)
    if purpose is Purpose.PLANNING:
        options = RunOptions(Fidelity.KINEMATIC, record_hz=PLANNING_ROWS)
    else:
        options = RunOptions(Fidelity(job.fidelity))
    watched = known.used_in(replace(options, most_rows=MOST_ROWS, watch=listener))
    return run_program(ready.cell, ready.codes, with_inputs(watched, Interventions(inputs)))


@dataclass(slots=True)
class Listener:
    """Observes a run, reports its progress and allows cancellation.

    Attributes:
        line: connection to the sender.
        content: of which it is a run.
        ready: the newest text of this content.
        listened: when it listened last [s of the wall clock].
        told: time of the last report.
    """

    line: Line
    content: str
    ready: Runnable
    listened: float = 0.0
    told: float = 0.0

    @property
    def may_press(self) -> bool:
        """Return False: a run at full speed has no key presses."""
        return False

    def advanced(self, run: RunView) -> None:
        """Listen and report, now and then.

        Raises:
            Cancelled: the run was given up.
        """
        now = time.monotonic()
        if now - self.listened >= LISTEN:
            for order in self.line.orders(0.0):
                if isinstance(order, Renew):
                    self._renew(order)
            self.listened = now
        if now - self.told >= TELL:
            self.line.report(Progress(f"{run.time:.0f} s simulated"))
            self.told = now

    def reading(self, run: RunView) -> None:
        """Let the program look."""

    def ended(self, run: RunView) -> None:
        """Let the recording be made."""

    def _renew(self, order: Renew) -> None:
        """Go on for newer texts of the same content.

        Raises:
            Cancelled: they say something else.
        """
        try:
            ready = made_ready(order.job, self.ready.project.workspace)
        except RopsimError as error:
            raise Cancelled from error
        if isinstance(ready, RunReply):
            raise Cancelled
        if content_of(ready.cell, ready.codes, order.job.fidelity, order.job.inputs) != self.content:
            raise Cancelled
        self.ready = ready
        self.line.report(Renewed(order.run))
