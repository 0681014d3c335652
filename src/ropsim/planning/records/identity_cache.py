"""Cache of results by object identity."""

from collections.abc import Callable
from typing import Generic, TypeVar

K = TypeVar("K")
V = TypeVar("V")

MOST = 256
"""Capacity of the cache; objects are few, such as the modal states of a program in a loop."""


class IdentityCache(Generic[K, V]):
    """A function of objects immutable objects, called repeatedly with the same ones.

    Comparing them by content takes longer than computing the result; cached objects are kept alive.

    Args:
        find: the function.
    """

    def __init__(self, find: Callable[[K], V]) -> None:
        self._find = find
        self._known: dict[int, tuple[K, V]] = {}

    def __call__(self, key: K) -> V:
        """Return the result for an object."""
        known = self._known.get(id(key))
        if known is not None:
            return known[1]
        if len(self._known) >= MOST:
            self._known.clear()
        found = self._find(key)
        self._known[id(key)] = key, found
        return found
