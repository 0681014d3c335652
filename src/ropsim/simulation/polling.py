"""A program that goes round in a loop and does nothing but look at channels and stand."""

from dataclasses import dataclass, field, replace
from typing import NamedTuple

from ropsim.flow import Instruction, Origin, SyncInstruction, WaitInstruction
from ropsim.icr import Finished, Machine, MachineState


class Polled(NamedTuple):
    """What a pass of such a loop looked at.

    Attributes:
        reads: what each channel read; empty where the loop looks at none.
        origin: of the standing in the loop.
    """

    reads: dict[str, bool | float]
    origin: Origin


@dataclass(slots=True)
class Polling:
    """Compares the state of a program at each wait with that at the wait before.

    Where it is the same, and nothing but channels was looked at in between, the next pass will be the same as
    long as the channels are.

    Attributes:
        reads: channels read since the last wait.
        timed: whether the program has asked for the time since then.
        state: of the program at the last wait; None where it has done something else since.
        found: what was looked at before the last wait, where the state was the same; it may be nothing.
    """

    reads: dict[str, bool | float] = field(default_factory=dict)
    timed: bool = False
    state: MachineState | None = None
    found: Polled | None = None

    def look(self, machine: Machine, step: Instruction | Finished) -> Polled | None:
        """Return what was looked at since a wait of the same state, None where the program goes on."""
        if isinstance(step, SyncInstruction):
            known = self.found.reads if self.found else {}
            return self.found if all(known.get(name) == read for name, read in self.reads.items()) else None
        if not isinstance(step, WaitInstruction):
            self.state = self.found = None
            return None
        state = _bare(machine.snapshot())
        same = state == self.state and not self.timed
        self.found = Polled(dict(self.reads), step.origin) if same else None
        self.state, self.timed = state, False
        self.reads.clear()
        return self.found


def _bare(state: MachineState) -> MachineState:
    """Return a state without what only counts."""
    return replace(state, call_serials=(), visits=(), activations=0, steps=0)
