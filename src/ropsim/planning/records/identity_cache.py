"""What is found once for an object and known again by which object it is."""

from collections.abc import Callable
from typing import Generic, TypeVar

K = TypeVar("K")
V = TypeVar("V")

MOST = 256
"""So many objects are known at once; they are few, such as the modal states of a program in a loop."""


class IdentityCache(Generic[K, V]):
    """A function of objects that nobody can change, of which the same ones are asked for again and again.

    To compare them by content takes longer than what is found; those that are known are kept alive.

    Args:
        find: the function.
    """

    def __init__(self, find: Callable[[K], V]) -> None:
        self._find = find
        self._known: dict[int, tuple[K, V]] = {}

    def __call__(self, key: K) -> V:
        """Return what is found for an object."""
        known = self._known.get(id(key))
        if known is not None:
            return known[1]
        if len(self._known) >= MOST:
            self._known.clear()
        found = self._find(key)
        self._known[id(key)] = key, found
        return found
