"""A schema of ISO 10303-11 and its derived tables."""

from collections.abc import Mapping
from dataclasses import field
from typing import NamedTuple

from ropsim.core import frozen_without_equality
from ropsim.express.declarations import Attribute, DerivedAttribute, Entity, GlobalRule, TypeDeclaration
from ropsim.express.types import EnumerationType


class Parameter(NamedTuple):
    """A parameter of an instance: which attribute, where it was declared, and whether it is `*`."""

    owner: str
    attribute: Attribute
    derived: bool


@frozen_without_equality
class Schema:
    """A schema; names are in lower case.

    Attributes:
        name: of the schema.
        types: declared types by name.
        entities: by name; supertypes go in no circle.
        rules: global ones.
        lineages: of each entity its supertypes, each once and before its subtypes, and itself at the end.
        parameters: parameters of an instance in an exchange file, by entity, in order.
        derivations: derived attributes of each entity, by the entity that declares the attribute, and its
            name.
    """

    name: str
    types: Mapping[str, TypeDeclaration]
    entities: Mapping[str, Entity]
    rules: tuple[GlobalRule, ...]
    lineages: Mapping[str, tuple[str, ...]] = field(init=False)
    parameters: Mapping[str, tuple[Parameter, ...]] = field(init=False)
    derivations: Mapping[str, Mapping[tuple[str, str], DerivedAttribute]] = field(init=False)

    def __post_init__(self) -> None:
        lineages: dict[str, tuple[str, ...]] = {}
        for name in self.entities:
            _lineage(name, self.entities, lineages)
        object.__setattr__(self, "lineages", lineages)
        derivations = {name: self.derivations_of(lineage) for name, lineage in lineages.items()}
        object.__setattr__(self, "derivations", derivations)
        found = {name: tuple(self._parameters(name)) for name in self.entities}
        object.__setattr__(self, "parameters", found)

    def is_a(self, entity: str, other: str) -> bool:
        """Return whether an entity is another one or a subtype of it."""
        return other in self.lineages[entity]

    @property
    def items(self) -> frozenset[str]:
        """Return the items of all enumerations."""
        return frozenset(
            item
            for one in self.types.values()
            if isinstance(one.underlying, EnumerationType)
            for item in one.underlying.items
        )

    def derivations_of(self, lineage: tuple[str, ...]) -> dict[tuple[str, str], DerivedAttribute]:
        """Return the derived attributes of instances of some entities; later ones go first."""
        return {
            (derived.redeclares or entity, derived.name): derived
            for entity in lineage
            for derived in self.entities[entity].derived
        }

    def own_parameters(self, entity: str, lineage: tuple[str, ...]) -> list[Parameter]:
        """Return the parameters that an entity declares itself, for instances of some entities."""
        derivations = self.derivations_of(lineage)
        narrowed = {
            (attribute.redeclares, attribute.name): attribute
            for one in lineage
            for attribute in self.entities[one].attributes
        }
        return [
            Parameter(
                entity,
                narrowed.get((entity, attribute.name), attribute),
                (entity, attribute.name) in derivations,
            )
            for attribute in self.entities[entity].attributes
            if not attribute.redeclares
        ]

    def _parameters(self, entity: str) -> list[Parameter]:
        lineage = self.lineages[entity]
        return [one for owner in lineage for one in self.own_parameters(owner, lineage)]


def _lineage(name: str, entities: Mapping[str, Entity], known: dict[str, tuple[str, ...]]) -> tuple[str, ...]:
    if name not in known:
        found: dict[str, None] = {}
        for supertype in entities[name].supertypes:
            found.update(dict.fromkeys(_lineage(supertype, entities, known)))
        known[name] = (*found, name)
    return known[name]
