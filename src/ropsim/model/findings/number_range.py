"""Allowed ranges of numbers of a model, and the check of records whose fields have them."""

from collections.abc import Iterator, Mapping
from enum import Enum
from math import inf, nextafter
from numbers import Integral, Real
from sys import float_info
from typing import ClassVar, Protocol, TypeAlias

import numpy as np

from ropsim.core import Diagnostic, RopsimError, frozen_dataclass
from ropsim.model.findings import diagnostics as kinds
from ropsim.spatial import Pose

LEAST_ABOVE_ZERO = nextafter(0.0, 1.0)
LARGEST = float_info.max


class ModelValueError(RopsimError):
    """A number of a model cannot be: a limit, mass or inertia is not finite or not positive."""


class NumberKind(Enum):
    """Kind of a number: any real one, or a whole one."""

    REAL = "a number"
    WHOLE = "a whole number"


@frozen_dataclass
class NumberRange:
    """The values that a number may have; NaN is in no range.

    Attributes:
        lowest: allowed value.
        highest: allowed value; infinite where that is allowed.
        allowed: the range in words, for messages.
        unit: of the number, empty for none.
        kind: whether it must be whole.
    """

    lowest: float
    highest: float
    allowed: str
    unit: str = ""
    kind: NumberKind = NumberKind.REAL

    def allows(self, value: object) -> bool:
        """Return whether a value is in the range."""
        if type(value) is not float and not isinstance(value, Real):
            return False
        if self.kind is NumberKind.WHOLE and not isinstance(value, Integral):
            return False
        return self.lowest <= float(value) <= self.highest


def between(lowest: float, highest: float, unit: str = "") -> NumberRange:
    """Return the range of the numbers from one to another, both allowed."""
    allowed = f"a number from {lowest:g} to {highest:g} {unit}".rstrip()
    return NumberRange(lowest, highest, allowed, unit)


def whole(lowest: int, highest: int, unit: str = "") -> NumberRange:
    """Return the range of the whole numbers from one to another, both allowed."""
    allowed = f"a whole number from {lowest} to {highest} {unit}".rstrip()
    return NumberRange(lowest, highest, allowed, unit, NumberKind.WHOLE)


POSITIVE = NumberRange(LEAST_ABOVE_ZERO, LARGEST, "a positive number")
POSITIVE_OR_INFINITE = NumberRange(LEAST_ABOVE_ZERO, inf, "a positive number")
FROM_ZERO = NumberRange(0.0, LARGEST, "0 or more")
UP_TO_ZERO = NumberRange(-LARGEST, 0.0, "0 or less")
FINITE = NumberRange(-LARGEST, LARGEST, "a finite number")
COORDINATE = between(-1e9, 1e9)
"""Coordinates of all units: a bound beyond each cell, so that no sum or square of some overflows."""

EXTENT = between(0.0, 1e9, "m")
RATE = between(1e-9, 1e9)
"""Speeds, accelerations and jerks; smaller ones would make motions of more than 30 years."""

TIME = between(0.0, 1e5, "s")

Ranges: TypeAlias = Mapping[str, NumberRange]
"""The range of each numeric field of a record, by the name of the field."""


class Ranged(Protocol):
    """A record whose class declares the ranges of its numbers."""

    RANGES: ClassVar[Ranges]


def check_ranges(owner: str, records: Mapping[str, Ranged]) -> None:
    """Make sure that the numbers of records are in their ranges.

    Args:
        owner: whose records they are, as messages name it.
        records: by their path from the owner, such as `controller.rates.`; empty for its own numbers.

    Raises:
        ModelValueError: X976, with the first of the `range_findings`.
    """
    found = next(range_findings(owner, records), None)
    if found:
        raise ModelValueError(found)


def range_findings(owner: str, records: Mapping[str, Ranged]) -> Iterator[Diagnostic]:
    """Yield the numbers of records that are not in their ranges; all of them are errors.

    A pose, an array or a tuple has one range for all its numbers; a mapping has it for each entry; None is
    no number.

    Args:
        owner: see `check_ranges`.
        records: see `check_ranges`.
    """
    for path, record in records.items():
        for name, allowed in record.RANGES.items():
            value = getattr(record, name)
            entries = (
                {f".{key}": one for key, one in value.items()} if isinstance(value, Mapping) else {"": value}
            )
            for key, one in entries.items():
                wrong = next((number for number in _numbers(one) if not allowed.allows(number)), None)
                if wrong is not None:
                    yield _out_of_range(owner, f"{path}{name}{key}", wrong, allowed)


def _numbers(value: object) -> tuple[object, ...]:
    """Return the numbers of a field."""
    match value:
        case None:
            return ()
        case Pose():
            return value.as_tuple()
        case np.ndarray():
            return tuple(value.ravel().tolist())
        case tuple():
            return tuple(number for one in value for number in _numbers(one))
        case _:
            return (value,)


def _out_of_range(owner: str, field: str, found: object, allowed: NumberRange) -> Diagnostic:
    shown = f"{found:g}" if isinstance(found, Real) else repr(found)
    return kinds.OUT_OF_RANGE.at(
        None,
        f"{owner} has `{field}` = {shown} {allowed.unit}".rstrip() + f", allowed is {allowed.allowed}",
        hint="give a number of that range, in SI units; check its sign and unit",
        data={"field": field, "found": found, "lowest": allowed.lowest, "highest": allowed.highest},
    )
