"""Comprehensions: a list with an element for each value of other lists."""

from collections.abc import Iterator

from ropsim.core import frozen_dataclass
from ropsim.exchange.xacro.formulas.meanings import Meaning
from ropsim.exchange.xacro.formulas.names import FileOfNames, Names
from ropsim.exchange.xacro.formulas.values import LONGEST_LIST, Value, XacroError, bounded, words

_TURN = 10  # characters that each turn costs


@frozen_dataclass
class Clause:
    """A `for` of a comprehension with its conditions.

    Attributes:
        variables: names of each value, or of its parts.
        over: list of the values.
        conditions: all of them hold, or the value is left out.
    """

    variables: tuple[str, ...]
    over: Meaning
    conditions: tuple[Meaning, ...]


def comprehended(element: Meaning, clauses: list[Clause]) -> Meaning:
    """Return the meaning of a comprehension; each turn is paid for as some characters of the file.

    Args:
        element: for the values of all variables.
        clauses: from the outermost to the innermost.
    """

    def found(names: Names) -> Value:
        made: list[Value] = []
        for inner in _turns(clauses, names):
            made.append(element(inner))
            if len(made) > LONGEST_LIST:
                raise XacroError(f"a list has more than {LONGEST_LIST} elements", "make it shorter")
        return bounded(made)

    return found


def _turns(clauses: list[Clause], names: Names) -> Iterator[Names]:
    """Yield the names of each turn."""
    if not clauses:
        yield names
        return
    one = clauses[0]
    values = one.over(names)
    if not isinstance(values, list | tuple | str | dict):
        raise XacroError(f"`for` goes over `{words(values)[:40]}`", "allowed are lists, texts, dictionaries")
    for value in values:
        names.file.spend(_TURN)
        inner = _Bound(names, _parts(one.variables, value))
        if all(condition(inner) for condition in one.conditions):
            yield from _turns(clauses[1:], inner)


def _parts(variables: tuple[str, ...], value: Value) -> dict[str, Value]:
    if len(variables) == 1:
        return {variables[0]: value}
    if not isinstance(value, list | tuple) or len(value) != len(variables):
        names = ", ".join(variables)[:40]
        raise XacroError(f"`for {names}` meets `{words(value)[:40]}`", "write as many names as values")
    return dict(zip(variables, value, strict=True))


class _Bound:
    """Names in a comprehension: its variables hide the outer names."""

    def __init__(self, outer: Names, bound: dict[str, Value]) -> None:
        self._outer, self._bound = outer, bound

    @property
    def file(self) -> FileOfNames:
        return self._outer.file

    def value(self, name: str) -> Value:
        return self._bound[name] if name in self._bound else self._outer.value(name)
