"""Beliefs in the body of a task: facts that hold, that do not, and unknown ones."""

from collections.abc import Iterator, Mapping
from enum import Enum
from itertools import islice

from ropsim.prolog import Struct, Term, Var, leaves

Path = tuple[int, ...]
"""Where a statement stands in a body: numbers of elements of lists and of arguments, from 0."""
OPEN = "?"
"""Names of variables that stand for anything begin so; all others are parameters of the task."""
MOST_TRIED = 50
"""Number of facts of a name that are tried for a condition whose part is unknown."""


class Held(Enum):
    """Whether a fact holds."""

    YES = "yes"
    NO = "no"
    OPEN = "open"
    """Steps have touched it, and in which way is not known."""


class Believed:
    """Facts with whether they hold; changes are logged, so that a branch costs only its changes.

    Attributes:
        touched: names of facts of which steps have changed some that have no name of a thing.
        steps: the last step that changed each fact.
    """

    def __init__(self) -> None:
        self._facts: dict[Term, Held] = {}
        self._log: list[tuple[Term, Held | None]] = []
        self._of_name: dict[tuple[str, int], dict[Struct, None]] = {}
        self.touched: set[str] = set()
        self.steps: dict[Term, Path] = {}

    def of(self, fact: Term) -> Held | None:
        """Return whether a fact holds; None where neither conditions nor steps say anything of it."""
        return self._facts.get(fact)

    def put(self, fact: Term, value: Held, step: Path | None = None) -> None:
        """Believe a fact, or that it does not hold; `step` says which step has changed it."""
        old = self._facts.get(fact)
        if old is value:
            return
        self._log.append((fact, old))
        if isinstance(fact, Struct):
            self._of_name.setdefault((fact.name, len(fact.arguments)), {})[fact] = None
        self._facts[fact] = value
        if step is not None:
            self.steps[fact] = step

    def mark(self) -> int:
        """Return a place in the log."""
        return len(self._log)

    def changed(self, mark: int) -> Mapping[Term, tuple[Held | None, Held | None]]:
        """Return the changes since a mark: whether each fact held then, and holds now."""
        before: dict[Term, Held | None] = {}
        for fact, old in self._log[mark:]:
            before.setdefault(fact, old)
        return {fact: (old, self._facts.get(fact)) for fact, old in before.items()}

    def back(self, mark: int) -> None:
        """Take back all changes since a mark."""
        while len(self._log) > mark:
            fact, old = self._log.pop()
            if old is None:
                del self._facts[fact]
            else:
                self._facts[fact] = old

    def holding(self, pattern: Struct) -> Iterator[Struct]:
        """Yield facts that hold and that a pattern with variables fits, the latest first."""
        known = self._of_name.get((pattern.name, len(pattern.arguments)), {})
        for fact in islice(reversed(known), MOST_TRIED):
            pairs = zip(pattern.arguments, fact.arguments, strict=True)
            fits = all(is_open(one) or one == other for one, other in pairs)
            if fits and self._facts.get(fact) is Held.YES:
                yield fact

    def all(self) -> Mapping[Term, Held]:
        """Return all facts."""
        return self._facts


def is_open(term: Term) -> bool:
    """Return whether a term is a variable that is no parameter of the task: it stands for anything."""
    return isinstance(term, Var) and term.name.startswith(OPEN)


def has_open(term: Term) -> bool:
    """Return whether there is an open variable in a term."""
    return any(map(is_open, leaves(term)))
