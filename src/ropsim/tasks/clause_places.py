"""Where the parts of a clause stand in its text."""

from collections.abc import Mapping

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term


@frozen_dataclass
class ClausePlaces:
    """Where the parts of a clause stand, in characters from the begin of its text.

    Attributes:
        source: name of the text.
        head: of the clause, begin and end.
        inside: of the list of its properties, with the brackets.
        properties: begin and end of each.
    """

    source: str
    head: tuple[int, int]
    inside: tuple[int, int]
    properties: Mapping[str, tuple[int, int]]


def places_of(found: Term, source: str) -> ClausePlaces | None:
    """Return the places that the reply of `clause_places/2` in kb.pl tells."""
    match found:
        case Struct("clause", (_, _, _, int(a), int(b), int(c), int(d), tuple(told))):
            return ClausePlaces(source, (a, b), (c, d), dict(filter(None, map(_property, told))))
    return None


def _property(told: Term) -> tuple[str, tuple[int, int]] | None:
    match told:
        case Struct("place", (Atom(name), int(begin), int(end))):
            return name, (begin, end)
    return None
