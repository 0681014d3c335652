"""Lines that move the arm, work the gripper or copy a location."""

from dataclasses import dataclass, replace

from ropsim.core import maker
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.expressions import expression, listed, total
from ropsim.language.syntax.lexer import Token
from ropsim.language.syntax.nodes import Binary, External, Free, Name, Node, Rebase
from ropsim.language.syntax.readers.left_over import finish
from ropsim.language.syntax.readers.misplaced import refuse
from ropsim.language.syntax.readers.setting import QUANTITIES, quantity, set_statement, setting
from ropsim.language.syntax.statements import (
    Gripper,
    Load,
    Motion,
    SetSignal,
    Setting,
    Statement,
    Tracking,
    Trigger,
)
from ropsim.language.syntax.words import ACTIONS, ALONG, GAIN, INSIDE, NOT_YET, NOT_YET_MODIFIERS, VIA

_MODIFIERS = (*QUANTITIES, "fine", "tool")
_BEHIND_TARGETS = frozenset((*INSIDE, "in", "track", "and", "or", "is", "mod"))
"""Words that go on behind the target of a motion, or behind a value in it."""
_ENDINGS = ("until", "timeout", "store")
_ENDS = {"after": "start", "before": "end"}
_CANONICAL = {"movj": "mov", "movl": "lin", "movc": "circ"}

_made = maker(Motion)


def motion(cursor: Cursor, head: Token) -> Statement:
    """Read `mov|movj|lin|movl [via point {, point} to | to] target {modifier}`, or such `along list`."""
    via: tuple[Node, ...] = ()
    if cursor.word == VIA:
        cursor.advance()
        via = listed(cursor)
        _target_follows(cursor)
    elif _is_along(cursor):
        return _along(cursor, head)
    cursor.accept("to")
    return _motion(cursor, head, via)


def arc(cursor: Cursor, head: Token) -> Statement:
    """Read `circ|movc via point to target {modifier}`."""
    if cursor.word != VIA:
        cursor.fail("`via`", f"an arc needs a point on its way: `{head.word} via point to target`")
    cursor.advance()
    via = (expression(cursor),)
    if cursor.word == ",":
        cursor.fail("`to`", "three points make a circle; a curve through more of them is a `spline`")
    _target_follows(cursor)
    cursor.expect("to")
    return _motion(cursor, head, via)


def spline(cursor: Cursor, head: Token) -> Statement:
    """Read `spline [via] point {, point} to target {modifier}`, or `spline along list {modifier}`."""
    if _is_along(cursor):
        return _along(cursor, head)
    cursor.accept(VIA)
    if cursor.word == "to":
        cursor.fail("a point on the way", "a curve leads through points; without any it is a `lin`")
    via = listed(cursor)
    _target_follows(cursor)
    cursor.expect("to")
    return _motion(cursor, head, via)


def _is_along(cursor: Cursor) -> bool:
    """Return whether `along` and the name of a list follow; `along` alone may be the name of a location."""
    following = cursor.look(1)
    return cursor.word == ALONG and following.kind == "word" and following.word not in _BEHIND_TARGETS


def _along(cursor: Cursor, head: Token) -> Motion:
    """Read `along list [in frame | above d | offset (…) | rel (…)] {modifier}`."""
    cursor.advance()
    start = cursor.token
    found = _motion(cursor, head, ())
    inner: object = found.target
    while isinstance(inner, Binary | Rebase | External | Free):
        inner = inner.left if isinstance(inner, Binary) else inner.operand
    if not isinstance(inner, Name):
        message = "expected the name of a list of points behind `along`"
        cursor.fault(
            kinds.UNEXPECTED, start.start, start.end, message, "lists are the files `points/NAME.csv`"
        )
    return replace(found, along=inner)


def _target_follows(cursor: Cursor) -> None:
    """Refuse a list of points that no target follows."""
    if cursor.word != "to":
        cursor.fail("`to`", "the points on the way stand first, then the target: `via a, b to c`")


def _motion(cursor: Cursor, head: Token, via: tuple[Node, ...]) -> Motion:
    """Read the target and its modifiers."""
    target = expression(cursor)
    behind = cursor.index
    modifiers: list[Setting] = []
    triggers: list[Trigger] = []
    ending, corrected = _Ending(), None
    while not cursor.at_end:
        word = cursor.word
        if word in NOT_YET_MODIFIERS:
            cursor.not_yet(cursor.token, word)
        if word == VIA:
            cursor.fail("a modifier", "points on the way stand before the target: `via a to b`")
        if word == "at":
            triggers.append(_trigger(cursor))
        elif word in _ENDINGS:
            ending.read(cursor, word)
        elif word == "track":
            corrected = _tracking(cursor, corrected)
        elif word == "angle":
            modifiers.append(quantity(cursor))
        elif word in _MODIFIERS:
            modifiers.append(setting(cursor))
        else:
            refuse(cursor, head, cursor.tokens[behind] if behind < cursor.index else None)
            finish(cursor)
    word = _CANONICAL.get(head.word, head.word)
    ends = ending.condition, ending.timeout, ending.store
    settings, outputs = tuple(modifiers), tuple(triggers)
    return _made(word, via, target, settings, outputs, *ends, corrected, None, head.start, cursor.end)


def _tracking(cursor: Cursor, given: Tracking | None) -> Tracking:
    if given is not None:
        cursor.fail("another modifier", "`track` stands once in a motion: it is corrected by one sensor")
    return tracking(cursor)


@dataclass(slots=True)
class _Ending:
    """End conditions of a motion: `until condition`, `timeout t`, `store name`, each once."""

    condition: Node | None = None
    timeout: Node | None = None
    store: Name | None = None

    def read(self, cursor: Cursor, word: str) -> None:
        given = {"until": self.condition, "timeout": self.timeout, "store": self.store}
        if given[word] is not None:
            cursor.fail("another modifier", f"`{word}` stands once in a motion")
        cursor.advance()
        if word == "until":
            self.condition = expression(cursor)
        elif word == "timeout":
            self.timeout = total(cursor)
        else:
            self.store = cursor.name("the name of a variable")


def _trigger(cursor: Cursor) -> Trigger:
    """Read `at place after start|before end do set output …`."""
    start = cursor.advance().start
    place = total(cursor)
    side = cursor.word
    if side not in _ENDS:
        cursor.fail("`after start` or `before end`")
    cursor.advance()
    cursor.expect(_ENDS[side])
    cursor.expect("do")
    head = cursor.token
    if head.word in NOT_YET:
        cursor.not_yet(head, head.word)
    if head.word != "set":
        cursor.fail("`set`", "on the way of a motion only outputs are set: `do set NAME on`")
    cursor.advance()
    action = set_statement(cursor, head)
    if not isinstance(action, SetSignal):
        message = "on the way of a motion only outputs are set"
        cursor.fault(
            kinds.MISPLACED, action.start, action.end, message, "write settings as modifiers of a motion"
        )
    return Trigger(place, side, action, start, cursor.end)


def gripper(cursor: Cursor, head: Token) -> Statement:
    """Read `open|close [tool]`."""
    tool = None
    if cursor.token.kind == "word" and cursor.word not in ACTIONS and cursor.word != "else":
        if cursor.word in ("to", "force", "speed", "timeout", "expect"):
            cursor.not_yet(cursor.token, cursor.word)
        tool = cursor.name("the name of a tool")
        if cursor.word in ("to", "force", "speed", "timeout", "expect"):
            cursor.not_yet(cursor.token, cursor.word)
    return Gripper(head.word, tool, head.start, cursor.end)


def load(cursor: Cursor, head: Token) -> Statement:
    """Read `load (x, y, z), location`."""
    cursor.expect("(")
    names = [cursor.name("the name of a variable")]
    while cursor.accept(","):
        names.append(cursor.name("the name of a variable"))
    closing = cursor.token
    cursor.expect(")")
    if len(names) not in (3, 5, 6):
        cursor.go(-1)
        cursor.fail("3, 5 or 6 names", f"{len(names)} given up to `{closing.text}`")
    cursor.expect(",")
    return Load(tuple(names), expression(cursor), head.start, cursor.end)


_AXES = ("x", "y", "z")


def tracking(cursor: Cursor) -> Tracking:
    """Read the clause; `along` and `gain` stand behind the value, each once, in any order."""
    start = cursor.advance().start
    signal = cursor.name("the name of a signal")
    if not (cursor.accept("=") or cursor.accept(":=")):
        cursor.fail("`=`", "a sensor is given the value that it is to have: `track gap = 12 mm`")
    value = total(cursor)
    direction, gain = "", None
    while cursor.word in (ALONG, GAIN):
        if (cursor.word == ALONG and direction) or (cursor.word == GAIN and gain is not None):
            cursor.fail("another modifier", f"`{cursor.word}` stands once behind `track`")
        direction, gain = _option(cursor, direction, gain)
    return Tracking(signal, value, direction, gain, start, cursor.end)


def _option(cursor: Cursor, direction: str, gain: Node | None) -> tuple[str, Node | None]:
    if cursor.advance().word == GAIN:
        return direction, total(cursor)
    sign = "-" if cursor.accept("-") else ""
    if cursor.word not in _AXES:
        cursor.fail("`x`, `y` or `z`", "the correction goes along an axis of the tool: `along z`, `along -x`")
    return sign + cursor.advance().word, gain
