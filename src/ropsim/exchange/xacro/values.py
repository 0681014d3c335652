"""Values of expressions: numbers, texts, truth values, lists and dictionaries; none grows without bound."""

from math import isfinite
from typing import TypeAlias

Value: TypeAlias = "bool | int | float | str | list[Value] | dict[str, Value] | None"

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
    if isinstance(value, str) and len(value) > LONGEST:
        raise XacroError(f"a text has more than {LONGEST} characters", "make it shorter")
    if isinstance(value, list | dict):
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
        if isinstance(one, list | dict):
            waiting += one.values() if isinstance(one, dict) else one
            if len(waiting) > left:
                raise XacroError(f"a list has more than {LONGEST_LIST} elements", "make it shorter")
        elif isinstance(one, str) and len(one) > LONGEST_LIST:
            raise XacroError("a list holds a text that is too long", "make it shorter")


def literal(text: str) -> Value:
    """Return the value of a text: a number, a truth value, a text in quotation marks, else itself."""
    word = text.strip()
    if len(word) >= 2 and word[0] == word[-1] and word[0] in "'\"":
        return word[1:-1]
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
    """Return the truth value of an `if` or `unless`.

    Raises:
        XacroError: it has no text form: allowed are true, false, and numbers.
    """
    found = literal(value) if isinstance(value, str) else value
    if isinstance(found, bool | int | float):
        return bool(found)
    raise XacroError(f"a condition is `{words(found)[:40]}`", "allowed are true, false and numbers")
