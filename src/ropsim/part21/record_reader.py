"""Read a record of an exchange file: a keyword and its parameters."""

from math import isfinite

from ropsim.core import Diagnostic, Places
from ropsim.part21.diagnostics import SYNTAX
from ropsim.part21.exchange_file import NOTED, Record
from ropsim.part21.scanner import Scanner, SyntaxProblemError, Token, TokenKind
from ropsim.part21.strings import BadStringError, decoded
from ropsim.part21.values import Absent, Binary, Enumeration, Reference, Typed, Value

MAX_DEPTH = 32
"""Lists and typed values in each other that are read; a matrix has two."""
MAX_DIGITS = 40
"""Digits of an integer that are read."""
_ABSENT = {one.value: one for one in Absent}


def read_record(scanner: Scanner, places: Places) -> Record:
    """Return the record that comes next.

    Args:
        scanner: stands before it, and behind it afterwards.
        places: of the same text.

    Raises:
        SyntaxProblemError: there is none, or it is damaged.
    """
    keyword = scanner.take_keyword()
    scanner.take_sign("(")
    values: list[Value] = []
    offsets: list[int] = []
    while not scanner.is_sign(")"):
        if values:
            scanner.take_sign(",")
        if len(offsets) < NOTED:
            offsets.append(scanner.token.offset)
        values.append(_value(scanner, places, 0))
    scanner.take()
    return Record(keyword, tuple(values), tuple(offsets))


def _value(scanner: Scanner, places: Places, depth: int) -> Value:
    if depth > MAX_DEPTH:
        raise scanner.problem(f"at most {MAX_DEPTH} parentheses in each other")
    token = scanner.token
    if token.kind is TokenKind.SIGN:
        if token.text == "(":
            return _list(scanner, places, depth)
        if token.text in _ABSENT:
            scanner.take()
            return _ABSENT[token.text]
        raise scanner.problem("a parameter")
    if token.kind is TokenKind.KEYWORD:
        keyword = scanner.take_keyword()
        scanner.take_sign("(")
        value = _value(scanner, places, depth + 1)
        scanner.take_sign(")")
        return Typed(keyword, value)
    if token.kind is TokenKind.END:
        raise scanner.problem("a parameter")
    return _simple(scanner, places)


def _list(scanner: Scanner, places: Places, depth: int) -> Value:
    plain = scanner.take_plain_list() if depth < MAX_DEPTH else None
    if plain is not None:
        reals, references = plain
        return (*map(float, reals), *[Reference(int(one.strip()[1:])) for one in references])
    scanner.take()
    values: list[Value] = []
    while not scanner.is_sign(")"):
        if values:
            scanner.take_sign(",")
        values.append(_value(scanner, places, depth + 1))
    scanner.take()
    return tuple(values)


def _simple(scanner: Scanner, places: Places) -> Value:
    token = scanner.take()
    match token.kind:
        case TokenKind.STRING:
            return _string(token, places)
        case TokenKind.REFERENCE if len(token.text) < 20:
            return Reference(int(token.text[1:]))
        case TokenKind.ENUMERATION:
            return Enumeration(token.text[1:-1].upper())
        case TokenKind.BINARY:
            return Binary(token.text[1:-1].upper())
        case TokenKind.INTEGER if len(token.text) <= MAX_DIGITS:
            return int(token.text)
        case TokenKind.REAL if isfinite(number := float(token.text)):
            return number
        case _:
            raise scanner.problem(f"a number of up to {MAX_DIGITS} digits below 1.8E308", token)


def _string(token: Token, places: Places) -> str:
    try:
        return decoded(token.text[1:-1])
    except BadStringError as error:
        raise SyntaxProblemError(_bad_directive(token, places, int(error.args[0]))) from error


def _bad_directive(token: Token, places: Places, offset: int) -> Diagnostic:
    body = token.text[1:-1]
    shown = body[offset : offset + 6]
    return SYNTAX.at(
        places.span(token.offset + 1 + offset),
        f"the string has `{shown}`; allowed are `\\\\`, `\\X2\\…\\X0\\`, `\\X4\\…\\X0\\`, and `\\X\\E9`",
        hint="write a backslash twice",
        data={"found": shown},
    )
