"""How long a program of chosen tasks takes: it is planned as a run would plan it, without drives."""

import time
from dataclasses import dataclass

from ropsim.simulation import Fidelity, RunOptions, RunView
from ropsim.simulation import run as run_program
from ropsim.studio.desk.line import Cancelled, Line
from ropsim.studio.desk.runnable import MOST_ROWS, made_ready
from ropsim.studio.desk.simulate import LISTEN, PLANNING_ROWS
from ropsim.studio.desk.tasks.stating import PROGRAM
from ropsim.studio.wire.jobs import EstimateTasks, Simulate
from ropsim.studio.wire.replies import RunReply
from ropsim.studio.wire.task_messages import TasksEstimated
from ropsim.views import summarize
from ropsim.workbench import Workspace

LONGEST = 20.0
"""How long an estimate may take [s]."""


def estimated(job: EstimateTasks, line: Line, workspace: Workspace) -> TasksEstimated:
    """Return the cycle time of a program that is in no file.

    Raises:
        Cancelled: it was given up, or it takes too long.
        RopsimError: the project cannot be opened.
    """
    texts = {**job.texts, f"programs/{PROGRAM}.task": job.program}
    ready = made_ready(Simulate(job.folder, texts, PROGRAM, "kinematic"), workspace)
    if isinstance(ready, RunReply):
        first = next((one for one in ready.findings if one["severity"] == "error"), {})
        return TasksEstimated(job.id, None, str(first.get("message", "")))
    watch = Watch(line, time.monotonic() + LONGEST)
    options = RunOptions(Fidelity.KINEMATIC, record_hz=PLANNING_ROWS, most_rows=MOST_ROWS, watch=watch)
    recording = run_program(ready.cell, ready.codes, options)
    found = next((one.message for one in recording.findings if one.severity.value != "hint"), "")
    summary = summarize(recording)
    return TasksEstimated(job.id, summary.cycle_time if summary.cycle_time_valid else None, found)


@dataclass(slots=True)
class Watch:
    """Looks on and lets the estimate be given up.

    Attributes:
        line: connection to the sender.
        end: when it is given up [s of the wall clock].
        listened: when it listened last.
    """

    line: Line
    end: float
    listened: float = 0.0

    @property
    def may_press(self) -> bool:
        """Return False: there are no key presses."""
        return False

    def advanced(self, run: RunView) -> None:  # noqa: ARG002 - as the protocol has it
        """Listen now and then.

        Raises:
            Cancelled: the estimate was given up, or it takes too long.
        """
        now = time.monotonic()
        if now > self.end:
            raise Cancelled
        if now - self.listened >= LISTEN:
            self.line.orders(0.0)
            self.listened = now

    def reading(self, run: RunView) -> None:
        """Let the program look."""

    def ended(self, run: RunView) -> None:
        """Let the recording be made."""
