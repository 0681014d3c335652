"""Blocks: the words of a line that open, close or divide one, and the depth of each line."""

import re
from collections.abc import Iterable, Iterator

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
from ropsim.language.syntax.text import Line
from ropsim.language.syntax.words import END, OPENERS

ANY = "block"
"""`end` closes the innermost block of any kind."""

_CLOSES: dict[str, str] = {word: opener for opener, words in OPENERS.items() for word in words}
_OPENS: dict[type, str] = {
    TaskHeader: "task",
    Repeat: "repeat",
    If: "if",
    While: "while",
    For: "for",
    ForEach: "for",
    With: "with",
}
STEERING = frozenset({*_OPENS, Broken, Closer, Until, Else, ElseIf})
"""Statements that may open, close or divide a block."""
DIVIDERS = {"else": ("if", "try"), "elseif": ("if",), "catch": ("try",)}
"""Openers of the blocks that a word may divide."""
_ASSIGNED = re.compile(r"\s*\w+\s*:?=")
_ONE_LINE_IF = re.compile(r"\bthen\s+[^\s#/]", re.IGNORECASE)


def opened(line: Line) -> str:
    """Return the word of the block that a line opens, empty for none."""
    statement = line.statement
    word = _OPENS.get(type(statement), "")
    if isinstance(statement, If):
        return word if statement.body is None else ""
    if isinstance(statement, Broken) and statement.head in OPENERS:
        head = statement.head
        return "" if head == "if" and _ONE_LINE_IF.search(line.logical.text) else head
    return word


def closed(line: Line) -> str:
    """Return the opener of the block that a line closes, `ANY` for `end`, empty for none."""
    match line.statement:
        case Closer(word=word):
            return ANY if word == END else _CLOSES[word]
        case Until():
            return "repeat"
        case Broken(head=head):
            is_end = head == END and not _ASSIGNED.match(line.logical.text)
            return ANY if is_end else _CLOSES.get(head, "")
    return ""


def middle(line: Line) -> tuple[str, ...]:
    """Return the openers of the blocks that a line may divide, as `else` does; empty for none."""
    match line.statement:
        case Else() | ElseIf() | Broken():
            return DIVIDERS.get(line.head, ())
    return ()


def indented(lines: Iterable[Line]) -> Iterator[tuple[Line, int]]:
    """Yield each line with the number of blocks in which it stands; openers and closers stand outside."""
    stack: list[str] = []
    for line in lines:
        opener, closer = opened(line), closed(line)
        if opener == "task":
            stack.clear()
        if opener:
            yield line, len(stack)
            stack.append(opener)
            continue
        if closer == ANY and stack:
            stack.pop()
        elif closer in stack:
            del stack[_last(stack, closer) :]
        elif openers := [word for word in middle(line) if word in stack]:
            del stack[max(_last(stack, word) for word in openers) + 1 :]
            yield line, len(stack) - 1
            continue
        yield line, len(stack)


def _last(stack: list[str], word: str) -> int:
    return len(stack) - 1 - stack[::-1].index(word)
