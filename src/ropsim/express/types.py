"""Types of values in a schema of ISO 10303-11."""

from enum import StrEnum

from ropsim.core import frozen_dataclass


class SimpleType(StrEnum):
    """A type that the language brings along."""

    REAL = "real"
    INTEGER = "integer"
    NUMBER = "number"
    STRING = "string"
    BOOLEAN = "boolean"
    LOGICAL = "logical"
    BINARY = "binary"


class AggregateKind(StrEnum):
    """Kind of an aggregate."""

    LIST = "list"
    SET = "set"
    BAG = "bag"
    ARRAY = "array"


@frozen_dataclass
class NamedType:
    """An entity or a declared type, by its name in lower case."""

    name: str


@frozen_dataclass
class AggregateType:
    """A collection of values of one type.

    Attributes:
        kind: list, set, bag or array.
        lower: least number of elements.
        upper: greatest number of elements; None for any.
        element: type of the elements.
        unique: whether no element of a list occurs twice.
    """

    kind: AggregateKind
    lower: int
    upper: int | None
    element: "ValueType"
    unique: bool = False


@frozen_dataclass
class EnumerationType:
    """One of some words.

    Attributes:
        items: the words in lower case.
    """

    items: tuple[str, ...]


@frozen_dataclass
class SelectType:
    """A value of one of some named types.

    Attributes:
        choices: names of entities and types in lower case.
    """

    choices: tuple[str, ...]


ValueType = SimpleType | NamedType | AggregateType
"""The type of an attribute."""

Underlying = ValueType | EnumerationType | SelectType
"""Underlying type of a declared type."""
