"""The headers and ends of loops."""

from ropsim.core import did_you_mean
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.expressions import expression, total
from ropsim.language.syntax.fault import Fault
from ropsim.language.syntax.lexer import Token
from ropsim.language.syntax.nodes import Name, Node, Number
from ropsim.language.syntax.other_languages import FOR
from ropsim.language.syntax.readers import headers
from ropsim.language.syntax.statements import For, ForEach, Repeat, Statement, Until, While


def until(cursor: Cursor, head: Token) -> Statement:
    """Read `until condition`."""
    return Until(expression(cursor), head.start, cursor.end)


def while_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `while condition [do]`."""
    condition = expression(cursor)
    headers.loop_body(cursor, "endw")
    return While(condition, head.start, cursor.end)


def repeat(cursor: Cursor, head: Token) -> Statement:
    """Read `repeat [count]`."""
    if cursor.word == "until":
        cursor.fail("a count or the end of the line", "`until` ends the loop: it stands below its lines")
    if cursor.word == "while":
        meant = cursor.line[cursor.start : cursor.tokens[cursor.length - 1].end]
        cursor.fail("a count or the end of the line", f"write `{meant}`, and `endw` at the end of the loop")
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
        return _over_pattern(cursor, head, name)
    if cursor.token.kind != "word":
        cursor.fail("`each` or the name of a variable", FOR)
    name = cursor.name("`each` or the name of a variable")
    if cursor.word == "in":
        return _in(cursor, head, name)
    if cursor.word not in ("=", ":="):
        if near := did_you_mean(name.text, ("each",)):
            message = f"expected `each` or `=` behind a name, found `{name.text}`"
            cursor.fault(kinds.UNEXPECTED, name.start, name.end, message, near)
        cursor.fail("`=`", FOR)
    cursor.advance()
    return _counted(cursor, head, name)


def _in(cursor: Cursor, head: Token, name: Name) -> Statement:
    """Read `for name in`: a counting loop or one over a pattern, depending on the following words."""
    behind = cursor.look(2)
    if behind.word == "to":
        cursor.mend(cursor.unexpected("`=`", FOR, "="))
        cursor.advance()
        return _counted(cursor, head, name)
    if cursor.look(1).kind == "word" and (behind.kind == "end" or behind.word == "do"):
        message, fix = "expected `=`, found `in`", f"each {name.text} in"
        cursor.mend(Fault(kinds.UNEXPECTED, name.start, cursor.token.end, message, FOR, fix))
        cursor.advance()
        return _over_pattern(cursor, head, name)
    cursor.fail("`=`", FOR)


def _over_pattern(cursor: Cursor, head: Token, name: Name) -> Statement:
    chosen = cursor.name("the name of a pattern")
    headers.loop_body(cursor, "endf")
    return ForEach(name, chosen, head.start, cursor.end)


def _counted(cursor: Cursor, head: Token, name: Name) -> Statement:
    first = total(cursor)
    if cursor.word in (",", "."):
        cursor.fail("`to`", FOR)
    if cursor.word == "downto":
        return For(name, first, *_down(cursor, cursor.advance()), head.start, cursor.end)
    cursor.expect("to")
    last = total(cursor)
    if cursor.word == "by":
        cursor.mend(cursor.unexpected("`step`", "write `step`", "step"))
    step = None
    if cursor.word in ("step", "by"):
        cursor.advance()
        step = total(cursor)
    headers.loop_body(cursor, "endf")
    return For(name, first, last, step, head.start, cursor.end)


def _down(cursor: Cursor, word: Token) -> tuple[Node, Node | None]:
    """Read the last value behind `downto`, which is `to` and a negative step."""
    start, step, size = cursor.start, None, "1"
    last = total(cursor)
    written = cursor.line[start : cursor.end]
    if cursor.accept("step") or cursor.accept("by"):
        cursor.accept("-")
        step = total(cursor)
        size = cursor.line[step.start : step.end] if isinstance(step, Number) else ""
    fix = f"to {written} step -{size}" if size else ""
    hint = f"write `{fix}`" if size else "a loop goes down with a negative step: `to 1 step -2`"
    message = f"expected `to`, found `{word.text}`"
    cursor.mend(Fault(kinds.UNEXPECTED, word.start, cursor.end, message, hint, fix))
    headers.loop_body(cursor, "endf")
    return last, step
