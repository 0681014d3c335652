"""Lines before which a text may be cut: no statement or block from above continues there.

A block that nothing closes ends where its lines stop being indented, or soon after where they are not, so
that an incomplete block does not take all lines below into its piece.
"""

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Sequence

from ropsim.core import frozen_dataclass
from ropsim.language.cutting.line_kinds import (
    BEGINS,
    CLOSES,
    DIVIDES,
    MARKED,
    OPENS,
    RUNS_ON,
    STATES,
    head_of,
    indent_of,
    those_with,
)
from ropsim.language.syntax.lines import MAX_JOINED
from ropsim.language.syntax.words import END, OPENERS

MOST_LINES = 256
"""Of a piece with a block without end, where some place in it is one to cut at."""
ENOUGH = 40
"""Lines of another piece, where some place in it is one to cut at: an edit costs the piece in which it is."""
REACH = 48
"""Least number of unindented lines of an unclosed block kept in one piece above a stray end."""

_NOTABLE = those_with(~BEGINS)
_STATING = those_with(STATES)
_OF_BLOCKS = those_with(OPENS | CLOSES)
_OPENING = those_with(OPENS)
_OPENED_BY = {word: opener for opener, words in OPENERS.items() for word in words}


def cuts(lines: Sequence[str], kinds: bytes, start: int, end: int) -> tuple[list[int], bool]:
    """Return before which lines to cut of those from `start` to `end`, and whether each block has both ends.

    Args:
        lines: of the text.
        kinds: kind of each line.
        start: first line, from 0.
        end: line behind the last one.
    """
    closed, strays = _matched(lines, kinds, start, end)
    found = _cuts(lines, kinds, start, end, closed)
    for stray in strays:
        above = _above(lines, kinds, start, stray)
        del found[bisect_right(found, above) : bisect_right(found, stray)]
    return found, not strays and len(_OPENING.findall(kinds, start, end)) == len(closed)


def has_blocks(kinds: bytes) -> bool:
    """Return whether one of some lines opens or closes a block."""
    return _OF_BLOCKS.search(kinds) is not None


def _matched(lines: Sequence[str], kinds: bytes, start: int, end: int) -> tuple[dict[int, int], list[int]]:
    """Return which line closes each one that opens a block, where one does, and lines that close nothing."""
    stack: list[tuple[str, int]] = []
    depths: dict[str, list[int]] = defaultdict(list)  # positions of each word in the stack, to avoid searches
    closed: dict[int, int] = {}
    strays: list[int] = []
    for match in _OF_BLOCKS.finditer(kinds, start, end):
        number = match.start()
        word = head_of(lines[number])
        if kinds[number] & OPENS:
            depths[word].append(len(stack))
            stack.append((word, number))
            continue
        depth = len(stack) - 1 if word == END else (depths[_OPENED_BY[word]] or [-1])[-1]
        if depth < 0:
            strays.append(number)
            continue
        closed[stack[depth][1]] = number
        for inner, _ in stack[depth:]:
            depths[inner].pop()
        del stack[depth:]
    return closed, strays


@frozen_dataclass
class _Unended:
    """A block without end, with the unclosed blocks around it.

    Attributes:
        indent: of the line furthest left that opens one.
        until: number of the first line that may be none of theirs where they are not indented.
        is_indented: whether their lines are indented relative to the opener.
    """

    indent: int
    until: int
    is_indented: bool

    def ends_before(self, line: str, number: int, kind: int, size: int) -> bool:
        """Return whether a line is none of theirs."""
        if not kind & BEGINS or kind & CLOSES or indent_of(line) > self.indent:
            return False
        return self.is_indented or (number >= self.until and _is_due(kind, size, MOST_LINES))


def _is_due(kind: int, size: int, most: int) -> bool:
    return bool(kind & MARKED) or size >= most


def _unended(lines: Sequence[str], number: int, around: _Unended | None) -> _Unended:
    indent = indent_of(lines[number])
    following = next(filter(str.strip, lines[number + 1 : number + REACH]), "")
    is_indented = indent_of(following) > indent
    if around is None:
        return _Unended(indent, number + REACH, is_indented)
    return _Unended(min(indent, around.indent), number + REACH, is_indented and around.is_indented)


def _cuts(lines: Sequence[str], kinds: bytes, start: int, end: int, closed: dict[int, int]) -> list[int]:
    found: list[int] = []
    size, closes_at = 0, -1
    goes_on = start + MAX_JOINED if start > 0 and lines[start - 1].endswith("\\") else 0
    in_contract = False
    unended: _Unended | None = None
    number = start - 1
    while number + 1 < end:
        number += 1
        if size < ENOUGH and unended is None and not in_contract and number >= goes_on:  # mostly
            most = min(number + ENOUGH, end)
            match = _NOTABLE.search(kinds, number, most)
            until = match.start() if match is not None else most
            begun = kinds.count(BEGINS, number, until)
            if size + begun <= ENOUGH:
                size += begun
                number = until
            if number == end:
                break
        kind = kinds[number]
        if not kind:
            continue
        if kind & BEGINS:
            goes_on = goes_on if lines[number - 1].endswith("\\") else 0
            in_contract = in_contract and head_of(lines[number]) == END
        is_free = size and number > closes_at and number >= goes_on and not in_contract and not kind & DIVIDES
        if is_free and (
            _is_due(kind, size, ENOUGH)
            if unended is None
            else unended.ends_before(lines[number], number, kind, size)
        ):
            found.append(number)
            size, unended = 0, None
        size += 1
        in_contract = in_contract or bool(kind & STATES)
        if kind & RUNS_ON:
            goes_on = number + MAX_JOINED
        if kind & OPENS and number not in closed:
            unended = _unended(lines, number, unended) if number > closes_at else unended
        elif kind & OPENS and _STATING.search(kinds, number, closed[number]):
            closes_at = max(closes_at, closed[number])
        elif kind & OPENS:  # no line of the block is one to cut at
            first, number = number + 1, closed[number]
            size += number + 1 - first - kinds.count(0, first, number + 1)
            goes_on = number + MAX_JOINED if kinds[number] & RUNS_ON else 0
    return found


def _above(lines: Sequence[str], kinds: bytes, start: int, stray: int) -> int:
    """Return the line that may be the intended opener of the block that a line closes, or one above it."""
    indent = indent_of(lines[stray])
    least = max(start, stray - MOST_LINES)
    above = (one for one in range(stray - 1, least - 1, -1) if lines[one].strip())
    is_first = True
    for one in above:
        if indent_of(lines[one]) <= indent and not kinds[one] & DIVIDES:
            return max(stray - REACH, start) if is_first else one
        is_first = False
    return max(stray - REACH, start)
