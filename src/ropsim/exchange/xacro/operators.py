"""Operators and functions of expressions, with bounds on their results."""

import math
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Any

from ropsim.exchange.xacro.values import LONGEST_LIST, Value, XacroError, bounded, words

_MOST_BITS = 1000


def _number(value: Value) -> int | float:
    if isinstance(value, int | float):
        return value
    raise XacroError(f"`{words(value)[:40]}` is no number")


def _times(a: Value, b: Value) -> Value:
    return _number(a) * _number(b)


def _power(a: Value, b: Value) -> Value:
    base, exponent = _number(a), _number(b)
    if isinstance(base, int) and isinstance(exponent, int) and abs(exponent) * base.bit_length() > _MOST_BITS:
        base = float(base)
    made: Value = base**exponent
    return made


def _remainder(a: Value, b: Value) -> Value:
    return _number(a) % _number(b)


def _round(value: Value, digits: Value = None) -> Value:
    if digits is None:
        return round(_number(value))
    return round(_number(value), max(-30, min(30, int(_number(digits)))))


BINARY: Mapping[str, Callable[[Any, Any], Any]] = MappingProxyType(
    {
        "+": lambda a, b: a + b,
        "-": lambda a, b: a - b,
        "*": _times,
        "/": lambda a, b: a / b,
        "//": lambda a, b: a // b,
        "%": _remainder,
        "**": _power,
        "==": lambda a, b: a == b,
        "!=": lambda a, b: a != b,
        "<": lambda a, b: a < b,
        ">": lambda a, b: a > b,
        "<=": lambda a, b: a <= b,
        ">=": lambda a, b: a >= b,
        "in": lambda a, b: a in b,
        "not in": lambda a, b: a not in b,
    }
)
"""Operators of two values."""


def _range(*ends: int) -> list[Value]:
    numbers = range(*ends)
    if len(numbers) > LONGEST_LIST:
        raise XacroError("a range is too long", "make it shorter")
    return list(numbers)


FUNCTIONS: Mapping[str, Callable[..., Any]] = MappingProxyType(
    {
        name: getattr(math, name)
        for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh")
    }
    | {
        name: getattr(math, name)
        for name in ("tanh", "sqrt", "exp", "log", "log10", "hypot", "fabs", "floor")
    }
    | {
        name: getattr(math, name)
        for name in ("ceil", "radians", "degrees", "copysign", "fmod", "trunc", "isclose")
    }
    | {
        "pow": _power,
        "abs": abs,
        "min": min,
        "max": max,
        "round": _round,
        "len": len,
        "sum": sum,
        "str": words,
    }
    | {"int": int, "float": float, "bool": bool, "range": _range, "sorted": sorted}
)
"""All callable functions."""

CONSTANTS: Mapping[str, Value] = MappingProxyType(
    {"pi": math.pi, "e": math.e, "tau": math.tau, "True": True, "False": False, "None": None}
    | {"true": True, "false": False}
)
"""Names that stand for values in every file, unless it defines them anew."""


def applied(name: str, function: Callable[..., Any], values: Sequence[Value]) -> Value:
    """Return the result of a function or operator.

    Raises:
        XacroError: it makes nothing of them.
    """
    try:
        made = function(*values)
    except XacroError:
        raise
    except (ArithmeticError, TypeError, ValueError, MemoryError, RecursionError) as error:
        raise XacroError(f"`{name}` cannot be done: {str(error)[:80]}") from None
    if not isinstance(made, bool | int | float | str | list | dict | None):
        raise XacroError(f"`{name}` makes no number or text of that")
    return bounded(made)
