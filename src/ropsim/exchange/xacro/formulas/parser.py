"""The grammar of expressions, from the loosest to the tightest binding: a parser of our own.

The grammar is that of Python's expressions without assignments and lambdas. Called are the functions of
`functions.py` and `file_functions.py` and the methods of `methods.py`; all others are refused by name.
"""

import operator
from functools import lru_cache

from ropsim.exchange.xacro.formulas.access import indexed, member, method_called, sliced
from ropsim.exchange.xacro.formulas.comprehension import Clause, comprehended
from ropsim.exchange.xacro.formulas.file_functions import DIRECT, called_in_file
from ropsim.exchange.xacro.formulas.functions import CONSTANTS, FUNCTIONS
from ropsim.exchange.xacro.formulas.meanings import (
    Arguments,
    Meaning,
    called,
    compared,
    constant,
    first_of,
    folded,
    grouped_values,
    listed_values,
    named,
)
from ropsim.exchange.xacro.formulas.names import Names
from ropsim.exchange.xacro.formulas.operators import BINARY, applied
from ropsim.exchange.xacro.formulas.token_reader import MOST_DEPTH, TokenReader
from ropsim.exchange.xacro.formulas.tokens import Sort, text_in
from ropsim.exchange.xacro.formulas.values import Value, XacroError, bounded, key_of

_COMPARISONS = ("==", "!=", "<", ">", "<=", ">=", "in", "not in", "is", "is not")
_LEVELS = (_COMPARISONS, ("|",), ("^",), ("&",), ("<<", ">>"), ("+", "-"), ("*", "/", "//", "%"))
_REFUSED = ("lambda", "yield", "await")
_MODULES = ("math", "python")


class Parser(TokenReader):
    """Parser of an expression to its meaning."""

    def meaning(self) -> Meaning:
        """Return the meaning of the whole text."""
        found = self._conditional()
        if self._place < len(self._tokens):
            raise XacroError(f"`{self._tokens[self._place].text}` does not go on with an expression")
        return found

    def _conditional(self) -> Meaning:
        with self._deeper():
            chosen = self._disjunction()
            if not self._take("if"):
                return chosen
            condition = self._disjunction()
            self._need("else")
            other = self._conditional()
        return lambda names: chosen(names) if condition(names) else other(names)

    def _disjunction(self) -> Meaning:
        parts = [self._conjunction()]
        while self._take("or"):
            parts.append(self._conjunction())
        return parts[0] if len(parts) == 1 else lambda names: first_of(parts, names, wanted=bool)

    def _conjunction(self) -> Meaning:
        parts = [self._not()]
        while self._take("and"):
            parts.append(self._not())
        return parts[0] if len(parts) == 1 else lambda names: first_of(parts, names, wanted=operator.not_)

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
        if level == 0 and self._take("not"):
            self._need("in")
            return "not in"
        name = self._take(*_LEVELS[level])
        return "is not" if name == "is" and self._take("not") else name

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
        base = self._with_suffixes()
        if not self._take("**"):
            return base
        with self._deeper():
            exponent = self._signed()
        return lambda names: applied("**", BINARY["**"], [base(names), exponent(names)])

    def _with_suffixes(self) -> Meaning:
        """Return an atom with its suffixes: indices, slices, members and methods."""
        found = self._atom()
        count = 0
        while sign := self._take("[", "."):
            count += 1
            if count > MOST_DEPTH:
                raise XacroError(f"a value has more than {MOST_DEPTH} indices and members", "make it simpler")
            if sign == "[":
                found = self._element(found)
                continue
            name = self._name()
            if name.startswith("_"):
                raise XacroError(f"`.{name[:40]}` is not carried out", "names do not begin with `_`")
            called_method = self._sign() == "("
            found = method_called(found, name, self._arguments()) if called_method else member(found, name)
        return found

    def _element(self, of: Meaning) -> Meaning:
        """Return the index or slice of a value, from the brackets behind it."""
        ends: list[Meaning] = []
        colons = 0
        last: Meaning | None = None
        while not self._take("]"):
            if self._take(":"):
                colons += 1
                ends.append(last or constant(None))
                last = None
            elif last is None:
                last = self._conditional()
            else:
                raise XacroError("an expression lacks `]`")
        if not colons and last is not None:
            return indexed(of, last)
        if not colons or colons > 2:
            raise XacroError("brackets hold no index and no slice", "write such as [0] or [1:3]")
        return sliced(of, [*ends, last or constant(None)])

    def _atom(self) -> Meaning:
        token = self._next()
        if token is None:
            raise XacroError("an expression ends too early")
        self._place += 1
        if token.sort is Sort.NUMBER:
            whole = token.text.isdigit() and len(token.text) < 19
            return constant(bounded(int(token.text) if whole else float(token.text)))
        if token.sort is Sort.TEXT:
            return constant(self._texts(token.text))
        if token.sort is Sort.NAME:
            return self._word(token.text)
        if token.text == "(":
            return self._group()
        if token.text == "[":
            return self._list()
        if token.text == "{":
            return self._dictionary()
        raise XacroError(f"`{token.text}` begins no expression")

    def _texts(self, spelling: str) -> str:
        """Return texts that stand behind each other as one."""
        parts = [text_in(spelling)]
        while (token := self._next()) is not None and token.sort is Sort.TEXT:
            parts.append(text_in(token.text))
            self._place += 1
        return "".join(parts)

    def _word(self, name: str) -> Meaning:
        """Return the meaning of a name that is not a member: a call, a constant or a value."""
        if name in _REFUSED:
            raise XacroError(f"`{name}` is not carried out", "write the expression without it")
        if name == "xacro" and self._take("."):
            return called_in_file(self._name(), self._arguments())
        if name in DIRECT and self._sign() == "(":
            return called_in_file(name, self._arguments())
        if name in _MODULES and self._take("."):
            inner = self._name()
            if inner not in CONSTANTS:
                raise XacroError(f"`{name}.{inner[:40]}` is not carried out", _known())
            return self._called(inner) if self._sign() == "(" else constant(CONSTANTS[inner])
        return self._called(name) if self._sign() == "(" else named(name)

    def _called(self, name: str) -> Meaning:
        if name not in FUNCTIONS:
            raise XacroError(f"`{name[:40]}` cannot be called", _known())
        return called(name, FUNCTIONS[name], self._arguments())

    def _arguments(self) -> Arguments:
        """Return the arguments of a call, with their parentheses."""
        self._need("(")
        places: list[Meaning] = []
        keywords: dict[str, Meaning] = {}
        while not self._take(")"):
            key = self._keyword()
            if key:
                keywords[key] = self._conditional()
            else:
                places.append(self._turning(self._conditional()))
            if not self._take(","):
                self._need(")")
                break
        return places, keywords

    def _keyword(self) -> str:
        """Take the name and the `=` of an argument by name; empty where none stands here."""
        pair = self._tokens[self._place : self._place + 2]
        if len(pair) < 2 or pair[0].sort is not Sort.NAME or (pair[1].sort, pair[1].text) != (Sort.SIGN, "="):
            return ""
        self._place += 2
        return pair[0].text

    def _group(self) -> Meaning:
        """Return the contents of parentheses: a value, several values, or a comprehension."""
        if self._take(")"):
            return grouped_values([])
        parts = [self._turning(self._conditional())]
        comma = False
        while self._take(","):
            comma = True
            if self._sign() == ")":
                break
            parts.append(self._conditional())
        self._need(")")
        return grouped_values(parts) if comma else parts[0]

    def _list(self) -> Meaning:
        found: list[Meaning] = []
        while not self._take("]"):
            one = self._conditional()
            if not found and self._sign() == "for":
                inner = self._turning(one)
                self._need("]")
                return inner
            found.append(one)
            if not self._take(","):
                self._need("]")
                break
        return listed_values(found)

    def _turning(self, element: Meaning) -> Meaning:
        """Return a comprehension if one goes on behind its element, else the element."""
        clauses: list[Clause] = []
        while self._take("for"):
            if len(clauses) >= MOST_DEPTH:
                raise XacroError(f"an expression is more than {MOST_DEPTH} deep", "make it simpler")
            closing = self._take("(")
            variables = [self._name()]
            while self._take(","):
                variables.append(self._name())
            if closing:
                self._need(")")
            self._need("in")
            over = self._disjunction()
            conditions: list[Meaning] = []
            while self._take("if"):
                conditions.append(self._disjunction())
            clauses.append(Clause(tuple(variables), over, tuple(conditions)))
        return comprehended(element, clauses) if clauses else element

    def _dictionary(self) -> Meaning:
        pairs: list[tuple[Meaning, Meaning]] = []
        while not self._take("}"):
            key = self._conditional()
            self._need(":")
            pairs.append((key, self._conditional()))
            if not self._take(","):
                self._need("}")
                break
        return lambda names: bounded({key_of(key(names)): value(names) for key, value in pairs})


def _known() -> str:
    return f"functions are {', '.join(sorted(FUNCTIONS))}"


def value_of(text: str, names: Names) -> Value:
    """Return the value of an expression.

    Raises:
        XacroError: it has no value.
    """
    return _meaning(text)(names)


@lru_cache(maxsize=4096)
def _meaning(text: str) -> Meaning:
    return Parser(text).meaning()
