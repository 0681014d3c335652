"""Values of the parts of an expression, for given values of names."""

from collections.abc import Callable, Mapping
from typing import Protocol

from ropsim.exchange.xacro.operators import BINARY, applied
from ropsim.exchange.xacro.values import Value, XacroError, bounded


class Names(Protocol):
    """Values by name."""

    def value(self, name: str) -> Value:
        """Return the value of a name.

        Raises:
            XacroError: it is undefined.
        """
        ...

    def loaded(self, path: str) -> Value:
        """Return the value of a parameter file.

        Raises:
            XacroError: it cannot be had.
        """
        ...


Meaning = Callable[[Names], Value]
"""Value of an expression, for given values of names."""


def true(value: Value) -> bool:
    """Return whether a value decides an `or`."""
    return bool(value)


def false(value: Value) -> bool:
    """Return whether a value decides an `and`."""
    return not value


def first_of(parts: list[Meaning], names: Names, wanted: Callable[[Value], bool]) -> Value:
    """Return the first value that decides `or` or `and`; later ones are not evaluated."""
    value: Value = None
    for part in parts:
        value = part(names)
        if wanted(value):
            break
    return value


def folded(left: Meaning, rest: list[tuple[str, Meaning]], names: Names) -> Value:
    """Return the result of operators on values, from left to right."""
    value = left(names)
    for name, part in rest:
        value = applied(name, BINARY[name], [value, part(names)])
    return value


def compared(left: Meaning, rest: list[tuple[str, Meaning]], names: Names) -> Value:
    """Return whether a chain of comparisons holds: a < b < c is a < b and b < c."""
    value = left(names)
    for name, part in rest:
        other = part(names)
        if not applied(name, BINARY[name], [value, other]):
            return False
        value = other
    return True


def constant(value: Value) -> Meaning:
    """Return the meaning of a value itself."""
    return lambda _: value


def named(name: str) -> Meaning:
    """Return the meaning of a name."""
    return lambda names: names.value(name)


def listed_values(parts: list[Meaning]) -> Meaning:
    """Return the meaning of a list of expressions."""
    return lambda names: bounded([part(names) for part in parts])


def indexed(of: Meaning, index: Meaning, default: Meaning | None = None) -> Meaning:
    """Return the value at an index; if there is none, the default, if given, as `get` does."""

    def found(names: Names) -> Value:
        holder, key = of(names), index(names)
        if isinstance(holder, Mapping) and str(key) in holder:
            return holder[str(key)]
        if isinstance(holder, list | str) and isinstance(key, int) and -len(holder) <= key < len(holder):
            return holder[key]
        if default is not None and isinstance(holder, Mapping):
            return default(names)
        raise XacroError(f"there is nothing at `{str(key)[:40]}`", "look at the list or dictionary")

    return found
