"""Inputs with revisions, and functions of them whose answers are kept as long as they hold.

The database records every input and answer that a function reads. After a change it verifies only the answers
that depend on a changed input; the verification stops at a function that returns its previous answer.

References:
    J. Matklad et al., Salsa: a generic framework for on-demand, incrementalized computation, 2018-2024
    (inputs, derived queries, revisions of the last change, verification of dependencies).
"""

from collections.abc import Callable, Hashable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

from ropsim.query.content import is_same
from ropsim.query.event import Event, Outcome
from ropsim.query.users import Key, Users, kept_users, with_user, without_user

P = ParamSpec("P")
T = TypeVar("T")

MAX_KEPT = 50_000
"""Least number of answers that are kept before unused ones are discarded."""
KEPT_VERSIONS = 8
"""An answer is unused if it was not requested during this number of versions of the inputs."""

_Function = Callable[..., object]
_ALWAYS_NEW: set[_Function] = set()


def always_new(function: Callable[P, T]) -> Callable[P, T]:
    """Mark a function whose results are not compared with earlier ones (no early cut-off).

    For large results: comparing them costs more than recomputing saves.
    """
    _ALWAYS_NEW.add(function)
    return function


@dataclass(slots=True, eq=False)
class _Input:
    """An input: its value, the revision in which it came, and which answers were made of it."""

    value: object
    changed: int
    users: Users = ()


@dataclass(slots=True, eq=False)
class _Answer:
    """Cached result of a function for one tuple of arguments; one object for all its values.

    Attributes:
        key: the function and its arguments.
        value: its answer.
        changed: revision in which the value last changed.
        verified: revision in which it was last found to hold.
        requested: version in which the answer was last requested.
        inputs: that it was made of.
        answers: answers that it was made of, in the order of the requests.
        users: answers that were made of it.
        is_doubtful: whether an input on which it depends, directly or indirectly, has changed since.
    """

    key: Key
    value: Any
    changed: int
    verified: int
    requested: int
    inputs: tuple[_Input, ...] = ()
    answers: "tuple[_Answer, ...]" = ()
    users: Users = ()
    is_doubtful: bool = False


@dataclass(slots=True)
class _Running:
    """Inputs and answers that a running function has read so far."""

    inputs: dict[_Input, None] = field(default_factory=dict)
    answers: dict[_Answer, None] = field(default_factory=dict)


class Database:
    """Inputs and kept answers.

    Functions take the database as first argument and read only the database and their other arguments. No
    function may depend on its own answer.

    Attributes:
        revision: how often inputs have changed.
        events: requests since the list was last cleared, except those for answers that were not in doubt;
            None (the default) records nothing.
    """

    def __init__(self, limit: int = MAX_KEPT) -> None:
        self.revision = 1
        self.events: list[Event] | None = None
        self._least = limit
        self._limit = limit
        self._inputs: dict[Hashable, _Input] = {}
        self._answers: dict[Key, _Answer] = {}
        self._running: list[_Running] = []
        self._version = 1
        self._is_in_version = False

    def __len__(self) -> int:
        """Return how many answers are kept."""
        return len(self._answers)

    def give(self, values: Mapping[Hashable, object]) -> None:
        """Set inputs; an equal value changes nothing. None stands for a removed input."""
        inputs = self._inputs
        changed = [
            (name, value)
            for name, value in values.items()
            if (known := inputs.get(name)) is None or not is_same(known.value, value)
        ]
        if changed:
            self.revision += 1
            for name, value in changed:
                one = inputs.setdefault(name, _Input(None, 0))
                one.value, one.changed = value, self.revision
                self._doubt(one.users)
        if not self._is_in_version:
            self._end_version(is_new=bool(changed))

    @contextmanager
    def version(self) -> Iterator[None]:
        """Let all inputs set inside the block belong to one version; outside, each call makes a version.

        For callers that set inputs made of answers: no answer is discarded before all have been requested.
        """
        before, self._is_in_version = self.revision, True
        try:
            yield
        finally:
            self._is_in_version = False
            self._end_version(is_new=self.revision != before)

    def read(self, name: Hashable) -> Any:  # noqa: ANN401 - inputs are of any type
        """Return an input; None if it was never set."""
        found = self._inputs.get(name)
        if self._running:
            if found is None:
                found = self._inputs[name] = _Input(None, 0)
            self._running[-1].inputs[found] = None
        return found.value if found is not None else None

    def auxiliary(self, name: Hashable, make: Callable[[], T]) -> T:
        """Return an auxiliary object that no answer depends on; made on the first call."""
        found: T | None = self.read(name)
        if found is None:
            found = make()
            self.give({name: found})
        return found

    def ask(self, function: Callable[Concatenate["Database", P], T], *arguments: P.args, **_: P.kwargs) -> T:
        """Return the value of a function for its arguments, the same as if it were called now."""
        given: Any = arguments  # nothing is called here that need not be: there are thousands of questions
        key: Key = (function, *given)
        found = self._answers.get(key)
        if found is None or found.is_doubtful:
            found = self._verified(key, found)
        if self._running:
            self._running[-1].answers[found] = None
        found.requested = self._version
        value: T = found.value
        return value

    def known(
        self, function: Callable[Concatenate["Database", P], T], *arguments: P.args, **_: P.kwargs
    ) -> T | None:
        """Return a kept answer if no input behind it has changed, else None; compute nothing."""
        given: Any = arguments
        found = self._answers.get((function, *given))
        if found is None or found.is_doubtful:
            return None
        found.requested = self._version
        value: T = found.value
        return value

    def _doubt(self, users: Users) -> None:
        """Mark everything that depends on the changed item as doubtful."""
        work = [users]
        while work:
            for key in work.pop():
                one = self._answers.get(key)
                if one is not None and not one.is_doubtful:
                    one.is_doubtful = True
                    work.append(one.users)

    def _verified(self, key: Key, known: _Answer | None) -> _Answer:
        if known is not None and self._holds(known):
            known.verified, known.is_doubtful = self.revision, False
            self._note(key, Outcome.REUSED)
            return known
        function = cast(_Function, key[0])
        self._running.append(_Running())
        try:
            value = function(self, *key[1:])
        finally:
            running = self._running.pop()
        is_kept = known is not None and function not in _ALWAYS_NEW and is_same(known.value, value)
        if known is None:
            known = self._answers[key] = _Answer(key, value, self.revision, self.revision, self._version)
        elif not is_kept:
            known.value, known.changed = value, self.revision
        known.verified, known.is_doubtful = self.revision, False
        self._connect(known, tuple(running.inputs), tuple(running.answers))
        self._note(key, Outcome.SAME if is_kept else Outcome.RAN)
        return known

    def _connect(self, found: _Answer, inputs: tuple[_Input, ...], answers: tuple[_Answer, ...]) -> None:
        """Update the dependencies of an answer, and its entry among the users of each of them."""
        key = found.key
        if found.inputs != inputs:
            for one in found.inputs:
                one.users = without_user(one.users, key)
            for one in inputs:
                one.users = with_user(one.users, key)
            found.inputs = inputs
        if found.answers != answers:
            for answer in found.answers:
                answer.users = without_user(answer.users, key)
            for answer in answers:
                answer.users = with_user(answer.users, key)
            found.answers = answers

    def _holds(self, known: _Answer) -> bool:
        """Return whether nothing that an answer was made of has changed since it was found to hold."""
        since = known.verified
        for given in known.inputs:
            if given.changed > since:
                return False
        for one in known.answers:
            if one.is_doubtful:
                self._verified(one.key, one)
            if one.changed > since:
                return False
        return True

    def _note(self, key: Key, outcome: Outcome) -> None:
        if self.events is not None:
            name = getattr(key[0], "__name__", str(key[0]))
            self.events.append(Event(name, key[1:], outcome))

    def _end_version(self, *, is_new: bool) -> None:
        self._version += is_new
        # nothing is discarded while functions run: their requests are not finished
        if len(self._answers) > self._limit and not self._running:
            self._forget()

    def _forget(self) -> None:
        """Discard unused answers; the dependencies of answers in use stay."""
        oldest = self._version - KEPT_VERSIONS
        work = [one for one in self._answers.values() if one.requested >= oldest]
        kept: dict[Key, _Answer] = {}
        while work:
            one = work.pop()
            if one.key not in kept:
                kept[one.key] = one
                work += one.answers
        self._answers = kept
        for answer in kept.values():
            answer.users = kept_users(answer.users, kept)
        for given in self._inputs.values():
            given.users = kept_users(given.users, kept)
        self._inputs = {name: one for name, one in self._inputs.items() if one.value is not None or one.users}
        self._limit = max(self._least, 2 * len(kept))
