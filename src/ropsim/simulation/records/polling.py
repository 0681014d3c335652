"""A program that goes round in a loop and does nothing but look at channels and stand."""

from dataclasses import dataclass, field, replace
from typing import NamedTuple

from ropsim.flow import (
    GripInstruction,
    Instruction,
    MoveInstruction,
    Origin,
    SyncInstruction,
    WaitInstruction,
)
from ropsim.icr import Machine, MachineState


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
    """Compares the state of a program at each pause with that at the pause before.

    A pause is a wait for a time, or the tick for which it stands where it looks again (`Looks`). Where the
    state is the same, and nothing but channels was looked at in between, the next pass will be the same as
    long as the channels are.

    Attributes:
        reads: channels read since the last pause.
        looked: names of the channels looked at before the step that is carried out, where the program stands
            there because it looks again and again; whether it asks for the time does not matter.
        waited: control tick at which it began its last wait for a time.
        timed: whether the program has asked for the time since then.
        state: of the program at the last pause; None where it has done something else since.
        found: what was looked at before the last pause, where the state was the same; it may be nothing.
    """

    reads: dict[str, bool | float] = field(default_factory=dict)
    looked: tuple[str, ...] = ()
    waited: int = -1
    timed: bool = False
    state: MachineState | None = None
    found: Polled | None = None

    def look(self, machine: Machine, step: Instruction, tick: int, *, again: bool) -> Polled | None:
        """Return what was looked at since a pause of the same state, None where the program goes on.

        Args:
            machine: which has come to the step.
            step: that is carried out next.
            tick: control tick now.
            again: whether it looks from where the program has looked at this tick already.
        """
        self.looked = tuple(sorted(self.reads)) if again else ()
        if not isinstance(step, WaitInstruction | SyncInstruction):
            self.state = self.found = None
            if isinstance(step, MoveInstruction | GripInstruction):
                self.reads.clear()
            return None
        if isinstance(step, WaitInstruction):
            self.waited = tick
        pauses_here = again and self.waited != tick  # else at its wait, which takes less than a tick
        if isinstance(step, SyncInstruction) and not pauses_here:
            known = self.found.reads if self.found else {}
            return self.found if all(known.get(name) == read for name, read in self.reads.items()) else None
        state = _bare(machine.snapshot())
        same = state == self.state
        if same:
            self.looked = tuple(sorted(self.reads))
        self.found = Polled(dict(self.reads), step.origin) if same and not self.timed else None
        self.state, self.timed = state, False
        self.reads.clear()
        return self.found


def _bare(state: MachineState) -> MachineState:
    """Return a state without what only counts."""
    return replace(state, call_serials=(), visits=(), activations=0, steps=0)
