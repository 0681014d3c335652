"""Lines that change how the next moves are made, and lines that set outputs."""

from typing import NoReturn

from ropsim.core import did_you_mean, maker
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.expressions import expression, total
from ropsim.language.syntax.fault import LineFaultError
from ropsim.language.syntax.lexer import Token
from ropsim.language.syntax.nodes import Literal, Name
from ropsim.language.syntax.other_languages import LEVELS, SET
from ropsim.language.syntax.other_settings import called, data
from ropsim.language.syntax.readers.headers import section_body
from ropsim.language.syntax.statements import SetMode, SetSignal, Setting, Statement, With

QUANTITIES = ("speed", "acc", "blend")
"""Settings that are a word and a value."""


UNLIKE = {"on": "high", "off": "low"}
"""Levels of other languages: the checker refuses them, since it knows the levels of outputs."""

_SETTINGS = (*QUANTITIES, "frame", "tool", "fine")

_setting = maker(Setting)


def set_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `set speed|acc|blend|frame|tool …` or `set output on|off|= value`."""
    following = cursor.look(1).word
    if cursor.word in _SETTINGS and following not in ("on", "off", "=", ":="):
        return SetMode(setting(cursor), head.start, cursor.end)
    name = cursor.name("`speed`, `acc`, `blend`, `fine`, `frame`, `tool` or the name of an output")
    if cursor.accept("=") or cursor.accept(":="):
        return SetSignal(name, expression(cursor), head.start, cursor.end)
    state = cursor.token
    if state.word not in ("on", "off", *LEVELS):
        _refuse(cursor, name)
    cursor.advance()
    level = UNLIKE[LEVELS[state.word]] if state.word in LEVELS else state.word
    return SetSignal(name, Literal(level, state.start, state.end), head.start, cursor.end)


def _refuse(cursor: Cursor, name: Name) -> NoReturn:
    """Refuse the words behind the name of an output, or a setting that is misspelt."""
    state = cursor.token
    word = called(name.text.lower()) if state.kind == "number" else ""
    if fix := word or data(name.text):
        message = f"expected a setting or the name of an output, found `{name.text}`"
        cursor.fault(kinds.UNEXPECTED, name.start, name.end, message, f"write `{fix}`", fix=fix)
    near = did_you_mean(name.text, _SETTINGS) if state.kind in ("number", "word") else ""
    if near:
        message = f"expected a setting or the name of an output, found `{name.text}`"
        cursor.fault(kinds.UNEXPECTED, name.start, name.end, message, near)
    if state.kind == "number":
        cursor.fail(
            "`on`, `off` or `=`", f"a digital output is set `on` or `off`, an analog one `= {state.text}`"
        )
    level = cursor.look(1)
    if state.word == "to" and level.word in ("on", "off"):
        message = "expected `on`, `off` or `=`, found `to`"
        cursor.fault(
            kinds.UNEXPECTED, state.start, level.end, message, f"write `{level.text}`", fix=level.text
        )
    cursor.fail("`on`, `off` or `=`", SET if state.word == "to" or cursor.at_end else "")


def with_statement(cursor: Cursor, head: Token) -> Statement:
    """Read `with setting {, setting}`."""
    settings = [setting(cursor)]
    while cursor.accept(","):
        settings.append(setting(cursor))
    if cursor.word in _SETTINGS:
        fix = f", {cursor.token.text}"
        raise LineFaultError(cursor.unexpected("`,`", "a comma stands between settings", fix))
    section_body(cursor, "endwith")
    return With(tuple(settings), head.start, cursor.end)


def quantity(cursor: Cursor) -> Setting:
    """Read `word value`."""
    token = cursor.advance()
    value = total(cursor)
    return _setting(token.word, value, None, token.start, cursor.end)


def setting(cursor: Cursor) -> Setting:
    """Read `speed|acc|blend value`, `fine`, `tool name` or `frame name`."""
    token = cursor.token
    word = token.word
    if word in QUANTITIES:
        return quantity(cursor)
    if word == "fine":
        cursor.advance()
        return Setting(word, None, None, token.start, cursor.end)
    if word in ("frame", "tool"):
        cursor.advance()
        name: Name = cursor.name(f"the name of a {word}")
        return Setting(word, None, name, token.start, cursor.end)
    expected = "`frame`, `tool`, `speed`, `acc`, `blend` or `fine`"
    if fix := called(word) or data(word):
        raise LineFaultError(cursor.unexpected(expected, f"write `{fix}`", fix))
    cursor.fail(expected)
