"""Values of expressions: numbers, texts, truth values, lists and dictionaries; none grows without bound."""

from collections.abc import Callable
from math import isfinite
from typing import Any, Protocol, TypeAlias, runtime_checkable

from ropsim.core import frozen_dataclass


@runtime_checkable
class NameSpace(Protocol):
    """Properties of a file that is included with `ns`; a value with members."""

    def value(self, name: str) -> "Value":
        """Return the value of a property.

        Raises:
            XacroError: it is undefined.
        """
        ...


@frozen_dataclass
class Function:
    """A function that an expression names without calling it, such as the first argument of `map`."""

    name: str
    call: Callable[..., Any]

    def __str__(self) -> str:
        return f"function {self.name}"


Key: TypeAlias = bool | int | float | str | None
"""A key of a dictionary."""
Value: TypeAlias = (
    "bool | int | float | str | list[Value] | tuple[Value, ...] | dict[Key, Value]"
    " | Function | NameSpace | None"
)

LONGEST = 20_000
"""Characters of a text."""
LONGEST_LIST = 2_000
"""Elements of a list or dictionary, including nested lists."""
_LARGEST_INTEGER = 10**18


class XacroError(Exception):
    """Something of a xacro file cannot be expanded; the message is a clause of its own."""

    def __init__(self, message: str, hint: str = "look at the expression") -> None:
        super().__init__(message)
        self.message, self.hint = message, hint


def bounded(value: Value) -> Value:
    """Return a value that may be kept: whole numbers beyond 10^18 become floating ones.

    Raises:
        XacroError: it is not finite, or too long.
    """
    if isinstance(value, int) and abs(value) > _LARGEST_INTEGER:
        value = float(value) if abs(value) < 10**300 else float("inf")
    if isinstance(value, float) and not isfinite(value):
        raise XacroError("a number is not finite", "allowed are finite numbers only")
    return short(value)


def short(value: Value) -> Value:
    """Return a value that may be kept as long as it is not too long; a number may be infinite.

    Raises:
        XacroError: it is too long.
    """
    if isinstance(value, str) and len(value) > LONGEST:
        raise XacroError(f"a text has more than {LONGEST} characters", "make it shorter")
    if isinstance(value, list | tuple | dict):
        _count(value)
    return value


def _count(value: Value) -> None:
    """Make sure that a list is not too long, with the lists in it: some doublings make millions of those."""
    waiting, left = [value], LONGEST_LIST
    while waiting:
        one = waiting.pop()
        left -= 1
        if left < 0:
            raise XacroError(f"a list has more than {LONGEST_LIST} elements", "make it shorter")
        if isinstance(one, list | tuple | dict):
            waiting += one.values() if isinstance(one, dict) else one
            if len(waiting) > left:
                raise XacroError(f"a list has more than {LONGEST_LIST} elements", "make it shorter")
        elif isinstance(one, str) and len(one) > LONGEST_LIST:
            raise XacroError("a list holds a text that is too long", "make it shorter")


def key_of(value: Value) -> Key:
    """Return a value as a key of a dictionary.

    Raises:
        XacroError: it is a list or the like.
    """
    if value is None or isinstance(value, bool | int | float | str):
        return value
    raise XacroError(f"`{words(value)[:40]}` is no key of a dictionary", "take a text or a number")


def unquoted(text: str) -> str:
    """Return the text inside single quotation marks, else the text itself."""
    return text[1:-1] if len(text) >= 2 and text[0] == text[-1] == "'" else text


def literal(text: str) -> Value:
    """Return a text as a number, a truth value or the text inside single quotation marks, else itself."""
    word = text.strip()
    if unquoted(text) != text:
        return unquoted(text)
    for kind in (int, float):
        try:
            if "_" not in word and word.isascii():
                return bounded(kind(word)) if len(word) < 400 else text
        except (ValueError, XacroError):
            continue
    return {"true": True, "True": True, "false": False, "False": False}.get(word, text)


def words(value: Value) -> str:
    """Return a value in text form.

    Raises:
        XacroError: it is too long.
    """
    found = value if isinstance(value, str) else str(value)
    if len(found) > LONGEST:
        raise XacroError(f"a text has more than {LONGEST} characters", "make it shorter")
    return found


def truth(value: Value) -> bool:
    """Return the truth value of an `if` or `unless`; lists and dictionaries are true if they hold anything.

    Raises:
        XacroError: it is a text that is no truth value.
    """
    found = literal(value) if isinstance(value, str) else value
    if not isinstance(found, str):
        return bool(found)
    raise XacroError(f"a condition is `{found[:40]}`", "allowed are true, false and numbers")
