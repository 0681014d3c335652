"""Read a schema of ISO 10303-11."""

from ropsim.core import Diagnostic, Places, SourceText, places_of
from ropsim.express.declarations import Entity, GlobalRule, TypeDeclaration
from ropsim.express.diagnostics import UNKNOWN_NAME
from ropsim.express.entity_reader import read_entity, read_where
from ropsim.express.name_check import unknown_names
from ropsim.express.scanner import Scanner, SchemaProblemError
from ropsim.express.schema import Schema
from ropsim.express.type_reader import read_underlying


def read_schema(source: SourceText) -> tuple[Schema | None, tuple[Diagnostic, ...]]:
    """Return the schema of a text, and its errors; None if there are any.

    Args:
        source: the text.
    """
    places = places_of(source)
    reading = _Reading(places)
    try:
        reading.read()
    except SchemaProblemError as problem:
        return None, (problem.finding,)
    findings = [
        UNKNOWN_NAME.at(places.span(reading.offsets.get(where, 0), len(where)), message)
        for where, message in (
            *reading.twice,
            *unknown_names(reading.types, reading.entities, reading.rules),
        )
    ]
    if findings:
        return None, tuple(findings)
    return Schema(reading.name, reading.types, reading.entities, tuple(reading.rules)), ()


class _Reading:
    """One text while it is read."""

    def __init__(self, places: Places) -> None:
        self._scanner = Scanner(places)
        self.name = ""
        self.types: dict[str, TypeDeclaration] = {}
        self.entities: dict[str, Entity] = {}
        self.rules: list[GlobalRule] = []
        self.offsets: dict[str, int] = {}
        self.twice: list[tuple[str, str]] = []

    def read(self) -> None:
        scanner = self._scanner
        scanner.need("schema")
        self.name = scanner.word("the name of the schema")
        scanner.need(";")
        while not scanner.took("end_schema"):
            kind = scanner.word("TYPE, ENTITY, RULE or END_SCHEMA")
            name, offset = scanner.token.text, scanner.token.offset
            if name in self.offsets:
                self.twice.append((name, f"`{name}` is declared twice, allowed is once"))
            self.offsets[name] = offset
            if kind == "entity":
                self.entities[name] = read_entity(scanner)
            elif kind == "type":
                self.types[name] = self._type()
            elif kind == "rule":
                self.rules.append(self._rule())
            else:
                raise scanner.problem(f"TYPE, ENTITY, RULE or END_SCHEMA instead of `{kind}` before this")
        scanner.need(";")

    def _type(self) -> TypeDeclaration:
        scanner = self._scanner
        name = scanner.word("the name of a type")
        scanner.need("=")
        underlying = read_underlying(scanner)
        scanner.need(";")
        rules = read_where(scanner, "end_type")
        scanner.need("end_type", ";")
        return TypeDeclaration(name, underlying, rules)

    def _rule(self) -> GlobalRule:
        scanner = self._scanner
        name = scanner.word("the name of a rule")
        scanner.need("for")
        entities = scanner.words("an entity")
        scanner.need(";")
        rules = read_where(scanner, "end_rule")
        scanner.need("end_rule", ";")
        return GlobalRule(name, entities, rules)
