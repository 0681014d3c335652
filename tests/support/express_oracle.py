"""Another reader of EXPRESS, and what it sees of a schema beside what our own reader does."""

import express_schema.parse as oracle

from ropsim.express import Schema

Seen = dict[str, tuple[int, int, int, list[str]]]
"""Of each entity the numbers of attributes, derived attributes and uniqueness rules, and names of rules."""


def seen_by_another_reader(text: str) -> Seen:
    """Return what another reader sees of the entities of a schema that it reads without errors."""
    other, errors = oracle.parse(text)
    assert errors is None
    assert other is not None
    return {
        entity.identifier: (
            sum(len(clause.attributes) for clause in entity.explicit_clauses),
            sum(len(clause.derived_attributes) for clause in entity.derive_clauses),
            len(entity.unique_rules),
            [rule.label for rule in entity.domain_rules],
        )
        for entity in other.entity_declarations
    }


def seen_by_ours(schema: Schema) -> Seen:
    """Return what our own reader has of them."""
    return {
        name: (
            len(entity.attributes),
            len(entity.derived),
            len(entity.uniques),
            [rule.label for rule in entity.rules],
        )
        for name, entity in schema.entities.items()
    }
