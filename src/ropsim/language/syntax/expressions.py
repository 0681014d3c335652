"""Expressions by recursive descent; one function per level of precedence, weakest first."""

from collections.abc import Callable
from dataclasses import replace

from ropsim.core import did_you_mean, maker
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.lexer import LARGEST, number_parts, number_value, text_value
from ropsim.language.syntax.nodes import (
    Binary,
    External,
    Free,
    Function,
    Index,
    Item,
    Joints,
    Literal,
    Member,
    Name,
    Node,
    Number,
    Posture,
    Rebase,
    State,
    Text,
    Tuple,
    Turn,
    Unary,
)
from ropsim.language.syntax.words import EXTERNAL, FREE, RESERVED

_COMPARISONS = {"=": "=", "==": "==", "<>": "<>", "!=": "<>", "<": "<", ">": ">", "<=": "<=", ">=": ">="}
_SUMS = frozenset(("+", "-", "above", "offset", "rel"))
_TERMS = frozenset(("*", "/", "mod"))
_LITERALS = frozenset(("true", "false", "on", "off", "here", "home"))
_MEANINGFUL = RESERVED | _LITERALS | {"p", "joints", "gripper"}
"""Words that may be something else than a name where a value is meant."""
_STATES = frozenset(("on", "off", "true", "false"))
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
_TERM_WORDS = frozenset((*_TURN_COUNTS, "like", "config", "turns", FREE))
_OPERATORS = frozenset(
    (*_COMPARISONS, *_SUMS, *_TERMS, "in", "@", EXTERNAL, FREE, "is", "rising", "falling", "and", "or")
)
"""Words and signs by which an expression goes on behind a value."""
_OF_NAMES = frozenset(".[")
_GIVING = frozenset(("=", ":="))
_AXES = frozenset(a + b + c for a in "XYZ" for b in "XYZ" for c in "XYZ" if a != b != c)

_number, _name, _item = maker(Number), maker(Name), maker(Item)
_operation, _tuple = maker(Binary), maker(Tuple)


def expression(cursor: Cursor) -> Node:
    """Read `and {or and}`."""
    if cursor.word == "not":
        left = _negation(cursor)
    else:
        left = unary(cursor)
        if cursor.word not in _OPERATORS:  # most values stand alone
            return left
        left = _compared(cursor, _summed(cursor, _multiplied(cursor, left)))
    left = _joined(cursor, left)
    while cursor.word == "or":
        left = _binary(cursor, left, "or", _conjunction)
    return left


def _conjunction(cursor: Cursor) -> Node:
    return _joined(cursor, _negation(cursor))


def _joined(cursor: Cursor, left: Node) -> Node:
    while cursor.word == "and":
        left = _binary(cursor, left, "and", _negation)
    return left


def _negation(cursor: Cursor) -> Node:
    start = cursor.start
    count = 0
    while cursor.accept("not"):
        cursor.count_operator()
        count += 1
    operand = _compared(cursor, total(cursor))
    return Unary("not", operand, start, operand.end) if count % 2 else operand


def _compared(cursor: Cursor, left: Node) -> Node:
    """Read a comparison, if there is one."""
    word = cursor.word
    if word in _COMPARISONS:
        return _binary(cursor, left, _COMPARISONS[word], total)
    if word == "is":
        cursor.advance()
        negated = cursor.accept("not")
        state = cursor.token
        if state.word not in _STATES:
            if state.word in ("open", "close", "closed"):
                cursor.not_yet(state, f"is {state.word}")
            cursor.fail("`on`, `off`, `true` or `false`")
        cursor.advance()
        return State(left, state.word, negated, left.start, state.end)
    if word in ("rising", "falling"):
        cursor.not_yet(cursor.token, word)
    return left


def total(cursor: Cursor) -> Node:
    """Read sums and the pose operators, all of one precedence, from left to right."""
    left = unary(cursor)
    return _summed(cursor, _multiplied(cursor, left)) if cursor.word in _OPERATORS else left


def _summed(cursor: Cursor, left: Node) -> Node:
    """Read the rest of a sum behind its first term."""
    while True:
        word = cursor.word
        if word in _SUMS:
            left = _binary(cursor, left, word, _term)
        elif word in ("in", "@"):
            cursor.advance()
            cursor.count_operator()
            frame = cursor.name("the name of a frame")
            left = Rebase(left, frame, left.start, frame.end)
        elif word == EXTERNAL:
            left = _external(cursor, left)
        elif word == FREE:
            cursor.count_operator()
            left = Free(left, left.start, cursor.advance().end)
        else:
            return left


def _term(cursor: Cursor) -> Node:
    return _multiplied(cursor, unary(cursor))


def _multiplied(cursor: Cursor, left: Node) -> Node:
    """Read the rest of a product behind its first factor."""
    while cursor.word in _TERMS:
        left = _binary(cursor, left, cursor.word, unary)
    return left


def unary(cursor: Cursor) -> Node:
    """Read a value with any number of minus signs."""
    if cursor.word != "-":
        if cursor.token.kind != "number":
            return postfix(cursor)
        value = number(cursor)
        return _members(cursor, value) if cursor.word in _OF_NAMES else value
    start = cursor.start
    count = 0
    while cursor.accept("-"):
        cursor.count_operator()
        count += 1
    operand = postfix(cursor)
    return Unary("neg", operand, start, operand.end) if count % 2 else operand


def postfix(cursor: Cursor) -> Node:
    """Read a primary with its members: `slot.row`."""
    return _members(cursor, _primary(cursor))


def _members(cursor: Cursor, node: Node) -> Node:
    while cursor.word in _OF_NAMES:
        if cursor.word == ".":
            if cursor.look(1).kind != "word":
                return node
            cursor.advance()
            cursor.count_operator()
            token = cursor.advance()
            node = Member(node, Name(token.text, token.start, token.end), node.start, token.end)
        else:
            node = _index(cursor, node)
    return node


def _index(cursor: Cursor, operand: Node) -> Index:
    opening = cursor.start
    cursor.open_bracket()
    index = expression(cursor)
    cursor.close_bracket()
    return Index(operand, index, opening, operand.start, cursor.end)


def _primary(cursor: Cursor) -> Node:
    token = cursor.token
    word = token.word
    if token.kind == "word" and word not in _MEANINGFUL:
        cursor.advance()
        name = _name(token.text, token.start, token.end)
        return _function(cursor, name) if cursor.word == "(" else name
    if token.kind == "number":
        return number(cursor)
    if token.kind == "text":
        cursor.advance()
        return Text(text_value(token.text), token.start, token.end)
    if word == "(":
        return parenthesis(cursor)
    if token.kind == "word":
        if word == "p" and cursor.look(1).word == "(":
            cursor.advance()
            return parenthesis(cursor)
        if word in _LITERALS:
            cursor.advance()
            return Literal(word, token.start, token.end)
        if word == "joints" and cursor.look(1).word == "(":
            return _joints(cursor)
        if word == "gripper":
            cursor.not_yet(token, "gripper")
        if word not in RESERVED:
            cursor.advance()
            if cursor.word == "(":
                return _function(cursor, Name(token.text, token.start, token.end))
            return Name(token.text, token.start, token.end)
    cursor.fail("a value")


def number(cursor: Cursor) -> Number:
    """Read a number with its unit."""
    token = cursor.advance()
    value, is_whole, unit = number_value(token.text)
    if value > LARGEST:
        digits = number_parts(token.text)[0]
        shown = digits if len(digits) <= 20 else digits[:17] + "…"
        message = f"number `{shown}` is too large; at most {LARGEST:g} is allowed"
        cursor.fault(kinds.NUMBER_SIZE, token.start, token.end, message, "check the digits and the exponent")
    return _number(value, is_whole, unit, token.start, token.end)


def listed(cursor: Cursor) -> tuple[Node, ...]:
    """Read one or more expressions between commas."""
    values = [expression(cursor)]
    while cursor.accept(","):
        values.append(expression(cursor))
    return tuple(values)


def _binary(cursor: Cursor, left: Node, op: str, operand: Callable[[Cursor], Node]) -> Binary:
    cursor.advance()
    cursor.count_operator()
    right = operand(cursor)
    return _operation(op, left, right, left.start, right.end)


def _function(cursor: Cursor, name: Name) -> Function:
    opening = cursor.start
    cursor.open_parenthesis()
    arguments = () if cursor.word == ")" else items(cursor)
    location = _terms(cursor) if cursor.accept(";") else None
    cursor.close_parenthesis()
    if location is not None:  # one argument, which stands in the parentheses
        arguments = (_item(None, _tuple(arguments, *location, opening, cursor.end)),)
    return Function(name, arguments, opening, name.start, cursor.end)


def _external(cursor: Cursor, operand: Node) -> External:
    cursor.advance()
    if cursor.word != "(":
        cursor.fail("`(`", f"the values of external axes stand in parentheses: `{EXTERNAL} (800)`")
    cursor.open_parenthesis()
    values = listed(cursor)
    cursor.close_parenthesis()
    return External(operand, values, operand.start, cursor.end)


def _joints(cursor: Cursor) -> Joints:
    start = cursor.start
    cursor.advance()
    cursor.open_parenthesis()
    values = listed(cursor)
    cursor.close_parenthesis()
    return Joints(values, start, cursor.end)


def parenthesis(cursor: Cursor) -> Node:
    """Read `( … )`: grouping with one plain member, else a tuple.

    `name = value` is an argument by name where the parenthesis is the argument list of a call, elsewhere a
    comparison, which its parentheses keep one in any argument list.
    """
    start = cursor.start
    member = item if cursor.index == cursor.arguments_at else _unnamed
    cursor.open_parenthesis()
    members: list[Item] = []
    if cursor.word != ")":
        members.append(member(cursor))
        while cursor.accept(","):
            members.append(member(cursor))
    turns: tuple[Turn, ...] = ()
    posture = None
    if cursor.accept(";"):
        turns, posture = _terms(cursor)
    cursor.close_parenthesis()
    if len(members) == 1 and not turns and posture is None and members[0].name is None:
        only = members[0].value
        return replace(only, op="==") if isinstance(only, Binary) and only.op == "=" else only
    return _tuple(tuple(members), turns, posture, start, cursor.end)


def items(cursor: Cursor) -> tuple[Item, ...]:
    """Read one or more arguments of a call between commas."""
    found = [item(cursor)]
    while cursor.accept(","):
        found.append(item(cursor))
    return tuple(found)


def item(cursor: Cursor) -> Item:
    """Read `[name =] value`: at the start of an argument a name before `=` or `:=` is that of a parameter."""
    token = cursor.token
    if token.kind == "word" and cursor.look(1).word in _GIVING and token.word not in RESERVED:
        cursor.go(2)
        return Item(Name(token.text, token.start, token.end), expression(cursor))
    return Item(None, expression(cursor))


def _unnamed(cursor: Cursor) -> Item:
    return _item(None, expression(cursor))


def _terms(cursor: Cursor) -> tuple[tuple[Turn, ...], Posture | None]:
    """Read the orientation of a location, and in which posture it is to be reached."""
    start = cursor.start
    turns: list[Turn] = []
    words: tuple[Name, ...] = ()
    numbers, is_free = tuple[Node, ...](), False
    while True:
        word = cursor.word
        if (word == "config" and words) or (word == "turns" and numbers) or (word == FREE and is_free):
            cursor.fail("another term", f"`{word}` stands once in a location")
        if word == "config":
            words = _config(cursor)
        elif word == "turns":
            cursor.advance()
            cursor.open_parenthesis()
            numbers = listed(cursor)
            cursor.close_parenthesis()
        elif word == FREE:
            is_free = cursor.accept(FREE)
        else:
            turns.append(_turn(cursor))
        if not cursor.accept(","):
            if cursor.word in _TERM_WORDS or cursor.word == ";":
                cursor.fail("`,` or `)`", "write `,` between parts of an orientation: `; roll 0, pitch 60`")
            break
    has_any = bool(words or numbers or is_free)
    posture = Posture(words, numbers, is_free, start, cursor.end) if has_any else None
    return tuple(turns), posture


def _config(cursor: Cursor) -> tuple[Name, ...]:
    cursor.advance()
    if cursor.word != "(":
        cursor.fail("`(`", "write the words of a posture in parentheses: `config (left, up)`")
    cursor.open_parenthesis()
    words = [cursor.name("a word of a posture, such as `up`")]
    while cursor.accept(","):
        words.append(cursor.name("a word of a posture, such as `up`"))
    cursor.close_parenthesis()
    return tuple(words)


def _turn(cursor: Cursor) -> Turn:
    token = cursor.token
    word = token.word
    if word == "like":
        cursor.advance()
        pose = postfix(cursor)
        return Turn(word, "", (), pose, token.start, cursor.end)
    if word not in _TURN_COUNTS:
        allowed = [*_TURN_COUNTS, "like", "config", "turns", FREE]
        is_word = token.kind == "word"
        hint = did_you_mean(token.text, allowed) if is_word else "say which angles: `rpy ROLL PITCH YAW`"
        cursor.fail("an orientation (`" + "`, `".join(allowed) + "`)", hint)
    cursor.advance()
    axes = ""
    if word == "euler":
        axes = cursor.token.text.upper()
        if axes not in _AXES:
            cursor.fail("three axes such as `ZYX`", "neighbouring axes must differ")
        cursor.advance()
    values = tuple(unary(cursor) for _ in range(_TURN_COUNTS[word]))
    return Turn(word, axes, values, None, token.start, cursor.end)
