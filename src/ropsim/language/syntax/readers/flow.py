"""Lines that branch and jump, call tasks, assign and print."""

from ropsim.core import did_you_mean
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.expressions import expression, items, listed
from ropsim.language.syntax.lexer import Token
from ropsim.language.syntax.nodes import Item, Name
from ropsim.language.syntax.other_languages import ARGUMENTS, ELSE_IF, HINTS, STEP
from ropsim.language.syntax.readers import headers
from ropsim.language.syntax.statements import (
    Assign,
    Call,
    Closer,
    Else,
    ElseIf,
    Jump,
    Print,
    Return,
    Statement,
    Stop,
)
from ropsim.language.syntax.words import INSIDE, RESERVED


def closer(cursor: Cursor, head: Token) -> Statement:
    """Read `endp` and its like, or `end` alone."""
    headers.ended_again(cursor, head)
    return Closer("endp" if head.word == "endtask" else head.word, head.start, cursor.end)


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
        if cursor.word in ("+", "-") and cursor.look(1).word == "=":
            cursor.fail("`=`", STEP.format(f"{name.text}.{token.text}"))
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
