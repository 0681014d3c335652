"""The same questions where inputs never change: answers are kept, and nothing else."""

from collections.abc import Callable, Hashable, Mapping
from typing import Any, Concatenate, ParamSpec, TypeVar

from ropsim.query.database import Database

P = ParamSpec("P")
T = TypeVar("T")

_MISSING = object()


class Once(Database):
    """A database for one state of the inputs, each given before anybody asks for what is made of it."""

    def __init__(self) -> None:
        super().__init__()
        self._given: dict[Hashable, object] = {}
        self._known: dict[tuple[Hashable, ...], Any] = {}

    def __len__(self) -> int:
        """Return how many answers are kept."""
        return len(self._known)

    def give(self, values: Mapping[Hashable, object]) -> None:
        """Give inputs."""
        self._given.update(values)

    def read(self, name: Hashable) -> Any:  # noqa: ANN401 - inputs are of any type
        """Return an input; None where nobody has given it."""
        return self._given.get(name)

    def ask(self, function: Callable[Concatenate[Database, P], T], *arguments: P.args, **_: P.kwargs) -> T:
        """Return what a function gives for its arguments."""
        given: Any = arguments
        key = (function, *given)
        found = self._known.get(key, _MISSING)
        if found is _MISSING:
            called: Any = function
            found = self._known[key] = called(self, *arguments)
        value: T = found
        return value

    def known(
        self, function: Callable[Concatenate[Database, P], T], *arguments: P.args, **_: P.kwargs
    ) -> T | None:
        """Return an answer, without asking for it; None where nobody has."""
        given: Any = arguments
        value: T | None = self._known.get((function, *given))
        return value
