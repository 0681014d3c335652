"""Writes terms in canonical form, which every Prolog reads as the same term, independent of its operators."""

import re
from fractions import Fraction
from math import isfinite, isnan

from ropsim.prolog.terms.terms import Atom, Struct, Term, Var

_PLAIN = re.compile(r"[a-z][a-zA-Z0-9_]*|\[\]|\{\}|!|;")
_VARIABLE = re.compile(r"[A-Z_][a-zA-Z0-9_]*")
_SPECIAL = re.compile(r"[\x00-\x1f\\'\"\x7f\ud800-\udfff]")


def write_term(term: Term) -> str:
    """Return the canonical text of a term.

    Raises:
        ValueError: a variable has a name that is none.
        TypeError: a value is no term.
    """
    texts: list[str] = []
    left: list[Term | _Mark] = [term]
    while left:
        one = left.pop()
        match one:
            case _Mark():
                texts.append(one)
            case Struct("[|]", (head, tail)):
                left += (_Mark("]"), tail, _Mark("|"), head)
                texts.append("[")
            case Struct(name, arguments):
                texts.append(f"{_quoted(name)}(")
                left.append(_Mark(")"))
                left += _separated(arguments)
            case tuple():
                texts.append("[")
                left.append(_Mark("]"))
                left += _separated(one)
            case _:
                texts.append(_simple(one))
    return "".join(texts)


class _Mark(str):
    """A piece of text among terms."""

    __slots__ = ()


def _separated(items: tuple[Term, ...]) -> "list[Term | _Mark]":
    """Return terms with commas between them, the last first."""
    found: list[Term | _Mark] = []
    for item in reversed(items):
        found += (item, _Mark(","))
    return found[:-1]


def _simple(term: Term) -> str:
    match term:
        case Atom(name):
            return _quoted(name)
        case Var(name):
            if not _VARIABLE.fullmatch(name):
                raise ValueError(f"`{name}` is no name of a variable")
            return name
        case str():
            return '"' + _SPECIAL.sub(_escaped, term) + '"'
        case float():
            return _float(term)
        case bool():
            raise TypeError("a truth value is no term: use the atom `true`")
        case int():
            return str(term)
        case Fraction():
            return f"{term.numerator}r{term.denominator}" if term.denominator != 1 else str(term.numerator)
        case _:
            raise TypeError(f"{term!r} is no term")


def _float(number: float) -> str:
    if isnan(number):
        return "1.5NaN"
    if not isfinite(number):
        return "1.0Inf" if number > 0 else "-1.0Inf"
    text = repr(number)
    return text if "." in text else text.replace("e", ".0e")


def _quoted(name: str) -> str:
    return name if _PLAIN.fullmatch(name) and name != "[]" else "'" + _SPECIAL.sub(_escaped, name) + "'"


def _escaped(match: re.Match[str]) -> str:
    return f"\\{match[0]}" if match[0] in "\\'\"" else f"\\x{ord(match[0]):x}\\"
