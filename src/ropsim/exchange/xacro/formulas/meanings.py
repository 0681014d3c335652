"""Values of the parts of an expression, for given values of names."""

from collections.abc import Callable

from ropsim.exchange.xacro.formulas.names import Names
from ropsim.exchange.xacro.formulas.operators import BINARY, applied
from ropsim.exchange.xacro.formulas.values import Value, bounded

Meaning = Callable[[Names], Value]
"""Value of an expression, for given values of names."""
Arguments = tuple[list[Meaning], dict[str, Meaning]]
"""Arguments of a call: by place and by name."""


def first_of(parts: list[Meaning], names: Names, wanted: Callable[[Value], bool]) -> Value:
    """Return the first value that meets a condition, else the last one; later parts are not evaluated."""
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


def grouped_values(parts: list[Meaning]) -> Meaning:
    """Return the meaning of a tuple of expressions."""
    return lambda names: bounded(tuple(part(names) for part in parts))


def called(name: str, function: Callable[..., Value], arguments: Arguments) -> Meaning:
    """Return the result of a function of values."""
    places, keywords = arguments
    return lambda names: applied(
        name, function, [part(names) for part in places], {key: part(names) for key, part in keywords.items()}
    )
