"""Types of values: kind and dimension; unknown types are found by use."""

from functools import lru_cache

from ropsim.core import frozen_dataclass, maker
from ropsim.language.check.scope import units
from ropsim.language.check.scope.units import Dimension
from ropsim.program import Expression, ValueType
from ropsim.spatial import PoseTuple

_OF_NUMBERS = (ValueType.INT, ValueType.REAL)


@frozen_dataclass
class Type:
    """A known type; `dimension` has a meaning for REAL only."""

    value: ValueType
    dimension: Dimension = units.NUMBER

    def __str__(self) -> str:
        if self.value is ValueType.REAL:
            return units.dimension_name(self.dimension)
        return _WORDS[self.value]

    @property
    def is_number(self) -> bool:
        """Return whether arithmetic makes sense."""
        return self.value in _OF_NUMBERS


_WORDS = {
    ValueType.BOOL: "truth value",
    ValueType.INT: "whole number",
    ValueType.STR: "text",
    ValueType.VEC: "vector",
    ValueType.ORI: "orientation",
    ValueType.POSE: "location",
    ValueType.JOINTS: "joint target",
}


@lru_cache(maxsize=1024)
def real(dimension: Dimension) -> Type:
    """Return the type of REALs of a dimension: the same one each time, so that it is soon recognised."""
    return Type(ValueType.REAL, dimension)


BOOL = Type(ValueType.BOOL)
INT = Type(ValueType.INT)
NUMBER = real(units.NUMBER)
LENGTH = real(units.LENGTH)
ANGLE = real(units.ANGLE)
TIME = real(units.TIME)
STR = Type(ValueType.STR)
POSE = Type(ValueType.POSE)
JOINTS = Type(ValueType.JOINTS)

NAMED: dict[str, Type] = {
    "num": NUMBER,
    "int": INT,
    "bool": BOOL,
    "str": STR,
    "length": LENGTH,
    "angle": ANGLE,
    "time": TIME,
    "speed": real(units.SPEED),
    "accel": real(units.ACCELERATION),
    "force": real(units.FORCE),
    "loc": POSE,
    "joints": JOINTS,
}
"""Types by the word of the language."""


class Unknown:
    """A type that use determines: one cell of a union-find forest.

    Only the first of the two passes of the checker sees unknown types. `has_fraction` and `has_number` keep
    the evidence of literals, for variables without other evidence.
    """

    __slots__ = ("bound", "has_fraction", "has_number")

    def __init__(self, *, has_number: bool = False, has_fraction: bool = False) -> None:
        self.bound: Type | Unknown | None = None
        self.has_fraction = has_fraction
        self.has_number = has_number

    def root(self) -> "Type | Unknown":
        """Return the known type behind this one, or the cell that stands for it."""
        here: Type | Unknown = self
        while isinstance(here, Unknown) and here.bound is not None:
            here = here.bound
        return here

    def settle(self) -> Type:
        """Return the final type: as found, else INT where only whole numbers were seen, else a number."""
        found = self.root()
        if isinstance(found, Type):
            return found
        return INT if found.has_number and not found.has_fraction else NUMBER


AnyType = Type | Unknown

_OPEN = {(n, f): Unknown(has_number=n, has_fraction=f) for n in (False, True) for f in (False, True)}
"""Placeholders, in data kept between bodies, for types that only use determines, by evidence of literals."""

OPEN = _OPEN[False, False]
"""Placeholder for an open type if the evidence for it is kept elsewhere."""


def is_open(kind: AnyType) -> bool:
    """Return whether only use determines a type."""
    return isinstance(known(kind), Unknown)


def is_untold(kind: AnyType) -> bool:
    """Return whether there is no evidence for a type, not even for a number."""
    found = known(kind)
    return isinstance(found, Unknown) and not found.has_number


def opened(kind: AnyType) -> AnyType:
    """Return a type as one body sees it: where it is open, with a new cell."""
    return (
        Unknown(has_number=kind.has_number, has_fraction=kind.has_fraction)
        if isinstance(kind, Unknown)
        else kind
    )


def closed(kind: AnyType) -> AnyType:
    """Return a type in the form kept between bodies."""
    found = known(kind)
    return _OPEN[found.has_number, found.has_fraction] if isinstance(found, Unknown) else found


def article(kind: AnyType) -> str:
    """Return the words for a type with their article: `a length`, `an angle`."""
    words = str(kind)
    return f"an {words}" if words[0] in "aeiou" else f"a {words}"


def known(kind: AnyType) -> AnyType:
    """Return the known type, or the cell where there is none yet."""
    return kind.root() if isinstance(kind, Unknown) else kind


def bind(cell: Unknown, kind: AnyType) -> None:
    """Let an unbound cell have the type `kind` from now on."""
    target = known(kind)
    if target is cell:
        return
    if isinstance(target, Unknown):
        target.has_fraction |= cell.has_fraction
        target.has_number |= cell.has_number
    cell.bound = target


@frozen_dataclass
class Value:
    """A checked expression.

    Attributes:
        expression: in SI units.
        type: known, or a cell in the first pass.
        is_bare: a number without unit, which takes the unit of the place where it stands.
        X_KF: for locations, the frame in whose axes `offset` shifts, given in the work frame; None for a
            variable or parameter, whose value keeps them.
    """

    expression: Expression
    type: AnyType
    is_bare: bool = False
    X_KF: PoseTuple | None = None


valued = maker(Value)
"""Makes a value of all its fields."""
