"""Lines that declare things for the whole text, and task headers."""

from ropsim.core import did_you_mean
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.expressions import expression, listed, total
from ropsim.language.syntax.fault import Fault
from ropsim.language.syntax.lexer import UNITS, Token, text_value
from ropsim.language.syntax.nodes import Name, Node
from ropsim.language.syntax.other_languages import grid_hint
from ropsim.language.syntax.statements import (
    ConstantDeclaration,
    FrameDeclaration,
    LocationDeclaration,
    Mode,
    Parameter,
    PatternDeclaration,
    ProgramHeader,
    SignalDeclaration,
    Statement,
    TaskHeader,
    ToolDeclaration,
    Units,
    VariableDeclaration,
)
from ropsim.language.syntax.words import END, RESERVED

TYPES = (
    "num", "int", "bool", "str", "length", "angle", "time", "speed", "accel", "force", "loc", "joints",
    "frame", "tool", "signal",
)  # fmt: skip
_GIVING = frozenset(("return", "returns", "as", ":"))
"""Signs of other languages before the type of the result."""
_ORDERS = ("row", "column", "snake")
_UNIT_NAMES = frozenset(UNITS)
_OTHERS = {**dict.fromkeys(("real", "float", "double"), ""), "string": "str"}
"""Types of other languages and their equivalents; empty if the value or the task determines the type."""
_TYPES = frozenset((*TYPES, *_OTHERS))


def program(cursor: Cursor, head: Token) -> Statement:
    """Read `program name`."""
    return ProgramHeader(cursor.name("a program name"), head.start, cursor.end)


def units(cursor: Cursor, head: Token) -> Statement:
    """Read `units mm, deg, s`."""
    names = [_unit(cursor)]
    while cursor.accept(","):
        names.append(_unit(cursor))
    return Units(tuple(names), head.start, cursor.end)


def mode(cursor: Cursor, head: Token) -> Statement:
    """Read `classic` or `strict`."""
    return Mode(head.word, head.start, cursor.end)


def frame(cursor: Cursor, head: Token) -> Statement:
    """Read `frame name = pose`."""
    name = cursor.name("the name of a frame")
    cursor.expect_equals()
    return FrameDeclaration(name, expression(cursor), head.start, cursor.end)


def location(cursor: Cursor, head: Token) -> Statement:
    """Read `loc name = pose`."""
    name = cursor.name("the name of a location")
    cursor.expect_equals()
    return LocationDeclaration(name, expression(cursor), head.start, cursor.end)


def tool(cursor: Cursor, head: Token) -> Statement:
    """Read `tool name = pose {payload m | cog p | gripper g}`."""
    name = cursor.name("the name of a tool")
    cursor.expect_equals()
    value = total(cursor)
    extras: list[Name] = []
    while cursor.word in ("payload", "cog", "gripper"):
        token = cursor.advance()
        total(cursor) if token.word != "gripper" else cursor.name("the name of a gripper")
        extras.append(Name(token.word, token.start, cursor.end))
    return ToolDeclaration(name, value, tuple(extras), head.start, cursor.end)


def signal(cursor: Cursor, head: Token) -> Statement:
    """Read `signal name = [analog] input|output channel`."""
    name = cursor.name("the name of a signal")
    cursor.expect_equals()
    is_analog = cursor.accept("analog")
    if cursor.word not in ("input", "output"):
        cursor.fail("`input` or `output`", did_you_mean(cursor.word, ("input", "output")))
    is_input = cursor.advance().word == "input"
    return SignalDeclaration(name, is_analog, is_input, total(cursor), head.start, cursor.end)


def constant(cursor: Cursor, head: Token) -> Statement:
    """Read `const name [: type] = value`."""
    name, kind = _typed(cursor, "the name of a constant")
    cursor.expect_equals()
    return ConstantDeclaration(name, kind, expression(cursor), head.start, cursor.end)


def variable(cursor: Cursor, head: Token) -> Statement:
    """Read `var name [: type] [= value]`."""
    name, kind = _typed(cursor, "the name of a variable")
    value: Node | None = None
    if cursor.accept("=") or cursor.accept(":="):
        value = expression(cursor)
    return VariableDeclaration(name, kind, value, head.start, cursor.end)


def pattern(cursor: Cursor, head: Token) -> Statement:
    """Read `pattern name = grid a x b [x c] from pose step v1, v2[, v3] [order word]`."""
    name = cursor.name("the name of a pattern")
    cursor.expect_equals()
    cursor.expect("grid")
    counts = [total(cursor)]
    while cursor.accept("x"):
        counts.append(total(cursor))
    if len(counts) > 3:
        cursor.fail("at most three counts")
    if cursor.word != "from":
        cursor.fail("`from`", grid_hint(cursor.look(-1).text, cursor.word))
    cursor.advance()
    origin = total(cursor)
    cursor.expect("step")
    steps = listed(cursor)
    if len(steps) != len(counts):
        cursor.fail(f"{len(counts)} steps, one per count", f"{len(steps)} given")
    order = None
    if cursor.accept("order"):
        token = cursor.token
        if token.word not in _ORDERS:
            cursor.fail("`row`, `column` or `snake`", did_you_mean(token.text, _ORDERS))
        cursor.advance()
        order = Name(token.word, token.start, token.end)
    return PatternDeclaration(name, tuple(counts), origin, steps, order, head.start, cursor.end)


def task(cursor: Cursor, head: Token) -> Statement:
    """Read `task name [(parameters)] [-> type]`; the name may stand in quotes, as in paper 1."""
    token = cursor.token
    name = _quoted_name(cursor, token) if token.kind == "text" else _plain_name(cursor)
    parameters: tuple[Parameter, ...] | None = None
    if cursor.accept("("):
        listed_parameters: list[Parameter] = []
        if cursor.word != ")":
            listed_parameters.append(_parameter(cursor))
            while cursor.accept(","):
                listed_parameters.append(_parameter(cursor))
        cursor.expect(")")
        parameters = tuple(listed_parameters)
    result = _type(cursor) if cursor.accept("->") else _result(cursor)
    return TaskHeader(name, parameters, result, head.start, cursor.end)


def _result(cursor: Cursor) -> Name | None:
    """Read `return type` or `: type` in the place of `-> type`; None where nothing stands there."""
    sign, type_ = cursor.token, cursor.look(1)
    if sign.word not in _GIVING or type_.word not in TYPES:
        return None
    here, blank = f"-> {type_.word}", " " if sign.start == cursor.end else ""
    message = f"expected `->`, found `{sign.text}`"
    cursor.mend(Fault(kinds.UNEXPECTED, sign.start, type_.end, message, f"write `{here}`", blank + here))
    cursor.go(1)
    return _type(cursor)


def _plain_name(cursor: Cursor) -> Name:
    if cursor.word == END:
        cursor.fail(
            "a task name", f"`{cursor.token.text}` alone on a line closes a block and cannot name a task"
        )
    return cursor.name("a task name")


def _quoted_name(cursor: Cursor, token: Token) -> Name:
    text = text_value(token.text)
    if not (text.isascii() and text.isidentifier()) or text.lower() in {*RESERVED, END}:
        cursor.fail("a task name of letters, digits and `_` that is no word of the language")
    cursor.advance()
    return Name(text, token.start, token.end)


def _typed(cursor: Cursor, what: str) -> tuple[Name, Name | None]:
    """Read `name [: type]`; a type before the name, or without `:`, is read as meant."""
    first, second = cursor.token, cursor.look(1)
    if second.kind != "word" or _TYPES.isdisjoint((first.word, second.word)):
        name = cursor.name(what)
        return name, _type(cursor) if cursor.accept(":") else None
    type_, name_ = (first, second) if first.word in _TYPES else (second, first)
    here = _OTHERS.get(type_.word, type_.word)
    fix = f"{name_.text}: {here}" if here else name_.text
    if name_.word in RESERVED:
        return cursor.name(what), None
    message = (
        f"expected {what}, found `{first.text}`" if type_ is first else f"expected `:`, found `{second.text}`"
    )
    hint = f"write `{fix}`" if here else f"leave the type out: `{fix}`"
    cursor.mend(Fault(kinds.UNEXPECTED, first.start, second.end, message, hint, fix))
    cursor.go(2)
    return Name(name_.text, name_.start, name_.end), Name(here, type_.start, type_.end) if here else None


def _parameter(cursor: Cursor) -> Parameter:
    name, kind = _typed(cursor, "the name of a parameter")
    default = total(cursor) if cursor.accept("=") or cursor.accept(":=") else None
    return Parameter(name, kind, default)


def _type(cursor: Cursor) -> Name:
    token = cursor.token
    if token.kind != "word":
        cursor.fail("a type")
    if token.word in ("frame", "tool", "signal"):
        cursor.not_yet(token, f": {token.word}")
    if token.word not in TYPES:
        hint = did_you_mean(token.text, TYPES) or "types are " + ", ".join(f"`{t}`" for t in TYPES[:12])
        cursor.fault(
            name_kinds.UNKNOWN_TYPE, token.start, token.end, f"there is no type `{token.text}`", hint
        )
    cursor.advance()
    return Name(token.word, token.start, token.end)


def _unit(cursor: Cursor) -> Name:
    """Read one unit; `mm/s` arrives as three tokens here, because no number stands before it."""
    first = cursor.advance()
    text, end = first.text, first.end
    if cursor.word == "/":
        cursor.advance()
        last = cursor.advance()
        text, end = f"{text}/{last.text}", last.end
    if text not in _UNIT_NAMES or text == "%":
        hint = did_you_mean(text, UNITS) or "units are " + " ".join(UNITS)
        cursor.fault(name_kinds.UNKNOWN_UNIT, first.start, end, f"there is no unit `{text}`", hint)
    return Name(text, first.start, end)
