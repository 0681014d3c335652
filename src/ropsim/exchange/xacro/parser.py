"""The grammar of expressions, from the loosest to the tightest binding."""

from ropsim.exchange.xacro.meanings import (
    Meaning,
    compared,
    constant,
    false,
    first_of,
    folded,
    indexed,
    listed_values,
    named,
    true,
)
from ropsim.exchange.xacro.operators import BINARY, CONSTANTS, FUNCTIONS, applied
from ropsim.exchange.xacro.token_reader import MOST_DEPTH, TokenReader
from ropsim.exchange.xacro.tokens import Sort
from ropsim.exchange.xacro.values import XacroError, bounded, words

_LEVELS = (("==", "!=", "<", ">", "<=", ">=", "in", "not in"), ("+", "-"), ("*", "/", "//", "%"))


class Parser(TokenReader):
    """Parser of an expression to its meaning."""

    def meaning(self) -> Meaning:
        """Return the meaning of the whole text."""
        found = self._choice()
        if self._place < len(self._tokens):
            raise XacroError(f"`{self._tokens[self._place].text}` does not go on with an expression")
        return found

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
        return parts[0] if len(parts) == 1 else lambda names: first_of(parts, names, wanted=true)

    def _all(self) -> Meaning:
        parts = [self._not()]
        while self._take("and"):
            parts.append(self._not())
        return parts[0] if len(parts) == 1 else lambda names: first_of(parts, names, wanted=false)

    def _not(self) -> Meaning:
        count = 0
        while self._take("not"):
            count += 1
        inner = self._binary(0)
        return inner if not count else lambda names: bool(inner(names)) == (count % 2 == 0)

    def _binary(self, level: int) -> Meaning:
        """Return operators of a level and of tighter ones, from left to right."""
        if level == len(_LEVELS):
            return self._signed()
        left = self._binary(level + 1)
        rest: list[tuple[str, Meaning]] = []
        while name := self._operator(level):
            rest.append((name, self._binary(level + 1)))
        if not rest:
            return left
        return (lambda names: compared(left, rest, names)) if level == 0 else lambda n: folded(left, rest, n)

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
        """Return an atom with its suffixes: indices, and names of dictionaries."""
        found = self._atom()
        while sign := self._take("[", "."):
            if sign == "[":
                found = indexed(found, self._choice())
                self._need("]")
                continue
            name = self._name()
            if name == "get" and self._take("("):
                key, *default = self._list(")")[:2] or [constant(None)]
                found = indexed(found, key, default[0] if default else constant(None))
            else:
                found = indexed(found, constant(name))
        return found

    def _atom(self) -> Meaning:
        token = self._next()
        if token is None:
            raise XacroError("an expression ends too early")
        self._place += 1
        if token.sort is Sort.NUMBER:
            whole = token.text.isdigit() and len(token.text) < 19
            return constant(bounded(int(token.text) if whole else float(token.text)))
        if token.sort is Sort.TEXT:
            return constant(token.text[1:-1].replace("\\'", "'").replace('\\"', '"'))
        if (
            token.text == "xacro" and self._take(".") and self._take("load_yaml")
        ) or token.text == "load_yaml":
            return self._loaded()
        if token.text == "math" and self._take("."):
            return self._math()
        if token.sort is Sort.NAME:
            return self._called(token.text) if self._sign() == "(" else named(token.text)
        if token.text == "(":
            inner = self._list(")")
            return inner[0] if len(inner) == 1 else listed_values(inner)
        if token.text == "[":
            return listed_values(self._list("]"))
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
        return self._called(name) if self._sign() == "(" else constant(CONSTANTS.get(name))

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
