"""Points and parts of a target that stand in the wrong place of a motion."""

from collections.abc import Iterator

from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.expressions import expression, total
from ropsim.language.syntax.lexer import Token
from ropsim.language.syntax.words import EXTERNAL, FREE, VIA

_OF_LOCATIONS = frozenset(("in", "@", "above", "offset", "rel", EXTERNAL, FREE))
"""Words by which a location goes on."""
_OPENING, _CLOSING = ("(", "["), (")", "]")


def refuse(cursor: Cursor, head: Token, modifier: Token | None) -> None:
    """Refuse the next word of a motion if it belongs before the words already read.

    Args:
        cursor: behind the target and its modifiers.
        head: first word of the motion.
        modifier: first word of the modifiers, None where there are none.
    """
    if cursor.word == "to" and modifier is None:
        _further_point(cursor, head)
    elif cursor.word in _OF_LOCATIONS and modifier is not None:
        _part_of_target(cursor, modifier)


def _further_point(cursor: Cursor, head: Token) -> None:
    """Refuse `a to b to c`."""
    if head.word in ("circ", "movc"):
        cursor.fail("the end of the line", "a curve through more points is a `spline`")
    points = list(_points(cursor))
    start = cursor.tokens[1].start
    while cursor.accept("to"):
        begin = cursor.start
        expression(cursor)
        points.append(cursor.line[begin : cursor.end])
    written = f"{VIA} {', '.join(points[:-1])} to {points[-1]}"
    hint = f"points on the way stand before the one target: write `{head.text} {written}`"
    message = "expected the end of the line, found `to`"
    cursor.fault(kinds.UNEXPECTED, start, cursor.end, message, hint, fix=written)


def _points(cursor: Cursor) -> Iterator[str]:
    """Yield the points after the words `to` of a motion, up to the next token."""
    depth, start, end = 0, -1, 0
    for token in cursor.tokens[1 : cursor.index]:
        if start < 0 and token.word in (VIA, "to"):
            continue
        if depth == 0 and token.word == "to":
            yield cursor.line[start:end]
            start = -1
            continue
        depth += (token.word in _OPENING) - (token.word in _CLOSING)
        start, end = token.start if start < 0 else start, token.end
    if start >= 0:
        yield cursor.line[start:end]


def _part_of_target(cursor: Cursor, modifier: Token) -> None:
    """Refuse `in frame` and its like behind modifiers."""
    line, word, start = cursor.line, cursor.token.text, cursor.start
    before = line[modifier.start : start].rstrip()
    cursor.go(1)
    if word.lower() in ("in", "@"):
        cursor.name("the name of a frame")
    elif word.lower() != FREE:
        total(cursor)
    message = f"expected the end of the line, found `{word}`"
    part = line[start : cursor.end]
    hint = f"it is a part of the location, before `{modifier.text}`: write `{part} {before}`"
    cursor.fault(kinds.UNEXPECTED, modifier.start, cursor.end, message, hint, fix=f"{part} {before}")
