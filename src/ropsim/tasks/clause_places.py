"""Where the parts of a clause stand in its text."""

from collections.abc import Mapping

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term


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
    """Return the places that the reply of `clause_places/2` in kb.pl tells."""
    match found:
        case Struct("clause", (int(begin), int(a), int(b), int(c), int(d), tuple(told))):
            return ClausePlaces(source, begin, (a, b), (c, d), dict(filter(None, map(_property, told))))
    return None


def field_at(places: ClausePlaces, place: int) -> str:
    """Return the property in which a character of the text stands, `name` for the head; empty for none."""
    if places.head[0] <= place < places.head[1] or place == places.begin:
        return "name"
    return next((name for name, (a, b) in places.properties.items() if a <= place < b), "")


def _property(told: Term) -> tuple[str, tuple[int, int]] | None:
    match told:
        case Struct("place", (Atom(name), int(begin), int(end))):
            return name, (begin, end)
    return None
