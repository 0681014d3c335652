"""Parentheses: grouping, locations with their orientations, argument lists."""

from ropsim.core import did_you_mean
from ropsim.language.syntax import expressions
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.nodes import Item, Name, Node, Tuple, Turn
from ropsim.language.syntax.words import RESERVED

_TURN_COUNTS = {
    "rpy": 3,
    "rotvec": 3,
    "quat": 4,
    "euler": 3,
    "pitch": 1,
    "roll": 1,
    "yaw": 1,
    "rx": 1,
    "ry": 1,
    "rz": 1,
    "down": 0,
}
_AXES = frozenset(a + b + c for a in "XYZ" for b in "XYZ" for c in "XYZ" if a != b != c)


def parenthesis(cursor: Cursor) -> Node:
    """Read `( … )`: grouping with one plain member, else a tuple."""
    start = cursor.start
    cursor.open_parenthesis()
    items: list[Item] = []
    if cursor.word != ")":
        items.append(item(cursor))
        while cursor.accept(","):
            items.append(item(cursor))
    turns: tuple[Turn, ...] = ()
    if cursor.accept(";"):
        turns = _turns(cursor)
    cursor.close_parenthesis()
    if len(items) == 1 and not turns and items[0].name is None:
        return items[0].value
    return Tuple(tuple(items), turns, start, cursor.end)


def item(cursor: Cursor) -> Item:
    """Read `[name =] value`."""
    token = cursor.token
    if token.kind == "word" and cursor.look(1).word == "=" and token.word not in RESERVED:
        cursor.index += 2
        return Item(Name(token.text, token.start, token.end), expressions.expression(cursor))
    return Item(None, expressions.expression(cursor))


def _turns(cursor: Cursor) -> tuple[Turn, ...]:
    turns = [_turn(cursor)]
    while cursor.accept(","):
        turns.append(_turn(cursor))
    return tuple(turns)


def _turn(cursor: Cursor) -> Turn:
    token = cursor.token
    word = token.word
    if word in ("config", "turns"):
        cursor.not_yet(token, word)
    if word == "like":
        cursor.advance()
        pose = expressions.postfix(cursor)
        return Turn(word, "", (), pose, token.start, cursor.end)
    if word not in _TURN_COUNTS:
        hint = did_you_mean(token.text, [*_TURN_COUNTS, "like"]) if token.kind == "word" else ""
        cursor.fail("an orientation (`" + "`, `".join([*_TURN_COUNTS, "like"]) + "`)", hint)
    cursor.advance()
    axes = ""
    if word == "euler":
        axes = cursor.token.text.upper()
        if axes not in _AXES:
            cursor.fail("three axes such as `ZYX`", "neighbouring axes must differ")
        cursor.advance()
    values = tuple(expressions.unary(cursor) for _ in range(_TURN_COUNTS[word]))
    return Turn(word, axes, values, None, token.start, cursor.end)
