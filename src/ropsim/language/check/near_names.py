"""Variables that nothing reads, and those that a misspelt assignment has made."""

import re
from collections.abc import Iterator

from ropsim.language.check.body import Body
from ropsim.language.check.world import Variable
from ropsim.language.findings import names as kinds
from ropsim.language.prose import edit_distance
from ropsim.language.report import Report

SHORTEST = 4
"""Shorter names are near to each other by chance."""

_DIGITS = re.compile(r"\d+")


def check_near_names(body: Body) -> None:
    """Warn of each variable that nothing reads and whose name is one slip from that of another (N237).

    Numbers in names do not count: `slot1` is not `slot2` misspelt.
    """
    unread = [name for name in body.made if name not in body.read]
    if not unread:
        return
    variables = _by_letters(body)
    by_slip: dict[str, set[str]] = {}
    for letters in variables:
        for key in _slips(letters):
            by_slip.setdefault(key, set()).add(letters)
    for name in unread:
        letters = _letters(name)
        near = {one for key in _slips(letters) for one in by_slip.get(key, ()) if _is_near(letters, one)}
        if near:
            line, place = body.made[name]
            best = variables[min(near)][0]
            message = f"`{name}` is a new variable that nothing reads"
            body.report.at(kinds.NEW_BESIDE, line, place, message, f"did you mean `{best}`?", fix=best)
            del body.made[name]


def check_unread(body: Body, report: Report) -> None:
    """Hint at each variable that nothing reads (N239), where all lines are right: a wrong one may read it."""
    for name, (line, place) in body.made.items():
        if name not in body.read:
            hint = "leave the assignment out, or use what it keeps"
            report.at(kinds.UNUSED_VARIABLE, line, place, f"nothing reads the variable `{name}`", hint)


def _by_letters(body: Body) -> dict[str, list[str]]:
    """Return the variables that can be seen, by their names without numbers."""
    found: dict[str, list[str]] = {}
    for name, symbol in {**body.world.symbols, **body.names}.items():
        if isinstance(symbol, Variable) and "__" not in name:
            found.setdefault(_letters(name), []).append(name)
    return found


def _letters(name: str) -> str:
    return _DIGITS.sub("", name).lower()


def _slips(letters: str) -> Iterator[str]:
    """Yield a name, and it without each of its letters: names one slip apart have one of these in common."""
    if len(letters) >= SHORTEST:
        yield letters
        yield from (letters[:k] + letters[k + 1 :] for k in range(min(len(letters), 40)))


def _is_near(one: str, other: str) -> bool:
    return one != other and edit_distance(one, other) == 1
