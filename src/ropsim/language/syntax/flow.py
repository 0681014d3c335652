"""Lines that steer the flow of a program, call tasks, assign and print."""

from ropsim.core import did_you_mean
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax import headers
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.expressions import expression, items, listed, total
from ropsim.language.syntax.lexer import Token
from ropsim.language.syntax.nodes import Item, Name
from ropsim.language.syntax.other_languages import ARGUMENTS, ELSE_IF, FOR, HINTS, STEP
from ropsim.language.syntax.statements import (
    Assign,
    Call,
    Closer,
    Else,
    ElseIf,
    For,
    ForEach,
    Jump,
    Print,
    Repeat,
    Return,
    Statement,
    Stop,
    Until,
    While,
)
from ropsim.language.syntax.words import INSIDE, RESERVED


def closer(cursor: Cursor, head: Token) -> Statement:
    """Read `endp` and its like, or `end` alone."""
    return Closer("endp" if head.word == "endtask" else head.word, head.start, cursor.end)


def until(cursor: Cursor, head: Token) -> Statement:
    """Read `until condition`."""
    return Until(expression(cursor), head.start, cursor.end)


def elseif(cursor: Cursor, head: Token) -> Statement:
    """Read `elseif condition [then]`."""
    condition = expression(cursor)
    cursor.accept("then")
    headers.section_body(cursor, "endif")
    return ElseIf(condition, head.start, cursor.end)


def else_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `else`."""
    if cursor.word == "if":
        cursor.fail("the end of the line", ELSE_IF)
    headers.section_body(cursor, "endif")
    return Else(head.start, cursor.end)


def while_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `while condition [do]`."""
    condition = expression(cursor)
    headers.loop_body(cursor, "endw")
    return While(condition, head.start, cursor.end)


def repeat(cursor: Cursor, head: Token) -> Statement:
    """Read `repeat [count]`."""
    count = None
    if not cursor.at_end and not headers.begins_statement(cursor):
        count = expression(cursor)
    headers.repeated(cursor)
    return Repeat(count, head.start, cursor.end)


def for_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `for each name in pattern` or `for name = first to last [step s]`."""
    if cursor.accept("each"):
        name = cursor.name("the name of a variable")
        cursor.expect("in")
        chosen = cursor.name("the name of a pattern")
        headers.loop_body(cursor, "endf")
        return ForEach(name, chosen, head.start, cursor.end)
    if cursor.token.kind != "word":
        cursor.fail("`each` or the name of a variable", FOR)
    name = cursor.name("`each` or the name of a variable")
    if cursor.word not in ("=", ":="):
        if near := did_you_mean(name.text, ("each",)):
            message = f"expected `each` or `=` behind a name, found `{name.text}`"
            cursor.fault(kinds.UNEXPECTED, name.start, name.end, message, near)
        cursor.fail("`=`", FOR)
    cursor.expect_equals()
    first = total(cursor)
    if cursor.word in (",", "."):
        cursor.fail("`to`", FOR)
    cursor.expect("to")
    last = total(cursor)
    step = total(cursor) if cursor.accept("step") else None
    headers.loop_body(cursor, "endf")
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
    if cursor.word in ("+", "-") and cursor.look(1).word in (cursor.word, "="):
        cursor.fail("`=`", STEP.format(name.text))
    return _arguments(cursor, name, name.start)


def _is_argument(cursor: Cursor) -> bool:
    """Return whether another argument comes next; a word behind a number is an odd unit."""
    token = cursor.token
    if token.kind == "word":
        before = cursor.look(-1).kind
        return before != "number" and token.word not in RESERVED and not did_you_mean(token.text, INSIDE)
    return token.kind in ("number", "text")


def _arguments(cursor: Cursor, name: Name, start: int) -> Statement:
    closing = _closing(cursor) if cursor.word == "(" and cursor.start == name.end else -1
    arguments: tuple[Item, ...] = ()
    cursor.arguments_at = cursor.index
    if not cursor.at_end:
        arguments = items(cursor)
        if name.text.lower() not in HINTS and _is_argument(cursor):
            cursor.fail("`,` or the end of the line", ARGUMENTS)
    return Call(name, arguments, closing, start, cursor.end)


def _closing(cursor: Cursor) -> int:
    """Return the place behind the parenthesis that comes next."""
    depth = 0
    for token in cursor.tokens[cursor.index : cursor.length]:
        depth += (token.word == "(") - (token.word == ")")
        if not depth:
            return token.end
    return -1
