"""Expressions of `${...}`: a parser of our own, so that a file can compute numbers and do nothing else.

The grammar is that of Python's expressions, without assignments, lambdas, comprehensions and calls of all
but the functions of `operators.py`; texts and numbers have no methods.
"""

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Protocol

from ropsim.exchange.xacro.operators import BINARY, CONSTANTS, FUNCTIONS, applied
from ropsim.exchange.xacro.tokens import Sort, Token, tokens
from ropsim.exchange.xacro.values import Value, XacroError, bounded, words

MOST_DEPTH = 20
"""Parentheses in each other."""


class Names(Protocol):
    """Values by name."""

    def value(self, name: str) -> Value:
        """Return the value of a name.

        Raises:
            XacroError: nobody has given it one.
        """
        ...

    def loaded(self, path: str) -> Value:
        """Return the value of a parameter file.

        Raises:
            XacroError: it cannot be had.
        """
        ...


Meaning = Callable[[Names], Value]
"""What an expression stands for, given the values of names."""
_LEVELS = (("==", "!=", "<", ">", "<=", ">=", "in", "not in"), ("+", "-"), ("*", "/", "//", "%"))


def value_of(text: str, names: Names) -> Value:
    """Return the value of an expression.

    Raises:
        XacroError: it has none.
    """
    return _meaning(text)(names)


@lru_cache(maxsize=4096)
def _meaning(text: str) -> Meaning:
    return _Parser(text).meaning()


class _Parser:
    def __init__(self, text: str) -> None:
        self._tokens = list(tokens(text))
        self._place = 0
        self._depth = 0

    def meaning(self) -> Meaning:
        """Return what the whole text means."""
        found = self._choice()
        if self._place < len(self._tokens):
            raise XacroError(f"`{self._tokens[self._place].text}` does not go on with an expression")
        return found

    def _next(self) -> Token | None:
        return self._tokens[self._place] if self._place < len(self._tokens) else None

    def _sign(self) -> str:
        """Return the sign or word that comes next, empty for others."""
        token = self._next()
        return token.text if token and token.sort in (Sort.SIGN, Sort.NAME) else ""

    def _take(self, *texts: str) -> str:
        """Take the next word if it is one of these; return it, empty if it is not."""
        text = self._sign()
        if text not in texts:
            return ""
        self._place += 1
        return text

    def _need(self, text: str) -> None:
        if not self._take(text):
            raise XacroError(f"an expression lacks `{text}`")

    def _choice(self) -> Meaning:
        self._depth += 1
        if self._depth > MOST_DEPTH:
            raise XacroError(f"an expression is more than {MOST_DEPTH} deep", "make it simpler")
        chosen = self._any()
        if self._take("if"):
            condition = self._any()
            self._need("else")
            other = self._choice()
            self._depth -= 1
            return lambda names: chosen(names) if condition(names) else other(names)
        self._depth -= 1
        return chosen

    def _any(self) -> Meaning:
        parts = [self._all()]
        while self._take("or"):
            parts.append(self._all())
        return parts[0] if len(parts) == 1 else lambda names: _first(parts, names, wanted=_true)

    def _all(self) -> Meaning:
        parts = [self._not()]
        while self._take("and"):
            parts.append(self._not())
        return parts[0] if len(parts) == 1 else lambda names: _first(parts, names, wanted=_false)

    def _not(self) -> Meaning:
        count = 0
        while self._take("not"):
            count += 1
        inner = self._binary(0)
        return inner if not count else lambda names: bool(inner(names)) == (count % 2 == 0)

    def _binary(self, level: int) -> Meaning:
        """Return operators of a level and those that bind more tightly, from left to right."""
        if level == len(_LEVELS):
            return self._signed()
        left = self._binary(level + 1)
        rest: list[tuple[str, Meaning]] = []
        while name := self._operator(level):
            rest.append((name, self._binary(level + 1)))
        if not rest:
            return left
        return (
            (lambda names: _compared(left, rest, names)) if level == 0 else lambda n: _folded(left, rest, n)
        )

    def _operator(self, level: int) -> str:
        if level == 0 and self._sign() == "not":
            self._place += 1
            self._need("in")
            return "not in"
        return self._take(*_LEVELS[level])

    def _signed(self) -> Meaning:
        signs = []
        while sign := self._take("+", "-"):
            signs.append(sign)
        inner = self._power()
        if not signs:
            return inner
        factor = -1 if signs.count("-") % 2 else 1
        return lambda names: applied("-", lambda a: factor * +a, [inner(names)])

    def _power(self) -> Meaning:
        base = self._behind()
        if not self._take("**"):
            return base
        self._depth += 1
        if self._depth > MOST_DEPTH:
            raise XacroError(f"an expression is more than {MOST_DEPTH} deep", "make it simpler")
        exponent = self._signed()
        self._depth -= 1
        return lambda names: applied("**", BINARY["**"], [base(names), exponent(names)])

    def _behind(self) -> Meaning:
        """Return an atom with what stands behind it: indices, and names of dictionaries."""
        found = self._atom()
        while sign := self._take("[", "."):
            if sign == "[":
                found = _indexed(found, self._choice())
                self._need("]")
                continue
            name = self._name()
            if name == "get" and self._take("("):
                key, *default = self._list(")")[:2] or [_constant(None)]
                found = _indexed(found, key, default[0] if default else _constant(None))
            else:
                found = _indexed(found, _constant(name))
        return found

    def _name(self) -> str:
        token = self._next()
        if token is None or token.sort is not Sort.NAME:
            raise XacroError("a name is missing")
        self._place += 1
        return token.text

    def _atom(self) -> Meaning:
        token = self._next()
        if token is None:
            raise XacroError("an expression ends too early")
        self._place += 1
        if token.sort is Sort.NUMBER:
            whole = token.text.isdigit() and len(token.text) < 19
            return _constant(bounded(int(token.text) if whole else float(token.text)))
        if token.sort is Sort.TEXT:
            return _constant(token.text[1:-1].replace("\\'", "'").replace('\\"', '"'))
        if (
            token.text == "xacro" and self._take(".") and self._take("load_yaml")
        ) or token.text == "load_yaml":
            return self._loaded()
        if token.text == "math" and self._take("."):
            return self._math()
        if token.sort is Sort.NAME:
            return self._called(token.text) if self._sign() == "(" else _named(token.text)
        if token.text == "(":
            inner = self._list(")")
            return inner[0] if len(inner) == 1 else _listed(inner)
        if token.text == "[":
            return _listed(self._list("]"))
        if token.text == "{":
            return self._dictionary()
        raise XacroError(f"`{token.text}` begins no expression")

    def _loaded(self) -> Meaning:
        self._need("(")
        path = self._choice()
        self._need(")")
        return lambda names: names.loaded(words(path(names)))

    def _math(self) -> Meaning:
        name = self._name()
        return self._called(name) if self._sign() == "(" else _constant(CONSTANTS.get(name))

    def _called(self, name: str) -> Meaning:
        if name == "dict":
            return self._keyed()
        if name not in FUNCTIONS:
            raise XacroError(f"`{name}` cannot be called", f"functions are {', '.join(sorted(FUNCTIONS))}")
        self._need("(")
        parts = self._list(")")
        return lambda names: applied(name, FUNCTIONS[name], [part(names) for part in parts])

    def _keyed(self) -> Meaning:
        """Return the dictionary of `dict(name=value, ...)`."""
        self._need("(")
        pairs: list[tuple[str, Meaning]] = []
        while not self._take(")"):
            name = self._name()
            self._need("=")
            pairs.append((name, self._choice()))
            if not self._take(","):
                self._need(")")
                break
        return lambda names: bounded({name: value(names) for name, value in pairs})

    def _list(self, end: str) -> list[Meaning]:
        found: list[Meaning] = []
        while not self._take(end):
            found.append(self._choice())
            if not self._take(","):
                self._need(end)
                break
        return found

    def _dictionary(self) -> Meaning:
        pairs: list[tuple[Meaning, Meaning]] = []
        while not self._take("}"):
            key = self._choice()
            self._need(":")
            pairs.append((key, self._choice()))
            if not self._take(","):
                self._need("}")
                break
        return lambda names: bounded({str(key(names)): value(names) for key, value in pairs})


def _true(value: Value) -> bool:
    return bool(value)


def _false(value: Value) -> bool:
    return not value


def _first(parts: list[Meaning], names: Names, wanted: Callable[[Value], bool]) -> Value:
    """Return the first value that decides `or` or `and`; those behind it are not looked at."""
    value: Value = None
    for part in parts:
        value = part(names)
        if wanted(value):
            break
    return value


def _folded(left: Meaning, rest: list[tuple[str, Meaning]], names: Names) -> Value:
    value = left(names)
    for name, part in rest:
        value = applied(name, BINARY[name], [value, part(names)])
    return value


def _compared(left: Meaning, rest: list[tuple[str, Meaning]], names: Names) -> Value:
    """Return whether a chain of comparisons holds: a < b < c is a < b and b < c."""
    value = left(names)
    for name, part in rest:
        other = part(names)
        if not applied(name, BINARY[name], [value, other]):
            return False
        value = other
    return True


def _constant(value: Value) -> Meaning:
    return lambda _: value


def _named(name: str) -> Meaning:
    return lambda names: names.value(name)


def _listed(parts: list[Meaning]) -> Meaning:
    return lambda names: bounded([part(names) for part in parts])


def _indexed(of: Meaning, index: Meaning, default: Meaning | None = None) -> Meaning:
    """Return what stands at an index; where nothing does, the default, if there is one, as `get` has it."""

    def found(names: Names) -> Value:
        holder, key = of(names), index(names)
        if isinstance(holder, Mapping) and str(key) in holder:
            return holder[str(key)]
        if isinstance(holder, list | str) and isinstance(key, int) and -len(holder) <= key < len(holder):
            return holder[key]
        if default is not None and isinstance(holder, Mapping):
            return default(names)
        raise XacroError(f"there is nothing at `{str(key)[:40]}`", "look at the list or dictionary")

    return found
