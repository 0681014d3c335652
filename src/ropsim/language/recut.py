"""A text in chunks, which is cut anew around what has changed and remains what it was elsewhere."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import chain, compress, count
from operator import ne

from ropsim.language.chunks import Chunk, Stretch, stretches
from ropsim.language.cuts import REACH
from ropsim.language.line_kinds import kinds_of


@dataclass(slots=True)
class Cut:
    """A text in chunks.

    Attributes:
        lines: of the text; those that stood in the text before are the same objects.
        kinds: what each line means.
        stretches: of the text.
    """

    lines: list[str] = field(default_factory=list)
    kinds: bytes = b""
    stretches: list[Stretch] = field(default_factory=list)

    def chunks(self) -> list[Chunk]:
        """Return all chunks."""
        return [*chain.from_iterable(one.chunks for one in self.stretches)]


def recut(lines: Sequence[str], before: Cut) -> Cut:
    """Return a text in chunks.

    Args:
        lines: of the text.
        before: the text as it was before, or an empty one; it saves time and changes no chunk.
    """
    known = before.lines
    above, below = ends_alike(lines, known)
    here = len(lines) - below
    now = [*known[:above], *lines[above:here], *known[len(known) - below :]]
    kinds = before.kinds[:above] + kinds_of(now[above:here]) + before.kinds[len(known) - below :]
    kept = _kept_above(before.stretches, above)
    found = before.stretches[:kept]
    start, in_task = (before.stretches[kept].start, before.stretches[kept].in_task) if kept else (0, False)
    shift = len(now) - len(known)
    places = {one.start + shift: k for k, one in enumerate(before.stretches) if one.start + shift > here}
    for one in stretches(now, kinds, start, in_task=in_task):
        if one.start in places:  # the line before it and all below are what they were
            found += (_moved(old, shift) for old in before.stretches[places[one.start] :])
            break
        found.append(one)
    return Cut(now, kinds, found)


def ends_alike(one: Sequence[object], other: Sequence[object]) -> tuple[int, int]:
    """Return with how many equal items two rows begin, and with how many further ones they end."""
    least = min(len(one), len(other))
    above = next(compress(count(), map(ne, one, other)), least)
    below = next(compress(count(), map(ne, reversed(one), reversed(other))), least)
    return above, min(below, least - above)


def _kept_above(found: Sequence[Stretch], above: int) -> int:
    """Return how many stretches remain, as they lie far enough within the lines that remain.

    Where a stretch ends is told by the line behind it, and a block without end looks a few lines further.
    """
    return max(sum(one.start + REACH <= above for one in found) - 1, 0)


def _moved(one: Stretch, by: int) -> Stretch:
    return Stretch(one.start + by, one.in_task, tuple(_moved_chunks(one.chunks, by))) if by else one


def _moved_chunks(chunks: Sequence[Chunk], by: int) -> Iterator[Chunk]:
    return (Chunk(one.lines, one.first + by, one.ends_part) for one in chunks)
