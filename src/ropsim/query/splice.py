"""Sequences of which an edit changes one range: unchanged items above, new ones between, unchanged below."""

from collections.abc import Callable, Sequence
from itertools import compress, count
from operator import ne
from typing import TypeVar

from ropsim.core import frozen_dataclass

T = TypeVar("T")


@frozen_dataclass
class Splice:
    """Number of items of a sequence that an edit leaves unchanged.

    Attributes:
        above: items at the begin.
        below: items at the end, none of them counted in `above`.
    """

    above: int
    below: int

    def known_above(self, known: Sequence[T]) -> Sequence[T]:
        """Return the values of the unchanged items at the begin."""
        return known[: self.above]

    def known_below(self, known: Sequence[T]) -> Sequence[T]:
        """Return the values of the unchanged items at the end."""
        return known[len(known) - self.below :]

    def between(self, items: Sequence[T]) -> Sequence[T]:
        """Return the changed items of the sequence before or after the edit."""
        return items[self.above : len(items) - self.below]

    def spliced(self, known: Sequence[T], made: Sequence[T]) -> list[T]:
        """Return the values of all items: known ones of unchanged items, made ones of the others."""
        return [*self.known_above(known), *made, *self.known_below(known)]


NOTHING_UNCHANGED = Splice(0, 0)


def splice(before: Sequence[T], now: Sequence[T], differ: Callable[[T, T], object] = ne) -> Splice:
    """Return how much of a sequence an edit leaves unchanged.

    Args:
        before: the items before the edit.
        now: the items after it.
        differ: whether two items count as different.
    """
    least = min(len(before), len(now))
    above = next(compress(count(), map(differ, before, now)), least)
    below = next(compress(count(), map(differ, reversed(before), reversed(now))), least)
    return Splice(above, min(below, least - above))
