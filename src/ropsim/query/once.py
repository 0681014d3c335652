"""The same questions where inputs never change: answers are kept, and nothing else."""

from collections import defaultdict
from collections.abc import Callable, Hashable, Mapping
from typing import Any, Concatenate, ParamSpec, TypeVar

from ropsim.query.database import Database

P = ParamSpec("P")
T = TypeVar("T")

_MISSING = object()


class Once(Database):
    """A database for one state of the inputs: all are set before the first request."""

    def __init__(self) -> None:
        super().__init__()
        self._given: dict[Hashable, object] = {}
        self._known: defaultdict[Callable[..., object], dict[tuple[Hashable, ...], Any]] = defaultdict(dict)

    def __len__(self) -> int:
        """Return how many answers are kept."""
        return sum(map(len, self._known.values()))

    def give(self, values: Mapping[Hashable, object]) -> None:
        """Set inputs."""
        self._given.update(values)

    def read(self, name: Hashable) -> Any:  # noqa: ANN401 - inputs are of any type
        """Return an input; None if it was never set."""
        return self._given.get(name)

    def ask(self, function: Callable[Concatenate[Database, P], T], *arguments: P.args, **_: P.kwargs) -> T:
        """Return the value of a function for its arguments."""
        known = self._known[function]
        given: Any = arguments
        found = known.get(given, _MISSING)
        if found is _MISSING:
            called: Any = function
            found = known[given] = called(self, *arguments)
        value: T = found
        return value

    def known(
        self, function: Callable[Concatenate[Database, P], T], *arguments: P.args, **_: P.kwargs
    ) -> T | None:
        """Return a kept answer without computing one; None if there is none."""
        given: Any = arguments
        value: T | None = self._known[function].get(given)
        return value
