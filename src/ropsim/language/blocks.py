"""Matches the openers and closers of blocks; every mismatch stays a finding of its own place."""

import re
from collections.abc import Iterable
from dataclasses import dataclass, field

from ropsim.language.findings import syntax as kinds
from ropsim.language.report import Report
from ropsim.language.syntax.statements import (
    Broken,
    Closer,
    Else,
    ElseIf,
    For,
    ForEach,
    If,
    Repeat,
    TaskHeader,
    Until,
    While,
    With,
)
from ropsim.language.syntax.words import OPENERS
from ropsim.language.text import Line

MAX_DEPTH = 32

_CLOSES: dict[str, str] = {word: opener for opener, words in OPENERS.items() for word in words}
_MIDDLE = {"else": ("if", "try"), "elseif": ("if",), "catch": ("try",)}
_ONE_LINE_IF = re.compile(r"\bthen\s+[^\s#/]", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Section:
    """A header line (opener, `elseif` or `else`) and what stands under it."""

    header: Line
    body: "tuple[Line | Block, ...]"


@dataclass(frozen=True, slots=True)
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

    def next_section(self, header: Line) -> None:
        self.done.append(Section(self.header, tuple(self.body)))
        self.header = header
        self.body = []

    def close(self, closer: Line | None) -> Block:
        return Block((*self.done, Section(self.header, tuple(self.body))), closer)


@dataclass(frozen=True, slots=True)
class Tree:
    """Top-level lines and blocks in order.

    Attributes:
        items: lines and blocks.
        cut: openers that were reported as not closed; their closers, also further on, are not reported.
    """

    items: tuple[Line | Block, ...]
    cut: tuple[str, ...] = ()


def build(lines: Iterable[Line], report: Report, cut: tuple[str, ...] = ()) -> Tree:
    """Return the tree of a text, or of a part of one before which `cut` was reported."""
    top = _Open("", Line.empty(), cut=list(cut))
    stack = [top]
    for line in lines:
        opener = opened(line)
        closes = closed(line)
        if opener == "task":
            _close_down_to(stack, 1, report)
        if opener:
            _open(stack, opener, line, report)
        elif closes:
            _close(stack, closes, line, report)
        elif _middle(line):
            _next_section(stack, line, report)
        else:
            stack[-1].body.append(line)
    _close_down_to(stack, 1, report)
    return Tree(tuple(top.body), tuple(top.cut))


def _open(stack: list[_Open], word: str, line: Line, report: Report) -> None:
    if len(stack) == MAX_DEPTH + 1:
        message = f"blocks nest deeper than {MAX_DEPTH}"
        report.line(kinds.DEPTH, line, message, "move the inner blocks into a task")
    stack.append(_Open(word, line))


def _close(stack: list[_Open], word: str, line: Line, report: Report) -> None:
    for depth in range(len(stack) - 1, 0, -1):
        if stack[depth].word == word:
            _close_down_to(stack, depth + 1, report)
            _pop(stack, line)
            return
    if word in stack[-1].cut:  # its opener was reported as not closed when an outer block ended
        stack[-1].cut.remove(word)
        return
    head = line.head
    report.line(
        kinds.UNOPENED,
        line,
        f"`{head}` closes nothing: no `{word}` is open here",
        f"remove it, or write the `{word}`",
    )


def _next_section(stack: list[_Open], line: Line, report: Report) -> None:
    allowed = _MIDDLE[line.head]
    for depth in range(len(stack) - 1, 0, -1):
        if stack[depth].word in allowed:
            _close_down_to(stack, depth + 1, report)
            stack[depth].next_section(line)
            return
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
        opener = frame.done[0].header if frame.done else frame.header
        closers = " or ".join(f"`{word}`" for word in OPENERS[frame.word])
        if not isinstance(opener.statement, Broken):  # that line has its own finding
            report.line(kinds.UNCLOSED, opener, f"`{frame.word}` is not closed", f"add {closers}")
        cut.append(frame.word)
        _pop(stack, None)
    stack[-1].cut.extend(word for word in cut if word != "task")
    if depth > 1 and cut:
        stack[-2].cut.extend(cut)


def _pop(stack: list[_Open], closer: Line | None) -> None:
    block = stack.pop().close(closer)
    if len(stack) <= MAX_DEPTH:  # what lies deeper was reported where it begins
        stack[-1].body.append(block)


def opened(line: Line) -> str:
    """Return the word of the block that a line opens, empty for none."""
    match line.statement:
        case TaskHeader():
            return "task"
        case Repeat():
            return "repeat"
        case If(body=None):
            return "if"
        case While():
            return "while"
        case For() | ForEach():
            return "for"
        case With():
            return "with"
        case Broken(head=head) if head in OPENERS:
            return "" if head == "if" and _ONE_LINE_IF.search(line.logical.text) else head
    return ""


def closed(line: Line) -> str:
    """Return the opener of the block that a line closes, empty for none."""
    match line.statement:
        case Closer(word=word):
            return _CLOSES[word]
        case Until():
            return "repeat"
        case Broken(head=head):
            return _CLOSES.get(head, "")
    return ""


def _middle(line: Line) -> bool:
    match line.statement:
        case Else() | ElseIf():
            return True
        case Broken(head=head):
            return head in _MIDDLE
    return False
