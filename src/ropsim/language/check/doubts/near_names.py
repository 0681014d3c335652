"""Variables that nothing reads, and variables made by a misspelt assignment."""

import re
from collections.abc import Callable, Container, Iterable, Iterator, Mapping

from ropsim.core import Diagnostic, Span, TextEdit, edit_distance
from ropsim.language.check.scope.body import Made
from ropsim.language.check.scope.world import Symbol, Variable
from ropsim.language.findings import names as kinds

SHORTEST = 4
"""Shorter names are near to each other by chance."""

_DIGITS = re.compile(r"\d+")


def near_names(
    made: Mapping[str, Made], read: Container[str], visible: Callable[[], Iterable[str]]
) -> Iterator[tuple[str, Diagnostic]]:
    """Yield a warning for each variable that nothing reads and whose name is one slip from another's (N237).

    Numbers in names do not count: `slot1` is not `slot2` misspelt.

    Args:
        made: variables that an assignment made, and where.
        read: names of the variables that are read.
        visible: returns the names of all visible variables.
    """
    unread = [name for name in made if name not in read]
    if not unread:
        return
    variables = _by_letters(visible())
    by_slip: dict[str, set[str]] = {}
    for letters in variables:
        for key in _slips(letters):
            by_slip.setdefault(key, set()).add(letters)
    for name in unread:
        letters = _letters(name)
        near = {one for key in _slips(letters) for one in by_slip.get(key, ()) if _is_near(letters, one)}
        if near:
            best = variables[min(near)][0]
            message = f"`{name}` is a new variable that nothing reads"
            span = _span(made[name])
            hint, fix = f"did you mean `{best}`?", TextEdit(span, best)
            yield name, kinds.NEW_BESIDE.at(span, message, hint=hint, fix=fix)


def unread_variables(made: Mapping[str, Made], read: Container[str]) -> Iterator[Diagnostic]:
    """Yield a hint for each variable that nothing reads (N239): reported only if all lines are right."""
    for name, one in made.items():
        if name not in read:
            message, hint = (
                f"nothing reads the variable `{name}`",
                "leave the assignment out, or use what it keeps",
            )
            yield kinds.UNUSED_VARIABLE.at(_span(one), message, hint=hint)


def seen_variables(symbols: Mapping[str, Symbol]) -> Iterator[str]:
    """Yield the names of all variables."""
    return (name for name, symbol in symbols.items() if isinstance(symbol, Variable))


def _span(made: Made) -> Span:
    return made.line.logical.span(made.unit, made.place.start, made.place.end)


def _by_letters(names: Iterable[str]) -> dict[str, list[str]]:
    """Return names of variables without their digits."""
    found: dict[str, list[str]] = {}
    for name in names:
        if "__" not in name:
            found.setdefault(_letters(name), []).append(name)
    return found


def _letters(name: str) -> str:
    return _DIGITS.sub("", name).lower()


def _slips(letters: str) -> Iterator[str]:
    """Yield a name, and it without each of its letters: names one slip apart share at least one of them."""
    if len(letters) >= SHORTEST:
        yield letters
        yield from (letters[:k] + letters[k + 1 :] for k in range(min(len(letters), 40)))


def _is_near(one: str, other: str) -> bool:
    return one != other and edit_distance(one, other) == 1
