"""Read the declaration of an entity."""

from collections.abc import Callable
from typing import TypeVar

from ropsim.express.declarations import (
    Attribute,
    DerivedAttribute,
    Entity,
    InverseAttribute,
    UniqueRule,
    WhereRule,
)
from ropsim.express.expression_reader import read_expression
from ropsim.express.scanner import Scanner
from ropsim.express.type_reader import read_bounds, read_type

T = TypeVar("T")

_CLAUSES = ("derive", "inverse", "unique", "where", "end_entity")


def read_entity(scanner: Scanner) -> Entity:
    """Return the entity whose declaration goes on behind the word ENTITY.

    Raises:
        SchemaProblemError: the declaration is not complete.
    """
    name = scanner.word("the name of an entity")
    abstract = scanner.took("abstract")
    one_of = _one_of(scanner) if scanner.took("supertype") else ()
    supertypes: tuple[str, ...] = ()
    if scanner.took("subtype"):
        scanner.need("of")
        supertypes = scanner.words("an entity")
    scanner.need(";")
    attributes: list[Attribute] = []
    while not any(scanner.comes(word) for word in _CLAUSES):
        attributes += _attributes(scanner)
    derived = _clause(scanner, "derive", _derived)
    inverses = _clause(scanner, "inverse", _inverse)
    uniques = _clause(scanner, "unique", _unique)
    rules = read_where(scanner, "end_entity")
    scanner.need("end_entity", ";")
    return Entity(name, abstract, one_of, supertypes, tuple(attributes), derived, inverses, uniques, rules)


def read_where(scanner: Scanner, end: str) -> tuple[WhereRule, ...]:
    """Return the rules behind the word WHERE, if it comes next, up to a word that ends them.

    Raises:
        SchemaProblemError: a rule is not complete.
    """
    rules: list[WhereRule] = []
    if scanner.took("where"):
        while not scanner.comes(end):
            label = scanner.word("a label")
            scanner.need(":")
            rules.append(WhereRule(label, read_expression(scanner)))
            scanner.need(";")
    return tuple(rules)


def _clause(scanner: Scanner, word: str, read: Callable[[Scanner], T]) -> tuple[T, ...]:
    found: list[T] = []
    if scanner.took(word):
        while not any(scanner.comes(one) for one in _CLAUSES):
            found.append(read(scanner))
            scanner.need(";")
    return tuple(found)


def _one_of(scanner: Scanner) -> tuple[tuple[str, ...], ...]:
    """Return the groups of `SUPERTYPE OF (ONEOF (…) ANDOR ONEOF (…) ANDOR name)`."""
    groups = []
    if scanner.took("of"):
        scanner.need("(")
        while True:
            if scanner.took("oneof"):
                groups.append(scanner.words("an entity"))
            else:
                scanner.word("ONEOF or an entity")
            if not scanner.took("andor"):
                break
        scanner.need(")")
    return tuple(groups)


def _name(scanner: Scanner) -> tuple[str, str]:
    """Return the name of an attribute, and the supertype that it is declared anew for."""
    if not scanner.took("self"):
        return scanner.word("an attribute"), ""
    scanner.need("\\")
    owner = scanner.word("an entity")
    scanner.need(".")
    return scanner.word("an attribute"), owner


def _attributes(scanner: Scanner) -> list[Attribute]:
    names = [_name(scanner)]
    while scanner.took(","):
        names.append(_name(scanner))
    scanner.need(":")
    optional = scanner.took("optional")
    type_ = read_type(scanner)
    scanner.need(";")
    return [Attribute(name, type_, optional, owner) for name, owner in names]


def _derived(scanner: Scanner) -> DerivedAttribute:
    name, owner = _name(scanner)
    scanner.need(":")
    read_type(scanner)
    scanner.need(":=")
    return DerivedAttribute(name, read_expression(scanner), owner)


def _inverse(scanner: Scanner) -> InverseAttribute:
    name = scanner.word("an attribute")
    scanner.need(":")
    single = not (scanner.took("set") or scanner.took("bag"))
    lower, upper = (1, 1) if single else read_bounds(scanner)
    if not single:
        scanner.need("of")
    entity = scanner.word("an entity")
    scanner.need("for")
    return InverseAttribute(name, entity, scanner.word("an attribute"), lower, upper, single)


def _unique(scanner: Scanner) -> UniqueRule:
    label = scanner.word("a label")
    scanner.need(":")
    attributes = [read_expression(scanner)]
    while scanner.took(","):
        attributes.append(read_expression(scanner))
    return UniqueRule(label, tuple(attributes))
