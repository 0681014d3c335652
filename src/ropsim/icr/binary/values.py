"""Types and constants in the binary form."""

from ropsim.icr.binary.sink import Sink
from ropsim.icr.binary.supply import DamageError, Supply
from ropsim.icr.types import MAX_EXTERNAL, WIDTHS, Constant, Type, Value

TYPES = tuple(Type)
"""A type is written as its place here: they stand in the order of ISO/TR 10562 and never change it."""


def put_type(sink: Sink, kind: Type) -> None:
    """Write a type."""
    sink.byte(TYPES.index(kind))


def take_type(supply: Supply) -> Type:
    """Read a type."""
    number = supply.byte("a type")
    if number >= len(TYPES):
        raise DamageError(supply.at - 1, f"there is no type {number}")
    return TYPES[number]


def put_constant(sink: Sink, constant: Constant) -> None:
    """Write type and value."""
    put_type(sink, constant.type)
    value = constant.value
    if isinstance(value, bool):
        sink.byte(value)
    elif isinstance(value, int):
        sink.integer(value)
    elif isinstance(value, float):
        sink.reals((value,))
    elif isinstance(value, str):
        sink.text(value)
    else:
        if constant.type not in WIDTHS:
            sink.number(len(value))
        elif constant.type is Type.POSE:
            sink.byte(len(value) - WIDTHS[Type.POSE])
        sink.reals(value)


def take_constant(supply: Supply) -> Constant:
    """Read type and value."""
    kind = take_type(supply)
    return Constant(kind, _take_value(supply, kind))


def _take_value(supply: Supply, kind: Type) -> Value:
    start = supply.at
    if kind is Type.BOOL:
        value = supply.byte("a BOOL")
        if value > 1:
            raise DamageError(start, f"a BOOL is {value}, allowed are 0 and 1")
        return bool(value)
    if kind is Type.INT:
        return supply.integer("an INT")
    if kind is Type.REAL:
        return supply.reals(1, "a REAL")[0]
    if kind is Type.STR:
        return supply.text("a STR")
    if kind is Type.JOINTS:
        count = supply.number("the number of joint coordinates")
        return supply.reals(min(max(count, 1), supply.left), "a JOINTS")
    more = supply.byte("the number of external values") if kind is Type.POSE else 0
    if more > MAX_EXTERNAL:
        raise DamageError(start, f"a POSE has {more} external values, allowed are {MAX_EXTERNAL}")
    return supply.reals(WIDTHS[kind] + more, f"a {kind.value}")
