"""A text in chunks, which is cut again around an edit and unchanged elsewhere."""

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import accumulate, chain

from ropsim.core import EditedLines, edited_lines
from ropsim.language.cutting.chunks import Bounds, Chunk, TextSection, bounds, chunks_at, section_of
from ropsim.language.cutting.cuts import REACH, cuts, has_blocks
from ropsim.language.cutting.line_kinds import kinds_of
from ropsim.query import NOTHING_UNCHANGED, Splice, splice

FURTHER = 8
"""Within this number of pieces below an edit one must begin at an old begin, else all are cut again."""


@dataclass(slots=True)
class Cut:
    """A text in chunks.

    Attributes:
        text: its characters; lines end with a line feed alone.
        lines: of the text; unchanged lines are the same objects.
        kinds: kind of each line.
        sections: of the text.
        starts: first line of each section, from 0.
        sizes: number of chunks of each section.
        chunks: of the text.
        unchanged: how many of them are lines of the text before.
    """

    text: str = ""
    lines: list[str] = field(default_factory=list)
    kinds: bytes = b""
    sections: list[TextSection] = field(default_factory=list)
    starts: list[int] = field(default_factory=list)
    sizes: list[int] = field(default_factory=list)
    chunks: list[Chunk] = field(default_factory=list)
    unchanged: Splice = NOTHING_UNCHANGED


def recut(text: str, before: Cut) -> Cut:
    """Return a text in chunks.

    Args:
        text: its lines end with a line feed alone.
        before: the text before the edit, or an empty one; it saves time and changes no chunk.
    """
    if not before.lines:
        return _cut(text)
    known = before.lines
    edit = edited_lines(before.text, text)
    end = len(known) - edit.below
    lines = [*known[: edit.above], *edit.between, *known[end:]]
    kinds = before.kinds[: edit.above] + kinds_of(edit.between) + before.kinds[end:]
    here, shift = edit.above + len(edit.between), len(lines) - len(known)
    kept, until = _kept_above(before.starts, edit.above), len(before.starts)
    start, in_task = (before.starts[kept], before.sections[kept].in_task) if kept else (0, False)
    found: list[Bounds] = []
    for one in bounds(lines, kinds, start, in_task=in_task):
        place = _place(before.starts, one.start - shift) if one.start > here else None
        if place is not None:  # the line before it and all below are unchanged
            until = place
            break
        found.append(one)
    made = [_again(one, lines, kinds, before, edit) or section_of(lines, kinds, one) for one in found]
    below = before.starts[until:]
    first = sum(before.sizes[:kept])
    gone = before.chunks[first : first + sum(before.sizes[kept:until])]
    new = [*chain.from_iterable(one.chunks for one in made)]
    again = splice(gone, new, _differ)
    return Cut(
        text,
        lines,
        kinds,
        [*before.sections[:kept], *made, *before.sections[until:]],
        [
            *before.starts[:kept],
            *(one.start for one in found),
            *(map(shift.__add__, below) if shift else below),
        ],
        [*before.sizes[:kept], *(len(one.chunks) for one in made), *before.sizes[until:]],
        [*before.chunks[:first], *new, *before.chunks[first + len(gone) :]],
        Splice(first + again.above, len(before.chunks) - first - len(gone) + again.below),
    )


def _cut(text: str) -> Cut:
    lines = text.split("\n")
    kinds = kinds_of(lines)
    found = [*bounds(lines, kinds)]
    made = [section_of(lines, kinds, one) for one in found]
    starts, sizes = [one.start for one in found], [len(one.chunks) for one in made]
    return Cut(text, lines, kinds, made, starts, sizes, [*chain.from_iterable(one.chunks for one in made)])


def _again(
    one: Bounds, lines: Sequence[str], kinds: bytes, before: Cut, edit: EditedLines
) -> TextSection | None:
    """Return a section whose chunks are known except around an edit; None if all may have changed.

    Where a piece ends depends on the lines up to there, from the end of the piece above on, as long as each
    block has both of its ends and no line that has changed begins or ends one.
    """
    place = _place(before.starts, one.start)
    end = len(before.lines) - edit.below
    shift = len(lines) - len(before.lines)
    if place is None or not before.sections[place].is_plain or one.in_task or one.start > edit.above:
        return None
    known = before.sections[place].chunks
    firsts = [*accumulate((len(chunk.lines) for chunk in known), initial=one.start)]
    if firsts[-1] + shift != one.end or firsts[-1] < end:
        return None
    if has_blocks(before.kinds[edit.above : end]) or has_blocks(kinds[edit.above : end + shift]):
        return None
    first = max(bisect_left(firsts, edit.above) - 1, 0)
    last = bisect_right(firsts, end)
    if first and lines[firsts[first] - 1].endswith("\\"):
        return None
    until = min(last + FURTHER, len(known))
    found, is_plain = cuts(lines, kinds, firsts[first], firsts[until] + shift)
    starts = {*found}
    kept = next((k for k in range(last, until) if firsts[k] + shift in starts), until)
    if not is_plain or kept == until < len(known):
        return None
    again = firsts[kept] + shift
    borders = (firsts[first], *(start for start in found if start < again), again)
    return TextSection(
        one.in_task, (*known[:first], *chunks_at(lines, borders, one.end), *known[kept:]), is_plain=True
    )


def _place(numbers: Sequence[int], number: int) -> int | None:
    """Return where a number stands among numbers in order, None where it does not."""
    place = bisect_left(numbers, number)
    return place if place < len(numbers) and numbers[place] == number else None


def _kept_above(starts: Sequence[int], above: int) -> int:
    """Return how many sections remain, as they lie far enough within the lines that remain.

    Where a section ends depends on the line behind it, and for a block without end on a few more lines.
    """
    return max(bisect_right(starts, above - REACH) - 1, 0)


def _differ(one: Chunk, other: Chunk) -> bool:
    return one is not other and one != other
