"""Finished runs: simulate as fast as it goes, tell how far it is, listen for being given up."""

import time
from dataclasses import dataclass

from ropsim.flow import Recording
from ropsim.simulation import Fidelity, InputChange, RunOptions, RunView
from ropsim.simulation import run as run_program
from ropsim.studio.desk.line import Line
from ropsim.studio.desk.runnable import MOST_ROWS, Runnable, run_job
from ropsim.studio.jobs import Progress, RunReply, Simulate
from ropsim.workbench.inputs import with_inputs

LISTEN = 0.05
"""How often a run listens for being given up [s]."""

TELL = 0.5
"""How often a run tells how far it is [s]."""


def simulate(job: Simulate, line: Line) -> RunReply:
    """Return the reply to a run.

    Raises:
        Cancelled: it was given up.
    """

    def run(ready: Runnable) -> Recording:
        line.report(Progress("preparing the arm"))
        inputs = tuple(InputChange(one.time, one.signal, one.value) for one in job.inputs)
        options = RunOptions(Fidelity(job.fidelity), most_rows=MOST_ROWS, watch=Listener(line))
        return run_program(ready.cell, ready.code, with_inputs(options, inputs))

    return run_job(job, run)


@dataclass(slots=True)
class Listener:
    """Looks on, tells how far the run is and lets it be given up.

    Attributes:
        line: to who asked for the run.
        listened: when it listened last [s of the wall clock].
        told: when it told last.
    """

    line: Line
    listened: float = 0.0
    told: float = 0.0

    def advanced(self, run: RunView) -> None:
        """Listen and tell, now and then.

        Raises:
            Cancelled: the run was given up.
        """
        now = time.monotonic()
        if now - self.listened >= LISTEN:
            self.line.orders(0.0)
            self.listened = now
        if now - self.told >= TELL:
            self.line.report(Progress(f"{run.time:.0f} s simulated"))
            self.told = now

    def reading(self, run: RunView) -> None:
        """Let the program look."""

    def ended(self, run: RunView) -> None:
        """Let the recording be made."""
