"""A clause as people write it, one property of a task on a line, and where its parts stand in a text."""

import re
from collections.abc import Mapping

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term, Var, write_term

_OPERATORS = {
    ":=": 990, "is": 700, "=": 700, "==": 700, "\\=": 700, "<": 700, ">": 700, "=<": 700, ">=": 700,
    "+": 500, "-": 500, "*": 400, "/": 400, "mod": 400,
}  # fmt: skip
_LOOSEST = 999
_ANONYMOUS = re.compile(r"_\d+")
"""Names that Prolog assigns to unnamed variables."""


def clause_text(task: Term) -> str:
    """Return the text of a clause; a `task(Head, [Properties])` has a line for each property."""
    match task:
        case Struct("task", (head, tuple(properties))) if properties:
            lines = ",\n  ".join(term_text(one) for one in properties)
            return f"task({term_text(head)}, [\n  {lines}]).\n"
    return f"{term_text(task)}.\n"


def term_text(term: Term, most: int = _LOOSEST) -> str:
    """Return the text of a term, in parentheses where its operator is looser than `most`."""
    match term:
        case Var(name):
            return "_" if _ANONYMOUS.fullmatch(name) else name
        case Struct("\\+", (one,)):
            text = f"\\+ {term_text(one, 900)}"
            return text if most >= 900 else f"({text})"
        case Struct(name, (left, right)) if name in _OPERATORS:
            level = _OPERATORS[name]
            is_left = level in (400, 500)
            words = f"{term_text(left, level if is_left else level - 1)}", f"{term_text(right, level - 1)}"
            is_tight = name in ("*", "/") or (name == "-" and isinstance(right, Atom))
            space = "" if is_tight and not words[1].startswith("-") else " "
            text = f"{words[0]}{space}{name}{space}{words[1]}"
            return text if level <= most else f"({text})"
        case Struct("+" | "-" as name, (one,)) if not isinstance(one, int | float):
            text = f"{name} {term_text(one, 199)}" if most < 200 else f"{name}{term_text(one, 199)}"
            return text if most >= 200 else f"({text})"
        case Struct(name, arguments) if name != "[|]":
            return f"{write_term(Struct(name, ()))[:-2]}({', '.join(term_text(one) for one in arguments)})"
        case tuple():
            return f"[{', '.join(term_text(one) for one in term)}]"
    return write_term(term)


@frozen_dataclass
class ClausePlaces:
    """Where the parts of a clause stand, in characters from the begin of its text.

    Attributes:
        source: name of the text.
        begin: of the clause.
        head: of the clause, begin and end.
        inside: of the list of its properties, with the brackets.
        properties: begin and end of each.
    """

    source: str
    begin: int
    head: tuple[int, int]
    inside: tuple[int, int]
    properties: Mapping[str, tuple[int, int]]


def places_of(found: Term, source: str) -> ClausePlaces | None:
    """Return the places in the reply of `clause_places/2` in kb.pl."""
    match found:
        case Struct("clause", (int(begin), int(a), int(b), int(c), int(d), tuple(property_term))):
            return ClausePlaces(
                source, begin, (a, b), (c, d), dict(filter(None, map(_property, property_term)))
            )
    return None


def field_at(places: ClausePlaces, place: int) -> str:
    """Return the property in which a character of the text stands, `name` for the head; empty for none."""
    if places.head[0] <= place < places.head[1] or place == places.begin:
        return "name"
    return next((name for name, (a, b) in places.properties.items() if a <= place < b), "")


def _property(property_term: Term) -> tuple[str, tuple[int, int]] | None:
    match property_term:
        case Struct("place", (Atom(name), int(begin), int(end))):
            return name, (begin, end)
    return None
