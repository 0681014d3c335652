"""What the manual says of numbers: whole ones of 64 bits, real ones of 64 bits, and where a program traps."""

import math
from collections.abc import Callable

Number = bool | int | float
DEGREE = math.pi / 180.0
MM = 0.001
LARGEST = 2**63


class TrapError(Exception):
    """The program cannot go on; the message is the code of the trap."""


def whole(value: int) -> int:
    """Return a whole number that has a place in 64 bits."""
    if not -LARGEST <= value < LARGEST:
        raise TrapError("I461")
    return value


def finite(value: float) -> float:
    """Return a real number."""
    if not math.isfinite(value):
        raise TrapError("I461")
    return value


def rounded(value: float) -> int:
    """Return the nearest whole number, halves away from zero."""
    below = math.floor(abs(value))
    nearest = below + (1 if abs(value) - below >= 0.5 else 0)
    return whole(nearest if value >= 0.0 else -nearest)


def _defined(function: Callable[..., float]) -> Callable[..., float]:
    def checked(*values: float) -> float:
        try:
            return finite(function(*values))
        except ValueError:
            raise TrapError("I461") from None

    return checked


def _divisor(value: Number) -> Number:
    if value == 0:
        raise TrapError("I460")
    return value


REAL: dict[str, Callable[..., Number]] = {
    "+": lambda a, b: finite(a + b),
    "-": lambda a, b: finite(a - b),
    "*": lambda a, b: finite(a * b),
    "/": lambda a, b: finite(a / _divisor(b)),
    "mod": lambda a, b: a % _divisor(b),
    "min": lambda a, b: b if b < a else a,
    "max": lambda a, b: b if b > a else a,
    "neg": lambda a: -a,
    "abs": abs,
    "sqrt": _defined(math.sqrt),
    "sin": lambda a: math.sin(finite(a * DEGREE)),
    "cos": lambda a: math.cos(finite(a * DEGREE)),
    "tan": lambda a: finite(math.tan(finite(a * DEGREE))),
    "asin": _defined(math.asin),
    "acos": _defined(math.acos),
    "atan2": math.atan2,
    "round": rounded,
    "trunc": lambda a: whole(math.trunc(a)),
    "per mm": lambda a: finite(a / MM),
    "as mm": lambda a: finite(a * MM),
    "more mm": lambda a, b: finite(a + finite(b * MM)),
}
"""Operations whose operands are taken as real numbers."""

WHOLE: dict[str, Callable[..., Number]] = {
    "+": lambda a, b: whole(a + b),
    "-": lambda a, b: whole(a - b),
    "*": lambda a, b: whole(a * b),
    "mod": lambda a, b: a - b * (a // _divisor(b)),
    "min": min,
    "max": max,
    "neg": lambda a: whole(-a),
    "abs": lambda a: whole(abs(a)),
}
"""Operations of whole numbers that stay whole."""

TRUTH: dict[str, Callable[[Number, Number], bool]] = {
    "=": lambda a, b: a == b,
    "==": lambda a, b: a == b,
    "<>": lambda a, b: a != b,
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
    "and": lambda a, b: bool(a and b),
    "or": lambda a, b: bool(a or b),
}
"""Operations that give a truth value; both sides have been computed."""


def shown(value: Number) -> str:
    """Return how `print` shows a value."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return format(value or 0.0, ".6g") if isinstance(value, float) else str(value)
