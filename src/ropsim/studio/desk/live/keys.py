"""Key presses of a live run: each gets a time that the program has not read yet."""

import math
from dataclasses import dataclass, field

from ropsim.core import Diagnostic, Severity, define, did_you_mean, frozen_dataclass
from ropsim.model import Cell

NO_INPUT = define(
    "U980",
    "no-such-input",
    Severity.WARNING,
    "a key is bound to something that is no input of the cell",
    """
In a live run keys set inputs of the cell, which stand under `[signals]` in `cell.toml` with a line
`input = NUMBER`. Outputs are set by the program alone. Bind the key to one of the inputs that are named.
""",
)


@frozen_dataclass
class Stamp:
    """A change of an input with its tick."""

    signal: str
    tick: int
    value: float


@dataclass(slots=True)
class Keys:
    """Assigns times to key presses.

    A press becomes part of the run at the first tick to which no station has come, later than anything
    the program has read and later than the press before on the same signal. A run that is given the same
    changes at the same ticks reads the same values.

    Attributes:
        cell: whose inputs they are.
        looked: tick of the latest reading of the program, -1 before the first.
        last: tick of the latest change by signal.
    """

    cell: Cell
    looked: int = -1
    last: dict[str, int] = field(default_factory=dict)

    def stamp(self, name: str, value: float, soonest: int) -> Stamp | Diagnostic:
        """Return the change that a press means, or why it means none.

        Args:
            name: of the signal.
            value: of the key.
            soonest: first tick of the cell's clock to which no station has come.
        """
        signal = self.cell.signals.get(name)
        if signal is None or not signal.is_input:
            inputs = [one.name for one in self.cell.signals.values() if one.is_input]
            known = ", ".join(f"`{one}`" for one in inputs) or "none"
            message = f"`{name[:60]}` is no input of the cell, it has {known}"
            return NO_INPUT.at(None, message, hint=did_you_mean(name, inputs))
        if not math.isfinite(value):
            return NO_INPUT.at(None, f"`{name}` cannot be set to {value}, needed is a number")
        level = value if signal.analog else float(value != 0.0)
        tick = max(soonest, self.looked + 1, self.last.get(name, -1) + 1)
        self.last[name] = tick
        return Stamp(name, tick, level)
