"""A program in a loop that only reads channels and pauses."""

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
    """Readings of one pass of a polling loop.

    Attributes:
        reads: values of the channels; empty if the loop reads none.
        origin: of the standing in the loop.
    """

    reads: dict[str, bool | float]
    origin: Origin


@dataclass(slots=True)
class Polling:
    """Compares the state of a program at each pause with that at the pause before.

    A pause is a wait for a time, or the tick for which it pauses before it reads again
    (`RepeatedReads`). If the state is unchanged, and only channels were read in between, the next pass will
    be the same while the channels stay the same.

    Attributes:
        reads: channels read since the last pause.
        channels: names of the channels read before the present step, if the program pauses there in a polling
            loop; reading the time does not matter.
        waited: control tick at which it began its last wait for a time.
        timed: whether the program has read the time since then.
        state: of the program at the last pause; None where it has done something else since.
        found: readings before the last pause with the same state; possibly none.
    """

    reads: dict[str, bool | float] = field(default_factory=dict)
    channels: tuple[str, ...] = ()
    waited: int = -1
    timed: bool = False
    state: MachineState | None = None
    found: Polled | None = None

    def poll(self, machine: Machine, step: Instruction, tick: int, *, again: bool) -> Polled | None:
        """Return the readings since a pause with the same state, None if the program continues.

        Args:
            machine: which has come to the step.
            step: that is carried out next.
            tick: control tick now.
            again: whether it reads at a place that has already read at this tick.
        """
        self.channels = tuple(sorted(self.reads)) if again else ()
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
            self.channels = tuple(sorted(self.reads))
        self.found = Polled(dict(self.reads), step.origin) if same and not self.timed else None
        self.state, self.timed = state, False
        self.reads.clear()
        return self.found


def _bare(state: MachineState) -> MachineState:
    """Return a state without its counters."""
    return replace(state, call_serials=(), visits=(), activations=0, steps=0)
