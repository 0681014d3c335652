"""Texts loaded into an engine: module and permissions of each."""

from enum import Enum

from ropsim.core import frozen_dataclass
from ropsim.prolog.terms.terms import Atom, Struct, Term


class Trust(Enum):
    """Permissions of a text; the values are the ways to call its goals."""

    OWN = "open"
    STRANGER = "safe"


@frozen_dataclass
class LoadedText:
    """A loaded text, its module, and its permissions."""

    path: str
    content: bytes
    module: str
    trust: Trust

    def request(self, place: str) -> Term:
        """Return the request to load it from where Prolog sees it."""
        return Struct("load", (Atom(place), Atom(self.module), Atom(self.trust.value)))
