"""Changes of inputs that somebody gives to a run."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, order=True)
class InputChange:
    """One change of an input.

    Attributes:
        time: from when on it holds [s of simulated time].
        signal: name of an input of the cell.
        value: 0 or 1, or any number for an analog one.
    """

    time: float
    signal: str
    value: float
