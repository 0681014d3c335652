"""Where a statement behind a condition without `then` belongs: on the line, or with those below it."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

from ropsim.language.blocks.block_ends import ANY, closed, middle, opened
from ropsim.language.syntax.statements import If
from ropsim.language.syntax.text import Line

_MISSING = "then "
"""How the fix of a line without it begins."""
_BLOCK = "then\n"
"""Start of the fix if lines below belong to the condition."""
_BELOW = "write `then`, and `{0} …` on a line of its own"
_UNSURE = (
    "`then` stands behind the condition; where lines below belong to it, each statement has its own line, "
    "then `endif`"
)


@dataclass(slots=True)
class _Open:
    """A block, or a line that may be one.

    Attributes:
        word: that opens it.
        indent: how far to the right it stands.
        place: of a line that may be one, -1 for a block.
    """

    word: str
    indent: int
    place: int = -1


def placed(lines: Iterable[Line]) -> tuple[Line, ...]:
    """Return the lines with final faults about `then`: with an end below, `then` begins a block."""
    read = tuple(lines)
    if not any(map(_lacks_then, read)):
        return read
    stated = [place for place, line in enumerate(read) if line.statement is not None]
    ended = dict(_ended(read, stated))
    following = dict(pairwise(stated))
    found = list(read)
    for place in stated:
        line = read[place]
        if not _lacks_then(line):
            continue
        if place not in ended:
            behind = following.get(place)
            if behind is None or read[behind].indent <= line.indent:
                continue
        is_certain = ended.get(place) and not _holds_another(line)
        found[place] = _with_lines_below(line) if is_certain else _without_fix(line)
    return tuple(found)


def begins_block(line: Line) -> bool:
    """Return whether lines below belong to a condition with a statement on its line (see `placed`)."""
    return line.fault is not None and line.fault.fix.startswith(_BLOCK)


def _ended(read: tuple[Line, ...], stated: Iterable[int]) -> Iterator[tuple[int, bool]]:
    """Yield lines without `then` that an end or `else` below belongs to, and whether that is certain."""
    stack: list[_Open] = []
    for place in stated:
        line, indent = read[place], read[place].indent
        word, end = opened(line), closed(line)
        if word == "task":
            stack.clear()
        if _lacks_then(line):
            stack.append(_Open("if", indent, place))
        elif word:
            stack.append(_Open(word, indent))
        elif end or "if" in middle(line):
            last = _cut_to(stack, end or "if", indent)
            if last is not None and last.place >= 0:
                yield last.place, _is_certain(stack)
                last.place = -1
            if last is not None and end:
                stack.pop()


def _cut_to(stack: list[_Open], word: str, indent: int) -> _Open | None:
    """Return the block that an end or an `else` is of, the last one of the stack then; None for none."""
    while stack and stack[-1].place >= 0 and stack[-1].indent > indent:
        stack.pop()
    if not any(word in (ANY, one.word) for one in stack):
        return None
    while word not in (ANY, stack[-1].word):
        stack.pop()
    return stack[-1]


def _is_certain(stack: list[_Open]) -> bool:
    """Return whether the end of the last block is not that of one around it, as far to the right."""
    around = stack[-2] if len(stack) > 1 else None
    return around is None or around.place >= 0 or around.indent != stack[-1].indent


def _lacks_then(line: Line) -> bool:
    statement, fault = line.statement, line.fault
    is_one_line = isinstance(statement, If) and statement.body is not None
    return fault is not None and is_one_line and fault.fix.startswith(_MISSING)


def _holds_another(line: Line) -> bool:
    return isinstance(line.statement, If) and isinstance(line.statement.body, If)


def _with_lines_below(line: Line) -> Line:
    assert line.fault is not None
    word = line.fault.fix.removeprefix(_MISSING)
    text = line.logical.text
    fix = f"{_BLOCK}{text[: line.indent]}  {word}"
    return replace(line, fault=replace(line.fault, hint=_BELOW.format(word), fix=fix))


def _without_fix(line: Line) -> Line:
    assert line.fault is not None
    return replace(line, fault=replace(line.fault, hint=_UNSURE, fix=""))
