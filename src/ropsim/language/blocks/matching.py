"""Matches the openers and closers of blocks; every mismatch stays a finding of its own place."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from ropsim.core import Label, Span, frozen_dataclass
from ropsim.language.blocks.block_ends import ANY, STEERING, closed, middle, opened
from ropsim.language.blocks.then_bodies import begins_block
from ropsim.language.findings import syntax as kinds
from ropsim.language.report import Report
from ropsim.language.syntax.statements import DECLARATIONS, Broken, If
from ropsim.language.syntax.text import Line
from ropsim.language.syntax.words import END, OPENERS

MAX_DEPTH = 32
_LOOPS = frozenset(("repeat", "while", "for"))


@frozen_dataclass
class Section:
    """A header line (opener, `elseif` or `else`) and the statements under it."""

    header: Line
    body: "tuple[Line | Block, ...]"


@frozen_dataclass
class Block:
    """A block with its sections and the line that closes it (None where it is missing)."""

    sections: tuple[Section, ...]
    closer: Line | None

    @property
    def opener(self) -> Line:
        """Return the line that opens the block."""
        return self.sections[0].header


@dataclass(slots=True)
class _Open:
    word: str
    header: Line
    done: list[Section] = field(default_factory=list)
    body: list[Line | Block] = field(default_factory=list)
    cut: list[str] = field(default_factory=list)
    looked_at: bool = False
    """Whether the statements cut off in it were read."""
    ended: list[tuple[Line, Line]] = field(default_factory=list)
    """Openers of the blocks inside that an `end` has closed, each with the line of that `end`."""

    @property
    def opener(self) -> Line:
        return self.done[0].header if self.done else self.header

    def next_section(self, header: Line) -> None:
        self.done.append(Section(self.header, tuple(self.body)))
        self.header = header
        self.body = []

    def close(self, closer: Line | None) -> Block:
        return Block((*self.done, Section(self.header, tuple(self.body))), closer)


@frozen_dataclass
class Tree:
    """Top-level lines and blocks in order.

    Attributes:
        items: lines and blocks.
        cut: openers that were reported as not closed; their closers, also further on, are not reported.
        looked_above: whether statements cut off above may have effects.
    """

    items: tuple[Line | Block, ...]
    cut: tuple[str, ...] = ()
    looked_above: bool = False


def build(lines: Iterable[Line], report: Report, cut: tuple[str, ...] = ()) -> Tree:
    """Return the tree of a text, or of a part of one before which `cut` was reported."""
    top = _Open("", Line.empty(), cut=list(cut))
    stack = [top]
    for line, following in pairwise((*lines, Line.empty())):
        if type(line.statement) not in STEERING:
            stack[-1].body.append(line)
            continue
        opener = opened(line)
        if line.fault is not None and _is_one_line(line):
            if begins_block(line) or _goes_on(line, following):
                opener = "if"
            else:
                stack[-1].cut.append("if")  # an `endif` shows that the block was meant
        closes = closed(line)
        if opener == "task":
            _close_down_to(stack, 1, report)
        if opener:
            _open(stack, opener, line, report)
        elif closes:
            _close(stack, closes, line, report)
        elif middle(line):
            _next_section(stack, line, report)
        else:
            stack[-1].body.append(line)
    _close_down_to(stack, 1, report)
    return Tree(tuple(top.body), tuple(top.cut), top.looked_at)


def _open(stack: list[_Open], word: str, line: Line, report: Report) -> None:
    if len(stack) == MAX_DEPTH + 1:
        message = f"blocks nest deeper than {MAX_DEPTH}"
        report.line(kinds.DEPTH, line, message, "move the inner blocks into a task")
    stack.append(_Open(word, line))


def _close(stack: list[_Open], word: str, line: Line, report: Report) -> None:
    _close_doubtful(stack, word, line, report)
    if word == ANY and len(stack) > 1:
        opener = stack[-1].opener
        _pop(stack, line)
        stack[-1].ended.append((opener, line))
        return
    for depth in range(len(stack) - 1, 0, -1):
        if stack[depth].word == word:
            _close_down_to(stack, depth + 1, report)
            _pop(stack, line)
            return
    if _is_doubtful(stack[-1]) and {word, stack[-1].word} <= _LOOPS:  # which loop it is, is its finding
        _pop(stack, line)
        return
    stack[-1].looked_at = True
    cut = stack[-1].cut
    if cut and word in (ANY, *cut):  # its opener was reported as not closed when an outer block ended
        cut.remove(cut[-1] if word == ANY else word)
        return
    if line.fault is not None:  # that line has its own finding
        return
    what = "block" if word == ANY else f"`{word}`"
    message = f"`{line.head}` closes nothing: no {what} is open here"
    hint = "remove it" if word == ANY else f"remove it, or write the `{word}`"
    taken = [pair for pair in stack[-1].ended if word in (ANY, opened(pair[0]))]
    place = _span(report, line)
    report.add(kinds.UNOPENED.at(place, message, hint=hint, secondary=_ended_early(report, taken[-1:])))


def _close_doubtful(stack: list[_Open], word: str, line: Line, report: Report) -> None:
    """Close blocks of wrong openers that stand further right than an end of a block further out."""
    ends = [depth for depth in range(1, len(stack)) if word in (ANY, stack[depth].word)]
    while len(ends) > 1 and _is_doubtful(stack[ends[-1]]) and line.indent < stack[ends[-1]].opener.indent:
        _close_down_to(stack, ends.pop(), report)


def _is_doubtful(frame: _Open) -> bool:
    return frame.opener.fault is not None


def _next_section(stack: list[_Open], line: Line, report: Report) -> None:
    allowed = middle(line)
    for depth in range(len(stack) - 1, 0, -1):
        if stack[depth].word in allowed:
            _close_down_to(stack, depth + 1, report)
            stack[depth].next_section(line)
            return
    stack[-1].looked_at = True
    if any(word in stack[-1].cut for word in allowed):
        return
    report.line(
        kinds.UNOPENED,
        line,
        f"`{line.head}` without an open `{allowed[0]}`",
        f"write the `{allowed[0]}` before it",
    )


def _close_down_to(stack: list[_Open], depth: int, report: Report) -> None:
    """Close all blocks above `depth` by force, with a finding at each opener."""
    cut: list[str] = []
    while len(stack) > depth:
        frame = stack[-1]
        if not _is_doubtful(frame):  # that line has its own finding
            _unclosed(frame, report)
        cut.append(frame.word)
        _pop(stack, None)
    stack[-1].cut.extend(word for word in cut if word != "task")
    if depth > 1 and cut:
        stack[-2].cut.extend(cut)


def _unclosed(frame: _Open, report: Report) -> None:
    """Report a block without end; an `end` that stands as far left as its opener was meant for it."""
    closers = ", ".join(f"`{word}`" for word in OPENERS[frame.word]) + f" or `{END}`"
    meant = [pair for pair in frame.ended if pair[1].indent <= frame.opener.indent < pair[0].indent]
    place = _span(report, frame.opener)
    labels = _ended_early(report, (meant or frame.ended)[-1:])
    message = f"`{frame.word}` is not closed"
    report.add(kinds.UNCLOSED.at(place, message, hint=f"add {closers}", secondary=labels))


def _ended_early(report: Report, pairs: Iterable[tuple[Line, Line]]) -> tuple[Label, ...]:
    """Return which block an `end` has closed, as a label at that line."""
    return tuple(
        label
        for opener, line in pairs
        for label in (
            Label(_span(report, line), f"closes the `{opener.head}`"),
            Label(_span(report, opener), "which begins here"),
        )
    )


def _span(report: Report, line: Line) -> Span:
    return line.logical.span(report.source, line.start, line.end)


def _pop(stack: list[_Open], closer: Line | None) -> None:
    frame = stack.pop()
    behind: list[Line | Block] = []
    if closer is None and frame.word != "task":
        firsts = [one if isinstance(one, Line) else one.opener for one in frame.body]
        size = reach(frame.header, firsts)
        frame.body, behind = frame.body[:size], frame.body[size:]
    if len(stack) <= MAX_DEPTH:  # a deeper block was reported at its start
        stack[-1].body += [frame.close(closer), *behind]


def _is_one_line(line: Line) -> bool:
    return isinstance(line.statement, If) and line.statement.body is not None


def _goes_on(line: Line, following: Line) -> bool:
    """Return whether a block was meant though a statement stands on the line of its condition."""
    shift = following.indent - line.indent
    return following.statement is not None and (shift > 0 or (shift == 0 and "if" in middle(following)))


_DECLARING = frozenset({"frame", "loc", "tool", "signal", "const", "pattern", "units", "program"})
"""First words of declarations that stand outside of all blocks, also where the rest is wrong."""


def reach(opener: Line, firsts: Sequence[Line]) -> int:
    """Return how many lines and blocks of those below an opener are in its block, which nothing closes.

    Where lines are indented, the block ends before the first that is not, and always before a declaration,
    which stands in no block.

    Args:
        opener: the line that opens it.
        firsts: the first line of each line or block up to where the block around it ends.
    """
    left = opener.indent
    is_indented = bool(firsts) and firsts[0].indent > left
    for number, line in enumerate(firsts):
        if (is_indented and line.indent <= left) or _declares(line):
            return number
    return len(firsts)


def _declares(line: Line) -> bool:
    statement = line.statement
    if isinstance(statement, Broken):
        return statement.head in _DECLARING
    return isinstance(statement, DECLARATIONS) and line.head != "var"
