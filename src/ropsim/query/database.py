"""Inputs with revisions, and functions of them whose answers are kept as long as they hold.

Every question that a function asks while it runs is noted, so that later only what depends on a changed input
is looked at again; a function that gives the answer that it gave before ends the search there.

References:
    J. Matklad et al., Salsa: a generic framework for on-demand, incrementalized computation, 2018-2024
    (inputs, derived queries, revisions of the last change, verification of dependencies).
"""

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass, field
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

from ropsim.query.content import is_same
from ropsim.query.event import Event, Outcome

P = ParamSpec("P")
T = TypeVar("T")

MAX_KEPT = 400_000
"""Answers kept before those of no use lately are given up."""
KEPT_REVISIONS = 4
"""An answer that nobody asked for during so many changes of inputs is of no use lately."""

_Key = tuple[Hashable, ...]


@dataclass(slots=True)
class _Input:
    value: object
    changed: int


@dataclass(slots=True)
class _Answer:
    """What a function gave.

    Attributes:
        value: its answer.
        verified: revision in which it was last known to hold.
        changed: revision in which it became what it is.
        inputs: inputs that it read.
        answers: questions that it asked, in order.
    """

    value: object
    verified: int
    changed: int
    inputs: tuple[Hashable, ...]
    answers: tuple[_Key, ...]


@dataclass(slots=True)
class _Running:
    """What a function that runs now has looked at so far."""

    inputs: dict[Hashable, None] = field(default_factory=dict)
    answers: dict[_Key, None] = field(default_factory=dict)


class Database:
    """Inputs and kept answers. Functions are given the database first and may look at nothing but it.

    Attributes:
        revision: how often inputs have changed.
        events: what was asked since `events` was last cleared; None, as at first, keeps none.
    """

    def __init__(self, limit: int = MAX_KEPT) -> None:
        self.revision = 1
        self.events: list[Event] | None = None
        self._limit = limit
        self._inputs: dict[Hashable, _Input] = {}
        self._answers: dict[_Key, _Answer] = {}
        self._running: list[_Running] = []

    def __len__(self) -> int:
        """Return how many answers are kept."""
        return len(self._answers)

    def give(self, values: Mapping[Hashable, object]) -> None:
        """Give inputs; those that are what they were change nothing. None stands for one that is gone."""
        changed = [
            (name, value)
            for name, value in values.items()
            if name not in self._inputs or not is_same(self._inputs[name].value, value)
        ]
        if changed:
            self.revision += 1
            for name, value in changed:
                self._inputs[name] = _Input(value, self.revision)
        if len(self._answers) > self._limit:
            self._forget()

    def read(self, name: Hashable) -> Any:  # noqa: ANN401 - inputs are of any type
        """Return an input; None where nobody has given it."""
        if self._running:
            self._running[-1].inputs[name] = None
        found = self._inputs.get(name)
        return found.value if found is not None else None

    def ask(self, function: Callable[Concatenate["Database", P], T], *arguments: P.args, **_: P.kwargs) -> T:
        """Return what a function gives for its arguments, by content the same as if it were called now."""
        key: _Key = (function, *cast(tuple[Hashable, ...], arguments))
        if self._running:
            self._running[-1].answers[key] = None
        found = self._answers.get(key)
        if found is None or found.verified != self.revision:
            found = self._verified(key, found)
        return cast(T, found.value)

    def _verified(self, key: _Key, known: _Answer | None) -> _Answer:
        if known is not None and self._holds(known):
            known.verified = self.revision
            self._note(key, Outcome.REUSED)
            return known
        function = cast(Callable[..., object], key[0])
        self._running.append(_Running())
        try:
            value = function(self, *key[1:])
        finally:
            looked = self._running.pop()
        is_kept = known is not None and is_same(known.value, value)
        changed = known.changed if known is not None and is_kept else self.revision
        value = known.value if known is not None and is_kept else value
        found = _Answer(value, self.revision, changed, tuple(looked.inputs), tuple(looked.answers))
        self._answers[key] = found
        self._note(key, Outcome.SAME if is_kept else Outcome.RAN)
        return found

    def _holds(self, known: _Answer) -> bool:
        """Return whether nothing that an answer was made of has changed since it was known to hold."""
        since = known.verified
        for name in known.inputs:
            given = self._inputs.get(name)
            if given is not None and given.changed > since:
                return False
        for key in known.answers:
            one = self._answers.get(key)
            if one is None or one.verified != self.revision:
                one = self._verified(key, one)
            if one.changed > since:
                return False
        return True

    def _note(self, key: _Key, outcome: Outcome) -> None:
        if self.events is not None:
            name = getattr(key[0], "__name__", str(key[0]))
            self.events.append(Event(name, key[1:], outcome))

    def _forget(self) -> None:
        """Give up answers of no use lately, and inputs that were gone before any of the others was known."""
        oldest = self.revision - KEPT_REVISIONS
        self._answers = {key: one for key, one in self._answers.items() if one.verified >= oldest}
        self._inputs = {
            name: one for name, one in self._inputs.items() if one.value is not None or one.changed >= oldest
        }
