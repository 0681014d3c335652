"""A table of names that records look-ups, so that only these become dependencies."""

from collections.abc import Callable, Container, Iterable, Iterator, Mapping
from typing import Any, TypeVar

T = TypeVar("T")


class Table(Mapping[str, T]):
    """Names and their meanings.

    Args:
        entry: returns the meaning of a name, None for none; called once for each name.
        names: returns all names, in order; called when the table is iterated.
    """

    __slots__ = ("_entry", "_found", "_names")

    def __init__(self, entry: Callable[[str], T | None], names: Callable[[], Iterable[str]]) -> None:
        self._entry = entry
        self._names = names
        self._found: dict[str, T | None] = {}

    def __getitem__(self, name: str) -> T:
        found = self._look_up(name)
        if found is None:
            raise KeyError(name)
        return found

    def get(self, name: str, default: Any = None, /) -> Any:  # noqa: ANN401 - as of any mapping
        """Return the meaning of a name; without exceptions, since most names have none here."""
        found = self._look_up(name)
        return default if found is None else found

    def __contains__(self, name: object) -> bool:
        return self._look_up(str(name)) is not None

    def __iter__(self) -> Iterator[str]:
        return (name for name in self._names() if name in self)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def _look_up(self, name: str) -> T | None:
        if name not in self._found:
            self._found[name] = self._entry(name)
        return self._found[name]


class Marked(Container[str]):
    """A set of names with a property; `holds` is called for each name."""

    __slots__ = ("_holds",)

    def __init__(self, holds: Callable[[str], bool]) -> None:
        self._holds = holds

    def __contains__(self, name: object) -> bool:
        return self._holds(str(name))
