"""Results that are kept from run to run by their inputs, within a memory limit."""

from collections import Counter
from collections.abc import Hashable
from dataclasses import dataclass
from typing import Generic, TypeVar

V = TypeVar("V")


@dataclass(slots=True)
class _Entry(Generic[V]):
    """A result, its memory [bytes], and the newest run that has requested it."""

    value: V
    size: int
    run: int


_RUNS = 4
"""A result is removed after this number of runs without a request, so results do not pile up."""


class KeptResults(Generic[V]):
    """Results by their keys.

    Beyond the limit, results are removed that neither this run nor the one before has requested.

    Args:
        most: room [bytes].
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._free = most
        self._run = 0
        self._dropped = 0
        self._entries: dict[Hashable, _Entry[V]] = {}
        self._of_run = Counter[int]()  # number of entries last requested by each run

    @property
    def used(self) -> int:
        """Return how much room is taken, about [bytes]."""
        return self._most - self._free

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
            key: its inputs.
            value: the result.
            size: how much room it takes [bytes].
        """
        before = self._entries.pop(key, None)
        if before is not None:
            self._free += before.size
            self._of_run[before.run] -= 1
        if size > self._free and self._dropped < self._run:  # once: in a run nothing becomes older
            self._drop(self._run - 1)
            self._dropped = self._run
        if size <= self._free:
            self._entries[key] = _Entry(value, size, self._run)
            self._of_run[self._run] += 1
            self._free -= size

    def _drop(self, since: int) -> None:
        """Forget results that no run from one on has requested."""
        older = [run for run in self._of_run if run < since]
        if not sum(self._of_run.pop(run) for run in older):
            return
        self._entries = {key: one for key, one in self._entries.items() if one.run >= since}
        self._free = self._most - sum(one.size for one in self._entries.values())
