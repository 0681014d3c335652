"""Stations whose programs serve those of other stations, and are over when these have ended."""

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
    """What a serving program still does when those that it served have ended.

    It ends where it waits for a signal that is not there (`working`). What waits in other ways, a loop that
    looks at signals, or does a whole round because its signal stays, ends where it looks a second time.

    Attributes:
        looks: places of the program at which it has looked at channels since then.
    """

    looks: set[CodePlace] = field(default_factory=set)

    def comes_round(self, machine: Machine, step: Instruction) -> bool:
        """Return whether a program that is not needed any more looks at channels at one place again."""
        if not isinstance(step, SyncInstruction):
            return False
        place = machine.code_place
        known = place in self.looks
        self.looks.add(place)
        return known
