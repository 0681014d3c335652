"""Expressions of ISO 10303-11 in rules and derived attributes."""

from enum import StrEnum

from ropsim.core import frozen_dataclass


class Operator(StrEnum):
    """Operator between two operands, or before one."""

    ADD = "+"
    SUBTRACT = "-"
    MULTIPLY = "*"
    DIVIDE = "/"
    POWER = "**"
    EQUAL = "="
    NOT_EQUAL = "<>"
    LESS = "<"
    LESS_EQUAL = "<="
    GREATER = ">"
    GREATER_EQUAL = ">="
    SAME = ":=:"
    NOT_SAME = ":<>:"
    IN = "in"
    AND = "and"
    OR = "or"
    XOR = "xor"
    NOT = "not"


@frozen_dataclass
class Literal:
    """A number, a text, TRUE, FALSE, or None for UNKNOWN and `?`."""

    value: int | float | str | bool | None


@frozen_dataclass
class Self:
    """The instance or the value that a rule is about."""


@frozen_dataclass
class Name:
    """An attribute of SELF, a variable, an item of an enumeration, or in a global rule all of an entity."""

    name: str


@frozen_dataclass
class Member:
    """An attribute of an instance.

    Attributes:
        source: the instance.
        name: of the attribute.
        owner: entity that declares the attribute; empty for that of the instance.
    """

    source: "Expression"
    name: str
    owner: str = ""


@frozen_dataclass
class Index:
    """An element of an aggregate, counted from 1."""

    source: "Expression"
    index: "Expression"


@frozen_dataclass
class Unary:
    """An operator and its operand."""

    operator: Operator
    operand: "Expression"


@frozen_dataclass
class Binary:
    """Two operands and the operator between them."""

    operator: Operator
    left: "Expression"
    right: "Expression"


@frozen_dataclass
class Call:
    """A function of the language, by its name in lower case, with its arguments."""

    function: str
    arguments: tuple["Expression", ...]


@frozen_dataclass
class Query:
    """The elements of an aggregate for which a condition is true.

    Attributes:
        variable: name of an element in the condition.
        source: the aggregate.
        condition: about the variable.
    """

    variable: str
    source: "Expression"
    condition: "Expression"


@frozen_dataclass
class Collection:
    """An aggregate that is written out."""

    items: tuple["Expression", ...]


Expression = Literal | Self | Name | Member | Index | Unary | Binary | Call | Query | Collection

FUNCTIONS = {"abs": 1, "exists": 1, "nvl": 2, "sizeof": 1, "sqrt": 1, "typeof": 1}
"""The functions that are understood, with the number of their arguments."""
