"""The value types of ICR and constants of them."""

from enum import Enum

from ropsim.core import frozen_dataclass

INT_MIN = -(2**63)
INT_MAX = 2**63 - 1

Value = bool | int | float | str | tuple[float, ...]


class Type(Enum):
    """Type of a value; all numbers are SI.

    `VEC` is (x, y, z) [m], `ORI` a unit quaternion (w, x, y, z), `POSE` (x, y, z, qw, qx, qy, qz) and behind
    these up to 12 values of external axes [rad | m], `JOINTS` one coordinate for each axis [rad | m].
    """

    BOOL = "BOOL"
    INT = "INT"
    REAL = "REAL"
    STR = "STR"
    VEC = "VEC"
    ORI = "ORI"
    POSE = "POSE"
    JOINTS = "JOINTS"

    __hash__ = object.__hash__
    """Each type is one object; that of `Enum` is a call of Python at every access to a table."""


WIDTHS = {Type.VEC: 3, Type.ORI: 4, Type.POSE: 7}
"""How many REALs a constant of a composite type has; a POSE may carry values of external axes behind them."""

MAX_EXTERNAL = 12
"""How many values of external axes a POSE may carry."""


@frozen_dataclass
class Constant:
    """A typed value: the operand of PUSH."""

    type: Type
    value: Value


def has_form(constant: Constant) -> bool:
    """Return whether the Python value has the form that the type requires (finite or not)."""
    value = constant.value
    if constant.type is Type.BOOL:
        return isinstance(value, bool)
    if constant.type is Type.INT:
        return isinstance(value, int) and not isinstance(value, bool) and INT_MIN <= value <= INT_MAX
    if constant.type is Type.REAL:
        return isinstance(value, float)
    if constant.type is Type.STR:
        return isinstance(value, str)
    if not isinstance(value, tuple) or not all(isinstance(part, float) for part in value):
        return False
    if constant.type is Type.POSE:
        return 0 <= len(value) - WIDTHS[Type.POSE] <= MAX_EXTERNAL
    return len(value) == WIDTHS.get(constant.type, max(len(value), 1))


def reals(constant: Constant) -> tuple[float, ...]:
    """Return the REALs that a constant consists of; none for BOOL, INT and STR."""
    if isinstance(constant.value, float):
        return (constant.value,)
    return constant.value if isinstance(constant.value, tuple) else ()


def rotation(constant: Constant) -> tuple[float, ...]:
    """Return the quaternion (w, x, y, z) inside a constant; empty if the type has no quaternion."""
    if not isinstance(constant.value, tuple):
        return ()
    if constant.type is Type.POSE:
        return constant.value[3:7]
    return constant.value if constant.type is Type.ORI else ()
