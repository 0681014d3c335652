"""A table of names of which is noted what is looked up, so that only that is depended on."""

from collections.abc import Callable, Container, Iterable, Iterator, Mapping
from typing import Any, TypeVar

T = TypeVar("T")


class Table(Mapping[str, T]):
    """Names and what they mean.

    Args:
        entry: what a name means, None for nothing; asked once for each name.
        names: all names, in order; asked where somebody goes through them.
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
        """Return what a name means; raising and catching nothing, as most names mean nothing here."""
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
    """Names of which something holds; `holds` is asked for each."""

    __slots__ = ("_holds",)

    def __init__(self, holds: Callable[[str], bool]) -> None:
        self._holds = holds

    def __contains__(self, name: object) -> bool:
        return self._holds(str(name))
