"""A text in its form: indentation, blanks, lower-case words; wrong lines stay unchanged."""

from collections.abc import Iterable

from ropsim.core import SourceText
from ropsim.language.blocks.block_ends import indented
from ropsim.language.form.line_groups import LineGroup, line_groups
from ropsim.language.form.rows import rows, without_blanks
from ropsim.language.form.sameness import shape
from ropsim.language.form.writing import INDENT, written
from ropsim.language.syntax.line import parse_line
from ropsim.language.syntax.lines import logical_lines
from ropsim.language.syntax.statements import Broken, ContractClause
from ropsim.language.syntax.text import Line

_MARK = "\ufeff"
"""Byte order mark: it may begin a text."""


def formatted(text: str) -> str:
    """Return a text in its form: it means the same, and the form of it is itself.

    Blocks are indented by two blanks, statements have a single blank between words and around operators,
    words of the language are written in lower case, and no more than one empty line stands between others.
    Comments and line breaks are kept, a comment behind a statement in its column where there is room. Lines
    that cannot be read keep their characters, and so does the prose of contracts. Where a block has no end or
    an end no block, indentation says how far it reaches: those lines stay unchanged, including empty ones.
    """
    if _MARK in text[1:]:
        return text
    read = tuple(line_groups(SourceText("", text)))
    ending = "\r\n" if "\r\n" in text else "\n"
    result = "".join(line + ending for line in _lines(read))
    if text.endswith("\\") or not all(group.is_sound for group in read[-1:]):
        result = result.removesuffix(ending)  # with a line end the last line would go on, or be another one
    form = _MARK + result if text.startswith(_MARK) and not result.startswith(_MARK) else result
    kept = _unsound(read)
    return form if not kept or _unsound(line_groups(SourceText("", form))) == kept else text


def _unsound(read: Iterable[LineGroup]) -> list[tuple[str, ...]]:
    """Return the lines in which blocks have no ends: in the form of a text they are still the same ones."""
    return [group.physical for group in read if not group.is_sound]


def _lines(read: Iterable[LineGroup]) -> list[str]:
    """Return the physical lines of a text in their form."""
    laid: list[str] = []
    is_sound = True
    for group in read:
        is_sound = group.is_sound
        if not is_sound:
            laid += group.physical
            continue
        for (line, depth), (_, physical) in zip(
            indented(line for line, _ in group.lines), group.lines, strict=True
        ):
            block = _laid(line, depth, physical)
            if block != [""] or (laid and laid[-1]):
                laid += block
    while is_sound and laid and not laid[-1]:
        laid.pop()
    return laid


def _laid(line: Line, depth: int, physical: tuple[str, ...]) -> list[str]:
    statement = line.statement
    if isinstance(statement, Broken):
        return list(physical)
    if isinstance(statement, ContractClause) or (statement is None and len(physical) == 1):
        bare = (without_blanks(one.replace(_MARK, " ")) for one in physical)
        return [INDENT * depth + one if one else "" for one in bare]
    as_written = list(physical)
    own = written(rows(line.logical.text, physical), line.logical.text, statement, depth)
    return own if own != as_written and _means(own, line) else as_written


def _means(own: list[str], line: Line) -> bool:
    """Return whether physical lines are one logical line with the statement of `line`."""
    found = list(logical_lines(SourceText("", "\n".join(own))))
    statement, fault = parse_line(found[0].text)
    return len(found) == 1 and fault is None and shape(statement) == shape(line.statement)
