"""The physical lines of a statement: tokens, a comment, and whether the line goes on."""

from ropsim.core import frozen_dataclass
from ropsim.language.syntax.lexer import Token, tokens
from ropsim.language.syntax.line import ORDINAL

_BLANKS = " \t"


@frozen_dataclass
class Row:
    r"""A physical line of a statement.

    Attributes:
        tokens: on it; the number before a task in listing style is one of them, of kind `ordinal`.
        comment: from its sign on, a `\` at the end of the line included; empty where there is none.
        column: where the comment begins, from 0.
        is_continued: whether a `\` ends the line and the next one belongs to it.
    """

    tokens: tuple[Token, ...]
    comment: str
    column: int
    is_continued: bool


def rows(logical: str, physical: tuple[str, ...]) -> tuple[Row, ...]:
    """Return the physical lines of a logical one.

    Args:
        logical: the text that is parsed, character for character as long as the physical lines together.
        physical: the lines as written.

    Raises:
        LineFaultError: a character or text that the language does not have.
    """
    ordinal = ORDINAL.match(logical)
    blank = " " * ordinal.end() + logical[ordinal.end() :] if ordinal else logical
    found = tokens(blank)
    if ordinal:
        text = ordinal[0].strip()
        start = ordinal[0].index(text)
        found.insert(0, Token("ordinal", "", text, start, start + len(text)))
    result: list[Row] = []
    begin = at = 0
    for number, text in enumerate(physical):
        first, end = at, begin + len(text)
        while at < len(found) and found[at].start < end:
            at += 1
        behind = found[at - 1].end if at > first else begin
        is_continued = text.endswith("\\") and number < len(physical) - 1
        rest = logical[behind:end]
        column = end - begin - len(rest.lstrip(_BLANKS))
        comment = "" if column == end - begin else text[column:]
        comment = comment if is_continued else without_blanks(comment)
        result.append(Row(tuple(found[first:at]), comment, column, is_continued))
        begin = end + 1
    return tuple(result)


def without_blanks(text: str) -> str:
    r"""Return a text without blanks around it; a `\` that blanks keep from going on keeps one of them."""
    bare = text.strip(_BLANKS)
    return f"{bare} " if bare.endswith("\\") and not text.endswith("\\") else bare
