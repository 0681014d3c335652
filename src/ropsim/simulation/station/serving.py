"""Stations whose programs serve programs of other stations, and are over when these have ended."""

from dataclasses import dataclass, field

from ropsim.flow import Instruction, SyncInstruction
from ropsim.icr import CodePlace, Machine
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.station_run import StationRun


def is_needed(run: CellRun, at: StationRun) -> bool:
    """Return whether a station has a task of its own, or another one that has is still at its program."""
    return not at.station.serves or any(not run.stations[name].station.serves for name in run.at_work)


@dataclass(slots=True)
class Serving:
    """Remaining steps of a serving program after the programs that it served have ended.

    It ends where it waits for a signal that is not there (`working`). A program that waits in other ways, by
    a loop that reads signals, or by a whole round because its signal stays, ends at its second reading.

    Attributes:
        looks: places of the program that have read channels since then.
    """

    looks: set[CodePlace] = field(default_factory=set)

    def comes_round(self, machine: Machine, step: Instruction) -> bool:
        """Return whether a program that is not needed any more reads channels at one place again."""
        if not isinstance(step, SyncInstruction):
            return False
        place = machine.code_place
        known = place in self.looks
        self.looks.add(place)
        return known
