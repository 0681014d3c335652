"""Lines that steer the flow of a program, call tasks, assign, wait and print."""

from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax import tuples
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.expressions import expression, listed, total
from ropsim.language.syntax.lexer import Token
from ropsim.language.syntax.nodes import Name, Node
from ropsim.language.syntax.other_languages import WAIT_FOR
from ropsim.language.syntax.statements import (
    Assign,
    Broken,
    Call,
    Closer,
    Else,
    ElseIf,
    For,
    ForEach,
    Gripper,
    If,
    Jump,
    Load,
    Motion,
    Print,
    Repeat,
    Return,
    SetMode,
    SetSignal,
    Statement,
    Stop,
    Until,
    WaitCondition,
    WaitTime,
    While,
)

_SIMPLE = (
    Motion, Gripper, Load, SetSignal, SetMode, WaitTime, WaitCondition, Jump, Return, Stop, Print, Call,
    Assign, Broken,
)  # fmt: skip


def closer(cursor: Cursor, head: Token) -> Statement:
    """Read `endp` and its like."""
    return Closer("endp" if head.word == "endtask" else head.word, head.start, cursor.end)


def until(cursor: Cursor, head: Token) -> Statement:
    """Read `until condition`."""
    return Until(expression(cursor), head.start, cursor.end)


def if_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `if condition [then [statement]]`."""
    condition = expression(cursor)
    body = None
    if cursor.accept("then") and not cursor.at_end:
        body = _simple(cursor)
    return If(condition, body, head.start, cursor.end)


def elseif(cursor: Cursor, head: Token) -> Statement:
    """Read `elseif condition [then]`."""
    condition = expression(cursor)
    cursor.accept("then")
    return ElseIf(condition, head.start, cursor.end)


def else_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `else`."""
    return Else(head.start, cursor.end)


def while_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `while condition [do]`."""
    condition = expression(cursor)
    cursor.accept("do")
    return While(condition, head.start, cursor.end)


def repeat(cursor: Cursor, head: Token) -> Statement:
    """Read `repeat [count]`."""
    count = None if cursor.at_end else expression(cursor)
    return Repeat(count, head.start, cursor.end)


def for_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `for each name in pattern` or `for name = first to last [step s]`."""
    if cursor.accept("each"):
        name = cursor.name("the name of a variable")
        cursor.expect("in")
        chosen = cursor.name("the name of a pattern")
        return ForEach(name, chosen, head.start, cursor.end)
    name = cursor.name("`each` or the name of a variable")
    cursor.expect_equals()
    first = total(cursor)
    cursor.expect("to")
    last = total(cursor)
    step = total(cursor) if cursor.accept("step") else None
    cursor.accept("do")
    return For(name, first, last, step, head.start, cursor.end)


def jump(cursor: Cursor, head: Token) -> Statement:
    """Read `break` or `continue`."""
    return Jump(head.word, head.start, cursor.end)


def return_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `return [value]`."""
    value = None if cursor.at_end else expression(cursor)
    return Return(value, head.start, cursor.end)


def stop(cursor: Cursor, head: Token) -> Statement:
    """Read `stop [text]`."""
    message = None if cursor.at_end else expression(cursor)
    return Stop(message, head.start, cursor.end)


def wait(cursor: Cursor, head: Token) -> Statement:
    """Read `wait t` or `wait until condition [timeout t [else statement]]`."""
    if cursor.token.word == "for":
        cursor.fail("a time or `until`", WAIT_FOR)
    if not cursor.accept("until"):
        return WaitTime(total(cursor), head.start, cursor.end)
    condition = expression(cursor)
    timeout: Node | None = None
    otherwise = None
    if cursor.accept("timeout"):
        timeout = total(cursor)
        if cursor.accept("else"):
            otherwise = _simple(cursor)
    return WaitCondition(condition, timeout, otherwise, head.start, cursor.end)


def print_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `print value {, value}`."""
    return Print(listed(cursor), head.start, cursor.end)


def call(cursor: Cursor, head: Token) -> Statement:
    """Read the rest of `call task arguments`."""
    return _arguments(cursor, cursor.name("a task name"), head.start)


def plain(cursor: Cursor) -> Statement:
    """Read a line that starts with a name: an assignment or a call without `call`."""
    name = cursor.name("a statement")
    if cursor.accept("=") or cursor.accept(":="):
        return Assign(name, None, expression(cursor), name.start, cursor.end)
    if cursor.word == "." and cursor.look(1).kind == "word":
        cursor.advance()
        token = cursor.advance()
        cursor.expect_equals()
        member = Name(token.text, token.start, token.end)
        return Assign(name, member, expression(cursor), name.start, cursor.end)
    if cursor.word == "[":
        cursor.not_yet(cursor.token, "name[index]")
    return _arguments(cursor, name, name.start)


def _arguments(cursor: Cursor, name: Name, start: int) -> Statement:
    arguments = []
    if not cursor.at_end:
        arguments.append(tuples.item(cursor))
        while cursor.accept(","):
            arguments.append(tuples.item(cursor))
    return Call(name, tuple(arguments), start, cursor.end)


def _simple(cursor: Cursor) -> Statement:
    """Read the statement after `then` or `else`; blocks cannot start there."""
    from ropsim.language.syntax.line import statement

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
