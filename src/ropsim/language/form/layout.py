"""A text in its form: indentation, blanks, lower-case words; lines that are wrong stay as they are."""

from collections.abc import Iterator

from ropsim.core import SourceText
from ropsim.language.cache import LineCache
from ropsim.language.form.indents import indented
from ropsim.language.form.rows import rows, without_blanks
from ropsim.language.form.sameness import shape
from ropsim.language.form.told import told
from ropsim.language.form.writing import INDENT, written
from ropsim.language.syntax.line import parse_line
from ropsim.language.syntax.lines import logical_lines
from ropsim.language.syntax.statements import Broken, ContractClause
from ropsim.language.text import Line, read

_MARK = "\ufeff"
"""Byte order mark: it may begin a text."""


def formatted(text: str) -> str:
    """Return a text in its form: it means the same, and the form of it is itself.

    Blocks are indented by two blanks, statements have one blank between words and around operators, words of
    the language are written in lower case, and no more than one empty line stands between others. Comments
    and line breaks are kept, a comment behind a statement in its column where there is room. Lines that
    cannot be read keep their characters, and so does the prose of contracts.
    """
    if _MARK in text[1:]:
        return text
    laid: list[str] = []
    for block in _blocks(SourceText("", text)):
        if block != [""] or (laid and laid[-1]):
            laid += block
    while laid and not laid[-1]:
        laid.pop()
    ending = "\r\n" if "\r\n" in text else "\n"
    result = "".join(line + ending for line in laid)
    if text.endswith("\\"):  # with a line end it would go on
        result = result.removesuffix(ending)
    return _MARK + result if text.startswith(_MARK) and not result.startswith(_MARK) else result


def _blocks(source: SourceText) -> Iterator[list[str]]:
    """Yield the physical lines of each logical one in their form."""
    lines = told(list(read(source, LineCache())))
    ends = [*(line.logical.number - 1 for line in lines[1:]), len(source.lines)]
    for (line, depth), end in zip(indented(lines), ends, strict=True):
        yield _laid(line, depth, source.lines[line.logical.number - 1 : end])


def _laid(line: Line, depth: int, physical: tuple[str, ...]) -> list[str]:
    statement = line.statement
    if isinstance(statement, Broken):
        return list(physical)
    if isinstance(statement, ContractClause) or (statement is None and len(physical) == 1):
        bare = (without_blanks(one.replace(_MARK, " ")) for one in physical)
        return [INDENT * depth + one if one else "" for one in bare]
    own = written(rows(line.logical.text, physical), line.logical.text, statement, depth)
    return own if _means(own, line) else list(physical)


def _means(own: list[str], line: Line) -> bool:
    """Return whether physical lines are one logical line that says what `line` says."""
    found = list(logical_lines(SourceText("", "\n".join(own))))
    statement, fault = parse_line(found[0].text)
    return len(found) == 1 and fault is None and shape(statement) == shape(line.statement)
