"""Results that are kept from run to run by what they are the results of, within a room."""

from collections import Counter
from collections.abc import Hashable
from dataclasses import dataclass
from typing import Generic, TypeVar

V = TypeVar("V")


@dataclass(slots=True)
class _Entry(Generic[V]):
    """A result, how much room it takes [bytes], and the newest run that has asked for it."""

    value: V
    size: int
    run: int


_RUNS = 4
"""A result goes that as many runs have not asked for: so what is kept does not grow from edit to edit."""


class KeptResults(Generic[V]):
    """Results by their keys.

    When there is no room, those go that neither this run nor the one before it has asked for.

    Args:
        most: room [bytes].
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._room = most
        self._run = 0
        self._dropped = 0
        self._entries: dict[Hashable, _Entry[V]] = {}
        self._of_run = Counter[int]()  # how many entries each run has asked for last

    @property
    def used(self) -> int:
        """Return how much room is taken, about [bytes]."""
        return self._most - self._room

    def begin(self) -> None:
        """Take notice that another run begins."""
        self._run += 1
        self._drop(self._run - _RUNS)

    def get(self, key: Hashable) -> V | None:
        """Return the result of a key, None where there is none."""
        entry = self._entries.get(key)
        if entry is None:
            return None
        if entry.run != self._run:
            self._of_run[entry.run] -= 1
            self._of_run[self._run] += 1
            entry.run = self._run
        return entry.value

    def put(self, key: Hashable, value: V, size: int) -> None:
        """Keep a result, instead of another one with its key, where there is room.

        Args:
            key: what it is the result of.
            value: the result.
            size: how much room it takes [bytes].
        """
        before = self._entries.pop(key, None)
        if before is not None:
            self._room += before.size
            self._of_run[before.run] -= 1
        if size > self._room and self._dropped < self._run:  # once: in a run nothing becomes older
            self._drop(self._run - 1)
            self._dropped = self._run
        if size <= self._room:
            self._entries[key] = _Entry(value, size, self._run)
            self._of_run[self._run] += 1
            self._room -= size

    def _drop(self, since: int) -> None:
        """Forget what no run from one on has asked for."""
        older = [run for run in self._of_run if run < since]
        if not sum(self._of_run.pop(run) for run in older):
            return
        self._entries = {key: one for key, one in self._entries.items() if one.run >= since}
        self._room = self._most - sum(one.size for one in self._entries.values())
