"""Blanks between the tokens of a statement."""

from collections.abc import Sequence

from ropsim.language.editing.vocabulary import FUNCTIONS
from ropsim.language.syntax.lexer import Token
from ropsim.language.syntax.words import MOTION_MODIFIERS, RESERVED

_CONTEXTUAL = MOTION_MODIFIERS | frozenset(
    [
        "via", "external", "free", "speed", "acc", "blend", "fine", "tool", "frame", "p", "from", "step",
        "order", "grid", "each", "off", "on", "rpy", "quat", "rotvec", "euler", "pitch", "roll", "yaw", "rx",
        "ry", "rz", "like", "config", "turns", "after", "before",
    ]
)  # fmt: skip
"""Words that are names or not, depending on their place; blanks behind them are kept."""

_VALUES = frozenset(("true", "false", "here", "home"))
"""Reserved words that are values."""

_OPENING = frozenset("([")
_TIGHT_BEFORE = frozenset(",;:.)]")
_BEFORE_SIGN = frozenset("([,;:=<>+-*/@") | {":=", "==", "<>", "!=", "<=", ">=", "->"}
"""Signs behind which a minus belongs to the number that follows."""


def spaced(line: Sequence[Token], written: str) -> list[str]:
    """Return for each token the separator before it: a blank or nothing.

    Args:
        line: the tokens of a statement, in order.
        written: the logical line in which they stand.
    """
    return ["" if number == 0 or _touches(line, number, written) else " " for number in range(len(line))]


def _touches(line: Sequence[Token], number: int, written: str) -> bool:
    """Return whether nothing stands between a token and the one before it."""
    before, token = line[number - 1], line[number]
    left, right = before.word, token.word
    if "." in (left, right):
        return right == "." or _is_member(line, number)
    if right in _TIGHT_BEFORE or left in _OPENING:
        return True
    if right == "[":
        return before.kind == "word"
    if right == "(":
        return before.kind == "word" and _has_arguments(line, number, written)
    if left == "-" and _is_sign(line, number - 1, written):
        return True
    return "/" in (left, right) and line[0].word == "units"


def _is_member(line: Sequence[Token], number: int) -> bool:
    """Return whether a token behind a full stop is a member: `q.x`."""
    return line[number - 1].word == "." and line[number].kind == "word" and number > 1


def _has_arguments(line: Sequence[Token], number: int, written: str) -> bool:
    """Return whether the parenthesis behind a word is its list of arguments.

    Behind the name of a task that is called both forms exist, and both are kept: `Pick(q, n)` lists
    arguments, `Pick (1, 2, 3)` may pass one location.
    """
    word = line[number - 1].word
    if word in RESERVED:
        return False
    head = line[0].word
    is_header = head == "task" or (line[0].kind == "ordinal" and line[1].word == "task")
    if is_header:
        return True
    before = line[number - 2].word if number > 1 else "call"
    is_called = before in ("call", "then", "else", "do") or (before in ("=", ":=") and word not in FUNCTIONS)
    if is_called or word in _CONTEXTUAL:
        return _was_touching(line, number, written)
    return True


def _is_sign(line: Sequence[Token], number: int, written: str) -> bool:
    """Return whether a minus is the sign of the following value, rather than between two values."""
    before = line[number - 1] if number else None
    if before is None or before.word in _BEFORE_SIGN | (RESERVED - _VALUES):
        return True
    could_be = before.word in _CONTEXTUAL or _is_behind_semicolon(line, number)
    return could_be and _was_touching(line, number + 1, written) and not _was_touching(line, number, written)


def _is_behind_semicolon(line: Sequence[Token], number: int) -> bool:
    """Return whether a token stands in the orientation of a location, where numbers follow each other."""
    depth = 0
    for token in reversed(line[:number]):
        depth += (token.word in (")", "]")) - (token.word in _OPENING)
        if depth < 0:
            return False
        if depth == 0 and token.word == ";":
            return True
    return False


def _was_touching(line: Sequence[Token], number: int, written: str) -> bool:
    return number >= len(line) or not written[line[number - 1].end : line[number].start]
