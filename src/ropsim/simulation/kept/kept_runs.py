"""Kept results of runs in a cell: plans, and responses of drives and arms."""

from dataclasses import replace

from ropsim.model import Cell
from ropsim.simulation.kept.kept_plans import KeptPlans
from ropsim.simulation.servo.kept_drives import KeptDrives
from ropsim.simulation.state.run_options import RunOptions


class KeptRuns:
    """Plans and slices, so that a run behind an edit computes only its new parts.

    Args:
        cell: in which the programs run.

    Attributes:
        plans: of sequences.
        drives: slices of servo-driven arms.
    """

    def __init__(self, cell: Cell) -> None:
        self.plans = KeptPlans(cell)
        self.drives = KeptDrives()

    @property
    def cell(self) -> Cell:
        """Return the cell in which the programs run."""
        return self.plans.cell

    def begin(self) -> None:
        """Take notice that another run begins."""
        self.plans.begin()
        self.drives.begin()

    def used_in(self, options: RunOptions) -> RunOptions:
        """Return options of a run that uses kept results and keeps new ones."""
        return replace(options, plan=self.plans.plan, drive=self.drives.drive)
