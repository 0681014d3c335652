"""Expressions of a knowledge base as task text: terms to words, with no more parentheses than it needs."""

import re
from collections.abc import Mapping

from ropsim.language import FUNCTIONS, RESERVED_WORDS, UNIT_WORDS
from ropsim.prolog import Atom, Struct, Term, Var, write_term

OR, AND, NOT, COMPARISON, SUM, PRODUCT, SIGN, ATOM = range(8)
"""How strongly an expression holds together."""
COMPARISONS = {"=": "=", "==": "==", "\\=": "<>", "<": "<", ">": ">", "=<": "<=", ">=": ">="}
"""Comparisons of the language by Prolog operator."""
PRODUCTS = ("*", "/", "mod")
SHIFTS = ("above", "offset", "rel")
WORDS = frozenset(("true", "false", "on", "off", "here", "home"))
TURNS = frozenset(("down", "rpy", "quat", "rotvec", "pitch", "roll", "yaw", "rx", "ry", "rz"))
_NAME = re.compile(r"[A-Za-z]\w*", re.ASCII)
_UNNAMED = re.compile(r"(?<![\w'\"])_G?\d+\b")
"""Names that Prolog assigns to unnamed variables."""
_ESCAPED = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t"}


class NotTextError(ValueError):
    """A term that task text has no words for.

    Attributes:
        term: it.
        wanted: the expected kinds.
    """

    def __init__(self, term: Term, wanted: str) -> None:
        super().__init__(f"`{shown(term)}` is not {wanted}")
        self.term = term
        self.wanted = wanted


def shown(term: Term) -> str:
    """Return a term in at most 60 characters."""
    text = _UNNAMED.sub("_", write_term(term))
    return text if len(text) <= 60 else f"{text[:57]}…"


def expression(term: Term, names: Mapping[str, str]) -> str:
    """Return the text of an expression.

    Raises:
        NotTextError: a part of the term is none.
    """
    return _written(term, names)[1]


def argument(term: Term, names: Mapping[str, str]) -> str:
    """Return the text of an argument of a call; `n = Value` passes it by name."""
    match term:
        case Struct("=", (Atom() as name, value)):
            return f"{name_of(name, names)} = {expression(value, names)}"
    return expression(term, names)


def quantity(term: Term, names: Mapping[str, str]) -> str:
    """Return the text of an expression where no comparison can stand."""
    return _at_least(term, SUM, names)


def name_of(term: Term, names: Mapping[str, str]) -> str:
    """Return the text of a name."""
    match term:
        case Var(name) if name in names:
            return names[name]
        case Atom(name) if _NAME.fullmatch(name) and not is_reserved(name):
            return name
    raise NotTextError(term, "a name of the task language")


def _at_least(term: Term, level: int, names: Mapping[str, str]) -> str:
    found, text = _written(term, names)
    return text if found >= level else f"({text})"


def _written(term: Term, names: Mapping[str, str]) -> tuple[int, str]:
    """Return how strongly an expression holds together, and its text."""
    match term:
        case bool():
            pass
        case int() | float():
            return (SIGN if term < 0 else ATOM), number_text(term)
        case str():
            return ATOM, '"' + "".join(_ESCAPED.get(one, one) for one in term) + '"'
        case Atom(name) if name in WORDS:
            return ATOM, name
        case Atom() | Var():
            return ATOM, name_of(term, names)
        case Struct():
            if (unit := unit_of(term)) is not None:
                number, word = unit
                return (SIGN if number < 0 else ATOM), f"{number_text(number)} {word}"
            return _operator(term, names)
    raise NotTextError(term, "an expression of the task language")


def _operator(term: Struct, names: Mapping[str, str]) -> tuple[int, str]:
    match term:
        case Struct("or" | "and" as word, (left, right)):
            level = OR if word == "or" else AND
            return level, f"{_at_least(left, level, names)} {word} {_at_least(right, level + 1, names)}"
        case Struct("not", (one,)):
            return NOT, f"not {_at_least(one, NOT, names)}"
        case Struct("is", (one, Atom("on" | "off" | "true" | "false" as level_word))):
            return COMPARISON, f"{_at_least(one, SUM, names)} is {level_word}"
        case Struct(name, (left, right)) if name in COMPARISONS:
            sides = _at_least(left, SUM, names), _at_least(right, SUM, names)
            return COMPARISON, f"{sides[0]} {COMPARISONS[name]} {sides[1]}"
        case Struct("+" | "-" as word, (left, right)):
            return SUM, f"{_at_least(left, SUM, names)} {word} {_at_least(right, PRODUCT, names)}"
        case Struct(name, (left, right)) if name in SHIFTS:
            return SUM, f"{_at_least(left, SUM, names)} {name} {_at_least(right, PRODUCT, names)}"
        case Struct("in", (left, frame)):
            return SUM, f"{_at_least(left, SUM, names)} in {name_of(frame, names)}"
        case Struct(name, (left, right)) if name in PRODUCTS:
            return PRODUCT, f"{_at_least(left, PRODUCT, names)} {name} {_at_least(right, SIGN, names)}"
        case Struct("-", (one,)):
            return SIGN, f"-{_at_least(one, ATOM, names)}"
    return ATOM, _primary(term, names)


def _primary(term: Struct, names: Mapping[str, str]) -> str:
    match term:
        case Struct("coordinate", (one, Atom(member))) if _NAME.fullmatch(member):
            return f"{_at_least(one, ATOM, names)}.{member}"
        case Struct("p", (*numbers, tuple(turns))) if len(numbers) == 3 and turns:
            words = ", ".join(_turn(one, names) for one in turns)
            return f"({', '.join(quantity(one, names) for one in numbers)}; {words})"
        case Struct("p", numbers) if len(numbers) in (3, 5, 6):
            return f"({', '.join(quantity(one, names) for one in numbers)})"
        case Struct("joints", values) if values:
            return f"joints({', '.join(expression(one, names) for one in values)})"
        case Struct(name, arguments) if name in FUNCTIONS and arguments:
            return f"{name}({', '.join(expression(one, names) for one in arguments)})"
    raise NotTextError(term, "an expression of the task language")


def _turn(term: Term, names: Mapping[str, str]) -> str:
    match term:
        case Atom("down"):
            return "down"
        case Struct(word, values) if word in TURNS:
            return f"{word} {' '.join(_at_least(one, SIGN, names) for one in values)}"
    raise NotTextError(term, "a turn of a location, such as `down` or `rz(90)`")


def unit_of(term: Struct) -> tuple[int | float, str] | None:
    """Return number and unit of `50*mm` or `5*mm/s`, None for any other term."""
    match term:
        case Struct("*", (int() | float() as number, Atom(unit))) if unit in UNIT_WORDS:
            return number, unit
        case Struct("/", (Struct("*", (int() | float() as number, Atom(first))), Atom(second))):
            return (number, f"{first}/{second}") if f"{first}/{second}" in UNIT_WORDS else None
    return None


def number_text(number: int | float) -> str:
    """Return a number as task text writes it."""
    text = repr(number)
    return text if "e" not in text or "." in text else text.replace("e", ".0e")


def short_text(number: int | float) -> str:
    """Return a number as task text writes it to the last digit, a whole one without a fraction."""
    return number_text(number).removesuffix(".0")


def is_reserved(name: str) -> bool:
    """Return whether a name is a word or a unit of the task language."""
    return name.lower() in RESERVED_WORDS or name in UNIT_WORDS or name.lower() in FUNCTIONS
