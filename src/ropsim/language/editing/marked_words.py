"""Kinds of the characters of a text, for colours: words of the language, numbers, texts, comments."""

import re
from collections.abc import Iterator
from enum import Enum

from ropsim.core import SourceText, Span, frozen_dataclass
from ropsim.language.cache import LineCache
from ropsim.language.check.expressions.functions import NAMES
from ropsim.language.editing.uses import Uses
from ropsim.language.editing.uses_of import statements_of
from ropsim.language.syntax.fault import LineFaultError
from ropsim.language.syntax.lexer import Token, tokens
from ropsim.language.syntax.readers.declarations import TYPES
from ropsim.language.syntax.statements import ContractClause
from ropsim.language.syntax.text import Line

_COMMENT = re.compile(r'"(?:[^"\\]++|\\.)*+(?:"|\\?$)|((?:#|//).*)')


class Mark(Enum):
    """Kind of a range of characters that is no name."""

    KEYWORD = "word of the language"
    TYPE = "type"
    FUNCTION = "function of the language"
    MEMBER = "component"
    NUMBER = "number"
    TEXT = "text"
    COMMENT = "comment"


@frozen_dataclass
class Marked:
    """A range of characters on one line."""

    span: Span
    mark: Mark


def marked_words(source: SourceText, cache: LineCache, uses: Uses) -> tuple[Marked, ...]:
    """Return all marked ranges except uses of names, in order of place.

    Args:
        source: the text.
        cache: parsed lines.
        uses: of its names.
    """
    taken = {(one.span.line, one.span.column) for one in uses.found}
    found = [*_comments(source)]
    for line in statements_of(source, cache):
        found += (one for one in _of_line(source.name, line) if not _is_name(one, taken))
    return tuple(sorted(found, key=lambda one: (one.span.line, one.span.column)))


def _is_name(one: Marked, taken: set[tuple[int, int]]) -> bool:
    """Return whether a name stands there; that of a task may have quotes."""
    line, column = one.span.line, one.span.column
    return (line, column) in taken or (one.mark is Mark.TEXT and (line, column + 1) in taken)


def _comments(source: SourceText) -> Iterator[Marked]:
    for number, text in enumerate(source.lines, 1):
        if "#" not in text and "//" not in text:
            continue
        for match in _COMMENT.finditer(text):
            if match[1]:
                yield Marked(
                    Span.on_line(source.name, number, match.start(1) + 1, len(match[1])), Mark.COMMENT
                )


def _of_line(name: str, line: Line) -> Iterator[Marked]:
    if isinstance(line.statement, ContractClause):  # prose: its first word alone belongs to the language
        start = line.statement.start
        word = re.match(r"\w+", line.logical.text[start:])
        yield Marked(
            line.logical.span(name, start, start + len(word[0]) if word else start + 1), Mark.KEYWORD
        )
        return
    try:
        found = tokens(line.logical.text)
    except LineFaultError:
        return
    for place, token in enumerate(found):
        mark = _mark(found, place)
        if mark is not None:
            yield Marked(line.logical.span(name, token.start, token.end), mark)


def _mark(found: list[Token], place: int) -> Mark | None:
    token = found[place]
    before = found[place - 1].word if place else ""
    match token.kind:
        case "number":
            return Mark.NUMBER
        case "text":
            return Mark.TEXT
        case "sign":
            return None
    if before == ".":
        return Mark.MEMBER
    if before in (":", "->") and token.word in TYPES:
        return Mark.TYPE
    follows = found[place + 1].word if place + 1 < len(found) else ""
    return Mark.FUNCTION if token.word in NAMES and follows == "(" else Mark.KEYWORD
