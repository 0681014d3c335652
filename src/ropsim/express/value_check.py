"""Whether a parameter is of the type of its attribute."""

from collections.abc import Iterator

from ropsim.core import did_you_mean
from ropsim.express.evaluation import Evaluation
from ropsim.express.population import Population, plain
from ropsim.express.types import (
    AggregateKind,
    AggregateType,
    EnumerationType,
    NamedType,
    SelectType,
    SimpleType,
    Underlying,
)
from ropsim.part21 import FALSE, TRUE, UNKNOWN, Binary, Enumeration, Reference, Typed, Value, value_text

_SHOWN = 40
_WORDS = {
    SimpleType.REAL: "a real number such as 1.5",
    SimpleType.INTEGER: "an integer",
    SimpleType.NUMBER: "a number",
    SimpleType.STRING: "a string",
    SimpleType.BOOLEAN: "`.T.` or `.F.`",
    SimpleType.LOGICAL: "`.T.`, `.F.` or `.U.`",
    SimpleType.BINARY: "a binary value",
}

Broken = tuple[str, str]
"""A rule of a type that a value breaks, as `type.label`, and the value; or None and the error."""


class ValueCheck:
    """Compares parameters of one file with types."""

    def __init__(self, population: Population, evaluation: Evaluation) -> None:
        self._population = population
        self._evaluation = evaluation

    def wrong(self, value: Value, type_: Underlying) -> Iterator[Broken]:
        """Yield the errors of a value: the first mismatch of it, or all rules of types that it breaks.

        Args:
            value: a parameter that is not absent.
            type_: of its attribute.

        Raises:
            TooMuchWorkError: from the evaluation of rules.
        """
        match type_:
            case SimpleType():
                if not _is_simple(value, type_):
                    yield "", _mismatch(value, _WORDS[type_])
            case AggregateType():
                yield from self._aggregate(value, type_)
            case EnumerationType(items):
                if not (isinstance(value, Enumeration) and value.name.lower() in items):
                    allowed = ", ".join(f"`.{item.upper()}.`" for item in items)
                    name = value.name.lower() if isinstance(value, Enumeration) else ""
                    yield "", _mismatch(value, allowed) + did_you_mean(name, items)
            case SelectType(choices):
                yield from self._selected(value, choices)
            case NamedType(name):
                yield from self._named(value, name)

    def _named(self, value: Value, name: str) -> Iterator[Broken]:
        schema = self._population.schema
        if name in schema.entities:
            if not (isinstance(value, Reference) and self._may_be(value.number, (name,))):
                yield "", self._other_instance(value, f"an instance of `{name}`")
            return
        declared = schema.types[name]
        found = list(self.wrong(value, declared.underlying))
        yield from found
        if not found:
            scope = {"self": plain(value)}
            for rule in declared.rules:
                if self._evaluation.truth(rule.condition, scope) is False:
                    yield f"{name}.{rule.label}", value_text(value)

    def _selected(self, value: Value, choices: tuple[str, ...]) -> Iterator[Broken]:
        schema = self._population.schema
        flat = tuple(_leaves(choices, schema.types))
        if isinstance(value, Reference) and self._may_be(value.number, flat):
            return
        if isinstance(value, Typed) and value.keyword.lower() in set(flat) & set(schema.types):
            yield from self._named(value.value, value.keyword.lower())
            return
        yield "", self._other_instance(value, "one of " + ", ".join(f"`{name}`" for name in flat))

    def _aggregate(self, value: Value, type_: AggregateType) -> Iterator[Broken]:
        if not isinstance(value, tuple):
            yield "", _mismatch(value, f"a {type_.kind} in parentheses")
            return
        if len(value) < type_.lower or (type_.upper is not None and len(value) > type_.upper):
            most = "more" if type_.upper is None else f"up to {type_.upper}"
            if type_.lower == type_.upper:
                yield "", f"found {len(value)} elements, allowed are {type_.lower}"
            else:
                yield "", f"found {len(value)} elements, allowed are {type_.lower} or {most}"
            return
        if (type_.unique or type_.kind is AggregateKind.SET) and len(set(value)) < len(value):
            yield "", "found one element twice, allowed is once"
            return
        for number, element in enumerate(value, start=1):
            for rule, message in self.wrong(element, type_.element):
                yield rule, message if rule else f"element {number}: {message}"
                return

    def _may_be(self, number: int, entities: tuple[str, ...]) -> bool:
        """Return whether an instance is of one of some entities; one that the schema lacks may be."""
        lineage = self._population.lineage(number)
        return not lineage or any(entity in lineage for entity in entities)

    def _other_instance(self, value: Value, allowed: str) -> str:
        if isinstance(value, Reference):
            keyword = self._population.instances[value.number].keyword
            return f"found #{value.number}, which is {keyword}, allowed is {allowed}"
        return _mismatch(value, allowed)


def _leaves(choices: tuple[str, ...], types: object) -> Iterator[str]:
    """Yield the choices of a select, including choices of nested selects."""
    for name in choices:
        declared = types.get(name) if isinstance(types, dict) else None
        if declared is not None and isinstance(declared.underlying, SelectType):
            yield from _leaves(declared.underlying.choices, types)
        else:
            yield name


def _is_simple(value: Value, type_: SimpleType) -> bool:
    match type_:
        case SimpleType.REAL:
            return isinstance(value, float)
        case SimpleType.INTEGER:
            return isinstance(value, int)
        case SimpleType.NUMBER:
            return isinstance(value, int | float)
        case SimpleType.STRING:
            return isinstance(value, str)
        case SimpleType.BOOLEAN:
            return value in (TRUE, FALSE)
        case SimpleType.LOGICAL:
            return value in (TRUE, FALSE, UNKNOWN)
        case SimpleType.BINARY:
            return isinstance(value, Binary)


def _mismatch(value: Value, allowed: str) -> str:
    text = value_text(value)
    return f"found {text[:_SHOWN]}{'…' if len(text) > _SHOWN else ''}, allowed is {allowed}"
