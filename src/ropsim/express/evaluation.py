"""The value of an expression for the instances of a file, with three logical values.

None stands for UNKNOWN and for missing values. An operation on missing values, or on values of wrong types,
returns None and never raises: a rule with the result None is undecided.
"""

import operator
from collections.abc import Callable, Mapping
from math import isfinite
from typing import TypeGuard

from ropsim.express.expressions import (
    Binary,
    Call,
    Collection,
    Expression,
    Index,
    Literal,
    Member,
    Name,
    Operator,
    Query,
    Self,
    Unary,
)
from ropsim.express.population import Population, plain
from ropsim.part21 import Enumeration, Reference

MAX_STEPS = 1_000_000
"""Expressions that are evaluated for one file; a robot needs some ten thousand."""
MAX_DEPTH = 60
"""Derived attributes and expressions in each other that are followed."""

Scope = Mapping[str, object]
"""Values of names; `self` is the instance or the value of the rule."""


class TooMuchWorkError(Exception):
    """The rules of a file take more steps than are allowed."""


class Evaluation:
    """Evaluates expressions for the instances of one file."""

    def __init__(self, population: Population) -> None:
        self._population = population
        self._items = population.schema.items
        self._steps = 0
        self._depth = 0

    def truth(self, expression: Expression, scope: Scope) -> bool | None:
        """Return whether a condition holds; None where that is undecided.

        Raises:
            TooMuchWorkError: more than `MAX_STEPS` in all.
        """
        value = self.value(expression, scope)
        return value if isinstance(value, bool) else None

    def value(self, expression: Expression, scope: Scope) -> object:
        """Return the value of an expression, None if it is unknown.

        Raises:
            TooMuchWorkError: more than `MAX_STEPS` in all.
        """
        self._steps += 1
        if self._steps > MAX_STEPS:
            raise TooMuchWorkError
        if self._depth > MAX_DEPTH:
            return None
        self._depth += 1
        found = self._value(expression, scope)
        self._depth -= 1
        return found

    def _value(self, expression: Expression, scope: Scope) -> object:
        match expression:
            case Literal(value):
                return value
            case Self():
                return scope["self"]
            case Name(name):
                return self._named(name, scope)
            case Member(source, name, owner):
                return self._attribute(self.value(source, scope), name, owner)
            case Index(source, index):
                return _element(self.value(source, scope), self.value(index, scope))
            case Unary(sign, operand):
                return _unary(sign, self.value(operand, scope))
            case Binary():
                return self._binary(expression, scope)
            case Call(function, arguments):
                return self._call(function, [self.value(one, scope) for one in arguments])
            case Query():
                return self._query(expression, scope)
            case Collection(items):
                return tuple(self.value(one, scope) for one in items)

    def _named(self, name: str, scope: Scope) -> object:
        if name in scope:
            return scope[name]
        if isinstance(scope.get("self"), Reference):
            found = self._attribute(scope["self"], name, "")
            if found is not None or name not in self._items:
                return found
        return Enumeration(name.upper()) if name in self._items else None

    def _attribute(self, source: object, name: str, owner: str) -> object:
        """Return an attribute of an instance: derived, explicit or inverse, the nearest declaration first."""
        population, schema = self._population, self._population.schema
        if not isinstance(source, Reference) or not population.lineage(source.number):
            return None
        within = schema.lineages.get(owner, ()) if owner else population.lineage(source.number)
        derivations = population.derivations(source.number)
        for entity in reversed(within):
            if derived := derivations.get((entity, name)):
                return self.value(derived.expression, {"self": source})
        for entity in reversed(within):
            value = population.explicit(source.number, entity, name)
            if value is not None:
                return plain(value)
        for entity in within:
            for inverse in schema.entities[entity].inverses:
                if inverse.name == name:
                    users = population.users(source.number, inverse.entity, inverse.attribute)
                    found = tuple(map(Reference, users))
                    return found if not inverse.single else next(iter(found), None)
        return None

    def _binary(self, expression: Binary, scope: Scope) -> object:
        left = self.value(expression.left, scope)
        sign = expression.operator
        if sign is Operator.AND and left is False:
            return False
        if sign is Operator.OR and left is True:
            return True
        right = self.value(expression.right, scope)
        if sign is Operator.IN and isinstance(right, tuple):
            self._steps += len(right)
        return _joined(sign, left, right)

    def _call(self, function: str, values: list[object]) -> object:
        first = values[0]
        match function:
            case "exists":
                return first is not None
            case "nvl":
                return values[1] if first is None else first
            case "sizeof":
                return len(first) if isinstance(first, tuple) else None
            case "typeof":
                return self._types(first)
            case "abs":
                return abs(first) if _is_number(first) else None
            case _:
                return _computed(Operator.POWER, first, 0.5) if _is_number(first) and first >= 0 else None

    def _types(self, value: object) -> object:
        if not isinstance(value, Reference):
            return None
        schema = self._population.schema.name
        return tuple(f"{schema}.{one}".upper() for one in self._population.lineage(value.number))

    def _query(self, query: Query, scope: Scope) -> object:
        source = self.value(query.source, scope)
        if not isinstance(source, tuple):
            return None
        kept = []
        for one in source:
            element = plain(one)
            if self.truth(query.condition, {**scope, query.variable: element}) is True:
                kept.append(one)
        return tuple(kept)


def _element(source: object, index: object) -> object:
    if not isinstance(source, tuple) or type(index) is not int or not 1 <= index <= len(source):
        return None
    return plain(source[index - 1])


def _unary(sign: Operator, value: object) -> object:
    if sign is Operator.NOT:
        return not value if isinstance(value, bool) else None
    if not _is_number(value):
        return None
    return -value if sign is Operator.SUBTRACT else value


def _joined(sign: Operator, left: object, right: object) -> object:
    """Return the result of an operator on two operands."""
    match sign:
        case Operator.AND:
            return _all_true(left, right)
        case Operator.OR:
            negated = _all_true(_unary(Operator.NOT, left), _unary(Operator.NOT, right))
            return _unary(Operator.NOT, negated)
        case Operator.XOR:
            return left is not right if isinstance(left, bool) and isinstance(right, bool) else None
        case Operator.IN:
            return _is_in(left, right)
        case Operator.EQUAL | Operator.SAME:
            return _are_equal(left, right)
        case Operator.NOT_EQUAL | Operator.NOT_SAME:
            return _unary(Operator.NOT, _are_equal(left, right))
        case _:
            return _computed(sign, left, right)


def _all_true(left: object, right: object) -> bool | None:
    if left is False or right is False:
        return False
    return True if left is True and right is True else None


def _are_equal(left: object, right: object) -> bool | None:
    if left is None or right is None:
        return None
    if _is_number(left) and _is_number(right):
        return left == right
    return left == right if type(left) is type(right) else None


def _is_in(left: object, right: object) -> bool | None:
    if left is None or not isinstance(right, tuple):
        return None
    return any(_are_equal(left, plain(one)) is True for one in right)


_COMPARED: Mapping[Operator, Callable[..., object]] = {
    Operator.LESS: operator.lt,
    Operator.LESS_EQUAL: operator.le,
    Operator.GREATER: operator.gt,
    Operator.GREATER_EQUAL: operator.ge,
}
_COMPUTED: Mapping[Operator, Callable[..., object]] = {
    Operator.ADD: operator.add,
    Operator.SUBTRACT: operator.sub,
    Operator.MULTIPLY: operator.mul,
    Operator.DIVIDE: operator.truediv,
    Operator.POWER: lambda base, exponent: float(base) ** exponent,
}


def _computed(sign: Operator, left: object, right: object) -> object:
    if sign in _COMPARED:
        texts = isinstance(left, str) and isinstance(right, str)
        return _COMPARED[sign](left, right) if texts or (_is_number(left) and _is_number(right)) else None
    if isinstance(left, str) and isinstance(right, str) and sign is Operator.ADD:
        return left + right
    if not (_is_number(left) and _is_number(right)):
        return None
    try:
        found = _COMPUTED[sign](left, right)
    except (ArithmeticError, ValueError):
        return None
    return found if _is_number(found) else None


def _is_number(value: object) -> TypeGuard[int | float]:
    return type(value) is int or (type(value) is float and isfinite(value))
