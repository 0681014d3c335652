"""A statement in its form, on as many physical lines as before."""

from collections.abc import Container, Sequence

from ropsim.core import frozen_dataclass
from ropsim.language.form.rows import Row
from ropsim.language.form.sameness import names_in
from ropsim.language.form.spacing import spaced
from ropsim.language.syntax.lexer import Token
from ropsim.language.syntax.statements import Statement

INDENT = "  "
_BEFORE_COMMENT = 2
"""Least number of blanks between a statement and a comment behind it."""


@frozen_dataclass
class _Open:
    """An open parenthesis: columns of its content and its end on further lines."""

    inside: int
    end: int


def written(rows: Sequence[Row], logical: str, statement: Statement | None, depth: int) -> list[str]:
    """Return the physical lines of a statement that stands in `depth` blocks.

    Lines that go on in a parenthesis begin behind it, or where nothing follows it on its line two blanks
    further in than that line; others that go on begin two blanks further in than the statement.
    """
    line = [token for row in rows for token in row.tokens]
    names = frozenset(names_in(statement))
    texts = [_cased(line, number, names) for number in range(len(line))]
    blanks = spaced(line, logical)
    opened: list[_Open] = []
    result: list[str] = []
    at = 0
    for row in rows:
        begin = _begin(row, opened, depth, is_first=not result)
        text = " " * begin
        for number in range(at, at + len(row.tokens)):
            text += (blanks[number] if number > at else "") + texts[number]
            if line[number].word in ("(", "["):
                opened.append(_Open(len(text), len(text) - 1))
            elif line[number].word in (")", "]") and opened:
                opened.pop()
        at += len(row.tokens)
        if row.tokens and row.tokens[-1].word in ("(", "["):
            opened[-1] = _Open(begin + len(INDENT), begin)
        result.append(_ended(text, row))
    return result


def _begin(row: Row, opened: Sequence[_Open], depth: int, *, is_first: bool) -> int:
    """Return the column in which a physical line begins."""
    if is_first:
        return depth * len(INDENT)
    if not opened:
        return (depth + 1) * len(INDENT)
    is_end = bool(row.tokens) and row.tokens[0].word in (")", "]")
    return opened[-1].end if is_end else opened[-1].inside


def _ended(text: str, row: Row) -> str:
    """Return a physical line with its comment, which keeps its column where there is room."""
    if row.comment and row.tokens:
        text = text.ljust(max(row.column, len(text) + _BEFORE_COMMENT))
    if row.comment:
        return text + row.comment
    return f"{text.rstrip()} \\" if row.is_continued else text.rstrip()


def _cased(line: Sequence[Token], number: int, names: Container[tuple[int, str]]) -> str:
    """Return a word in lower case where the language ignores case, else as written.

    The axes of `euler` are one word in any case, and are kept.
    """
    token = line[number]
    is_kept = (
        token.kind != "word"
        or (token.start, token.text) in names
        or (number and line[number - 1].word == "euler")
    )
    return token.text if is_kept else token.word
