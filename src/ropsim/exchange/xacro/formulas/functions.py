"""Functions and constants of expressions: the part of Python and its mathematics that xacro offers."""

import math
from collections.abc import Callable, Iterable, Mapping
from types import MappingProxyType
from typing import Any

from ropsim.exchange.xacro.formulas.operators import applied, number, power
from ropsim.exchange.xacro.formulas.values import (
    LONGEST_LIST,
    Function,
    Key,
    Value,
    XacroError,
    key_of,
    words,
)

_MATHEMATICS = (
    *(
        "sin",
        "cos",
        "tan",
        "asin",
        "acos",
        "atan",
        "atan2",
        "sinh",
        "cosh",
        "tanh",
        "asinh",
        "acosh",
        "atanh",
    ),
    *("sqrt", "exp", "expm1", "log", "log2", "log10", "log1p", "hypot", "fabs", "floor", "ceil", "trunc"),
    *("radians", "degrees", "copysign", "fmod", "isclose", "isfinite", "isinf", "isnan", "fsum"),
)


def _round(value: Value, ndigits: Value = None) -> Value:
    if ndigits is None:
        return round(number(value))
    return round(number(value), max(-30, min(30, int(number(ndigits)))))


def _range(*ends: int) -> list[Value]:
    numbers = range(*ends)
    if len(numbers) > LONGEST_LIST:
        raise XacroError("a range is too long", "make it shorter")
    return list(numbers)


def _map(function: Value, *lists: Iterable[Value]) -> list[Value]:
    if not isinstance(function, Function):
        raise XacroError("the first argument of `map` is no function", "name one, such as float")
    found: list[Value] = []
    left = LONGEST_LIST
    for values in zip(*lists, strict=False):
        found.append(applied(function.name, function.call, values))
        left -= len(found[-1]) + 1 if isinstance(found[-1], list | tuple | dict) else 1
        if left < 0:
            raise XacroError(f"a list has more than {LONGEST_LIST} elements", "make it shorter")
    return found


def _dictionary(*pairs: Iterable[tuple[Value, Value]], **named: Value) -> dict[Key, Value]:
    return {key_of(key): value for key, value in dict(*pairs, **named).items()}


def _pairs(*lists: Iterable[Value]) -> list[Value]:
    return list(zip(*lists, strict=False))


def _numbered(values: Iterable[Value], start: int = 0) -> list[Value]:
    return list(enumerate(values, start))


def _backwards(values: list[Value]) -> list[Value]:
    return list(reversed(values))


FUNCTIONS: Mapping[str, Callable[..., Any]] = MappingProxyType(
    {name: getattr(math, name) for name in _MATHEMATICS}
    | {
        "pow": power,
        "abs": abs,
        "min": min,
        "max": max,
        "round": _round,
        "len": len,
        "sum": sum,
        "str": words,
    }
    | {"int": int, "float": float, "bool": bool, "range": _range, "sorted": sorted, "list": list}
    | {"tuple": tuple, "dict": _dictionary, "map": _map, "zip": _pairs, "enumerate": _numbered}
    | {"reversed": _backwards, "all": all, "any": any, "divmod": divmod}
)
"""All functions, by name; `math.` and `python.` may stand before it."""

CONSTANTS: Mapping[str, Value] = MappingProxyType(
    {"pi": math.pi, "e": math.e, "tau": math.tau, "True": True, "False": False, "None": None}
    | {"true": True, "false": False}
    | {name: Function(name, function) for name, function in FUNCTIONS.items()}
)
"""Names that stand for values in every file, unless it defines them anew."""
