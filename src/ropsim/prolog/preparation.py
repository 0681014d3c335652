"""Contents of an engine from its first start on, before any text of users."""

from collections.abc import Mapping
from dataclasses import field
from hashlib import sha256
from pathlib import PurePosixPath

from ropsim.core import SourceText, frozen_dataclass
from ropsim.prolog.terms.predicate import Predicate
from ropsim.prolog.terms.terms import Term
from ropsim.prolog.terms.texts import LoadedText, Trust
from ropsim.prolog.terms.writing import write_term


@frozen_dataclass
class Preparation:
    """Functions, facts and parts of ropsim: given to Prolog once, others of this machine go on from there.

    Attributes:
        predicates: functions of Python.
        facts: by the module that holds them; `Engine.put_facts` puts others in their place.
        sources: parts of ropsim that are written in Prolog, in their order: trusted, and not checked, which
            tests have done.
    """

    predicates: tuple[Predicate, ...] = ()
    facts: Mapping[str, tuple[Term, ...]] = field(default_factory=dict)
    sources: tuple[SourceText, ...] = ()

    def loads(self) -> tuple[LoadedText, ...]:
        """Return the sources in loading order."""
        return tuple(
            LoadedText(f"/kb/{one.name}", one.text.encode(), PurePosixPath(one.name).stem, Trust.OWN)
            for one in self.sources
        )

    def mark(self, door: str) -> str:
        """Return a key of these contents.

        Args:
            door: the text of the module of all predicates.
        """
        hasher = sha256(door.encode())
        for module, facts in self.facts.items():
            hasher.update(f"\n{module} {' '.join(map(write_term, facts))}".encode())
        for one in self.loads():
            hasher.update(f"\n{one.path} {len(one.content)}\n".encode() + one.content)
        return hasher.hexdigest()
