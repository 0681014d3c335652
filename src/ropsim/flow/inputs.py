"""Interventions in a running program: inputs, the override, its end."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TypeVar

from ropsim.core import frozen_dataclass

SLOWEST = 1e-3
"""Least override at which something moves; below it the override counts as 0 [share of the planned speed]."""


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


@dataclass(frozen=True, slots=True, order=True)
class OverrideChange:
    """One change of the override, at which all motions of a run are followed.

    Attributes:
        time: of the control tick from which on it holds [s of simulated time].
        value: share of the planned speed, 0 (held) to 1; below `SLOWEST` it counts as 0.
    """

    time: float
    value: float


Change = TypeVar("Change", InputChange, OverrideChange)


def in_time(changes: Iterable[Change]) -> tuple[Change, ...]:
    """Return changes in order of time; those at one time keep their order, so the one given last holds."""
    return tuple(sorted(changes, key=lambda one: one.time))


@frozen_dataclass
class Interventions:
    """All interventions in a live run; a run with the same interventions has the same result.

    Attributes:
        inputs: changes of inputs.
        overrides: changes of the override; before the first one it is 1.
        stopped: when the run was ended by hand [s of simulated time]; None where it came to its own end.
    """

    inputs: tuple[InputChange, ...] = ()
    overrides: tuple[OverrideChange, ...] = ()
    stopped: float | None = None
