"""Operators of expressions, with bounds on their results."""

import operator
import re
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Any

from ropsim.exchange.xacro.formulas.values import (
    LONGEST,
    LONGEST_LIST,
    Function,
    NameSpace,
    Value,
    XacroError,
    bounded,
    key_of,
    words,
)

_MOST_BITS = 1000
_MOST_SHIFT = 60
_FIELD = re.compile(r"%(?:%|[-+ 0#]*\d{0,3}(?:\.\d{1,3})?[sdifFeEgGxXorc])")
"""A field of a text that is formatted by `%`: up to 999 characters wide, without names."""


def number(value: Value) -> int | float:
    """Return a value that is a number.

    Raises:
        XacroError: it is none.
    """
    if isinstance(value, int | float):
        return value
    raise XacroError(f"`{words(value)[:40]}` is no number")


def _times(a: Value, b: Value) -> Value:
    if isinstance(a, str | list | tuple) or isinstance(b, str | list | tuple):
        return _repeated(a, b)
    return number(a) * number(b)


def _repeated(a: Value, b: Value) -> Value:
    """Return a text or list some times in a row."""
    many, count = (a, b) if isinstance(a, str | list | tuple) else (b, a)
    if not isinstance(many, str | list | tuple) or not isinstance(count, int):
        raise XacroError("`*` takes numbers, or a text or list and a whole number")
    if len(many) * count > (LONGEST if isinstance(many, str) else LONGEST_LIST):
        raise XacroError("`*` makes a text or list that is too long", "make it shorter")
    return many * count


def power(a: Value, b: Value) -> Value:
    """Return a power; whole numbers that become long are computed as floating ones."""
    base, exponent = number(a), number(b)
    if isinstance(base, int) and isinstance(exponent, int) and abs(exponent) * base.bit_length() > _MOST_BITS:
        base = float(base)
    made: Value = base**exponent
    return made


def _remainder(a: Value, b: Value) -> Value:
    return _formatted(a, b) if isinstance(a, str) else number(a) % number(b)


def _formatted(text: str, values: Value) -> str:
    """Return a text with values in its fields, as `%` of Python does it."""
    rest = _FIELD.sub("", text)
    if "%" in rest:
        field = rest[rest.index("%") :][:12]
        raise XacroError(f"`{field}` is no field of a text that is read", "fields are such as %s, %d, %.3f")
    return text % (tuple(values) if isinstance(values, tuple) else (values,))


def _shifted(shift: Callable[[int, int], int]) -> Callable[[Any, Any], Any]:
    def made(a: Value, b: Value) -> Value:
        if not isinstance(a, int) or not isinstance(b, int) or b > _MOST_SHIFT:
            raise XacroError(f"a shift takes whole numbers, and at most {_MOST_SHIFT} places")
        return shift(a, b)

    return made


def _same(a: Value, b: Value) -> bool:
    """Return whether `a is b`: identity of None and truth values, equality of type and value of others."""
    return a is b if a is None or isinstance(a, bool) else type(a) is type(b) and a == b


def _in(a: Value, b: Value) -> bool:
    if isinstance(b, str | list | tuple | dict):
        return operator.contains(b, key_of(a) if isinstance(b, dict) else a)
    raise XacroError(f"`in` goes with `{words(b)[:40]}`", "allowed are lists, texts and dictionaries")


BINARY: Mapping[str, Callable[[Any, Any], Any]] = MappingProxyType(
    {
        "+": operator.add,
        "-": operator.sub,
        "*": _times,
        "/": operator.truediv,
        "//": operator.floordiv,
        "%": _remainder,
        "**": power,
        "|": operator.or_,
        "^": operator.xor,
        "&": operator.and_,
        "<<": _shifted(operator.lshift),
        ">>": _shifted(operator.rshift),
        "==": operator.eq,
        "!=": operator.ne,
        "<": operator.lt,
        ">": operator.gt,
        "<=": operator.le,
        ">=": operator.ge,
        "in": _in,
        "not in": lambda a, b: not _in(a, b),
        "is": _same,
        "is not": lambda a, b: not _same(a, b),
    }
)
"""Operators of two values."""


def applied(
    name: str,
    function: Callable[..., Any],
    values: Sequence[Value],
    keywords: Mapping[str, Value] = MappingProxyType({}),
) -> Value:
    """Return the result of a function, method or operator.

    Args:
        name: of it, for messages.
        function: that computes it.
        values: arguments by place.
        keywords: arguments by name.

    Raises:
        XacroError: it makes nothing of them.
    """
    try:
        made = function(*values, **keywords)
    except XacroError:
        raise
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise XacroError(f"`{name}` cannot be done: {str(error)[:80]}") from None
    except (MemoryError, RecursionError):
        raise XacroError(f"`{name}` becomes too much", "make it smaller") from None
    if not isinstance(made, bool | int | float | str | list | tuple | dict | Function | NameSpace | None):
        raise XacroError(f"`{name}` makes no number or text of that")
    return bounded(made)
