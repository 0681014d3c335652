"""Read the type of an attribute or the underlying type of a declared type."""

from ropsim.express.scanner import Scanner, TokenKind
from ropsim.express.types import (
    AggregateKind,
    AggregateType,
    EnumerationType,
    NamedType,
    SelectType,
    SimpleType,
    Underlying,
    ValueType,
)

_DEEPEST = 8
_SIMPLE = {one.value: one for one in SimpleType}
_AGGREGATES = {one.value: one for one in AggregateKind}


def read_underlying(scanner: Scanner) -> Underlying:
    """Return the underlying type of a declared type.

    Raises:
        SchemaProblemError: something else comes next.
    """
    if scanner.took("enumeration"):
        scanner.need("of")
        return EnumerationType(scanner.words("an item"))
    if scanner.took("select"):
        return SelectType(scanner.words("an entity or a type"))
    return read_type(scanner)


def read_type(scanner: Scanner, depth: int = 0) -> ValueType:
    """Return the type of an attribute.

    Raises:
        SchemaProblemError: something else comes next.
    """
    word = scanner.word("a type")
    if word in _SIMPLE:
        return _SIMPLE[word]
    if word not in _AGGREGATES:
        return NamedType(word)
    if depth > _DEEPEST:
        raise scanner.problem(f"at most {_DEEPEST} aggregates in each other")
    lower, upper = read_bounds(scanner)
    scanner.need("of")
    unique = scanner.took("unique")
    return AggregateType(_AGGREGATES[word], lower, upper, read_type(scanner, depth + 1), unique)


def read_bounds(scanner: Scanner) -> tuple[int, int | None]:
    """Return least and greatest number of elements; without brackets any number.

    Raises:
        SchemaProblemError: the bounds are not two numbers, or a number and `?`.
    """
    if not scanner.took("["):
        return 0, None
    lower = _number(scanner)
    scanner.need(":")
    upper = None if scanner.took("?") else _number(scanner)
    scanner.need("]")
    return lower, upper


def _number(scanner: Scanner) -> int:
    if scanner.token.kind is not TokenKind.INTEGER or len(scanner.token.text) > 9:
        raise scanner.problem("a number")
    return int(scanner.take().text)
