"""Texts that are in an engine: what each became, and what it may do."""

from enum import Enum

from ropsim.core import frozen_dataclass
from ropsim.prolog.terms.terms import Atom, Struct, Term


class Trust(Enum):
    """What a text may do; the values are how its goals are called."""

    OWN = "open"
    STRANGER = "safe"


@frozen_dataclass
class LoadedText:
    """A text that is in the engine, the module that it is, and what it may do."""

    path: str
    content: bytes
    module: str
    trust: Trust

    def request(self, place: str) -> Term:
        """Return the request to load it from where Prolog sees it."""
        return Struct("load", (Atom(place), Atom(self.module), Atom(self.trust.value)))
