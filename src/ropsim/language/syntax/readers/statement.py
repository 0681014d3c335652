"""One statement by its first word: the table of the readers, and the lines that hold another statement."""

from collections.abc import Callable
from typing import NoReturn

from ropsim.core import did_you_mean
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.expressions import expression, total
from ropsim.language.syntax.lexer import Token, number_parts
from ropsim.language.syntax.nodes import Node
from ropsim.language.syntax.other_languages import (
    COMMENT,
    COMMENT_SIGNS,
    WAIT_CONDITION,
    WAIT_FOR,
    WAIT_LEVEL,
    WAIT_WORDS,
)
from ropsim.language.syntax.readers import declarations, flow, headers, loops, motion, setting
from ropsim.language.syntax.statements import (
    Assign,
    Broken,
    Call,
    Gripper,
    If,
    Jump,
    Load,
    Motion,
    Print,
    Return,
    SetMode,
    SetSignal,
    Statement,
    Stop,
    WaitCondition,
    WaitTime,
)
from ropsim.language.syntax.words import END, NOT_YET, RESERVED

_SIMPLE = (
    Motion, Gripper, Load, SetSignal, SetMode, WaitTime, WaitCondition, Jump, Return, Stop, Print, Call,
    Assign, Broken,
)  # fmt: skip


_CONDITIONAL = frozenset(("timeout", "and", "or", "is", "=", "==", "<", ">", "<=", ">=", "<>", "!="))
"""Words in a condition, or behind one."""


_START = "start with a statement word, a task or a variable"


def _begins_comment(sign: str, behind: str) -> bool:
    """Return whether a line that begins with these two words or signs is a comment elsewhere."""
    needed = COMMENT_SIGNS.get(sign)
    return needed is not None and needed in ("", behind)


def statement(cursor: Cursor) -> Statement:
    """Read one statement from the cursor on."""
    token = cursor.token
    if token.kind != "word":
        cursor.fault(
            kinds.STATEMENT_START,
            token.start,
            max(token.end, token.start + 1),
            f"a statement cannot start with `{token.text[:40]}`",
            COMMENT if _begins_comment(token.word, cursor.look(1).word) else _START,
        )
    if token.word in RESERVED and cursor.look(1).word in ("=", ":="):
        hint = f"`{token.text}` is a word of the language; choose another name for the variable"
        cursor.fault(
            kinds.STATEMENT_START, token.start, token.end, f"`{token.text}` cannot be assigned", hint
        )
    reader = _STATEMENTS.get(token.word)
    if reader is not None:
        cursor.advance()
        return reader(cursor, token)
    if token.word == END and cursor.look(1).kind == "end":
        return flow.closer(cursor, cursor.advance())
    if token.word == END and cursor.look(2).kind == "end":
        cursor.advance()
        closer = headers.ended(cursor, token)
        if closer is not None:
            return closer
        cursor.go(-1)
    if token.word in NOT_YET:
        cursor.not_yet(token, token.word)
    if token.word in RESERVED:
        is_home = token.word == "home" and cursor.look(1).kind == "end"
        hint = "write `mov home`" if is_home else "this word belongs inside a statement"
        cursor.fault(
            kinds.STATEMENT_START,
            token.start,
            token.end,
            f"a statement cannot start with `{token.text}`",
            hint,
        )
    return flow.plain(cursor)


def if_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `if condition [then [statement]]`."""
    condition = expression(cursor)
    body = None
    if not cursor.at_end and headers.then(cursor) and not cursor.at_end:
        headers.without_end(cursor)
        body = _simple(cursor)
    return If(condition, body, head.start, cursor.end)


def wait(cursor: Cursor, head: Token) -> Statement:
    """Read `wait t` or `wait until condition [timeout t [else statement]]`."""
    first, time = cursor.token, cursor.look(1)
    if first.word in WAIT_WORDS and time.kind == "number":
        written = time.text if number_parts(time.text)[1] else f"{time.text} s"
        message, hint = f"expected a time or `until`, found `{first.text}`", f"write `{head.text} {written}`"
        cursor.fault(kinds.UNEXPECTED, first.start, time.end, message, hint, fix=written)
    if first.word == "for":
        cursor.fail("a time or `until`", WAIT_FOR)
    if not cursor.accept("until"):
        return _wait_time(cursor, head)
    condition = expression(cursor)
    if cursor.token.word in {"on", "off"}:
        cursor.fail("the end of the line or `timeout`", WAIT_LEVEL[cursor.token.word])
    timeout: Node | None = None
    otherwise = None
    if cursor.accept("timeout"):
        timeout = total(cursor)
        if cursor.accept("else"):
            if cursor.at_end:
                cursor.fail("a statement", "a statement stands behind `else`")
            otherwise = _simple(cursor)
    return WaitCondition(condition, timeout, otherwise, head.start, cursor.end)


def _wait_time(cursor: Cursor, head: Token) -> Statement:
    """Read the time of a wait; a condition there is reported."""
    first = cursor.token
    if first.word == "not":
        _condition(cursor, first)
    duration = total(cursor)
    if cursor.word in _CONDITIONAL:
        _condition(cursor, first)
    if first.kind == "word" and cursor.token.kind == "word" and did_you_mean(first.text, ("until",)):
        message = f"expected a time or `until`, found `{first.text}`"
        cursor.fault(kinds.UNEXPECTED, first.start, first.end, message, "did you mean `until`?")
    return WaitTime(duration, head.start, cursor.end)


def _condition(cursor: Cursor, first: Token) -> NoReturn:
    """Refuse a condition where a time is waited for; `until` before its first word mends it."""
    message = f"expected a time or `until`, found the condition `{first.text} …`"
    cursor.fault(kinds.UNEXPECTED, first.start, first.end, message, WAIT_CONDITION, fix=f"until {first.text}")


def _simple(cursor: Cursor) -> Statement:
    """Read the statement after `then` or `else`; blocks cannot start there."""
    token = cursor.token
    cursor.count_operator()
    inner = statement(cursor)
    if not (isinstance(inner, _SIMPLE) or (isinstance(inner, If) and inner.body is not None)):
        cursor.fault(
            kinds.MISPLACED,
            token.start,
            token.end,
            f"`{token.text}` cannot stand behind `then` or `else` on a line",
            "write the block on lines of its own",
        )
    return inner


_STATEMENTS: dict[str, Callable[[Cursor, Token], Statement]] = {
    "program": declarations.program,
    "units": declarations.units,
    "classic": declarations.mode,
    "strict": declarations.mode,
    "frame": declarations.frame,
    "loc": declarations.location,
    "tool": declarations.tool,
    "signal": declarations.signal,
    "const": declarations.constant,
    "var": declarations.variable,
    "pattern": declarations.pattern,
    "task": declarations.task,
    "mov": motion.motion,
    "movj": motion.motion,
    "lin": motion.motion,
    "movl": motion.motion,
    "circ": motion.arc,
    "movc": motion.arc,
    "spline": motion.spline,
    "open": motion.gripper,
    "close": motion.gripper,
    "load": motion.load,
    "set": setting.set_statement,
    "with": setting.with_statement,
    "wait": wait,
    "if": if_statement,
    "elseif": flow.elseif,
    "else": flow.else_statement,
    "while": loops.while_statement,
    "repeat": loops.repeat,
    "until": loops.until,
    "for": loops.for_statement,
    "break": flow.jump,
    "continue": flow.jump,
    "return": flow.return_statement,
    "stop": flow.stop,
    "print": flow.print_statement,
    "call": flow.call,
    **dict.fromkeys(("endp", "endtask", "endr", "endif", "endw", "endf", "endwith"), flow.closer),
}
