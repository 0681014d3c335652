"""The instances of an exchange file as a schema sees them: their entities and attributes."""

from collections.abc import Mapping

from ropsim.express.declarations import DerivedAttribute
from ropsim.express.schema import Parameter, Schema
from ropsim.part21 import (
    FALSE,
    TRUE,
    Absent,
    Enumeration,
    ExchangeFile,
    Instance,
    Record,
    Typed,
    Value,
    references,
)

Lineage = tuple[str, ...]


class Population:
    """Instances with their attributes; instances that do not fit the schema are omitted.

    Attributes:
        schema: in whose terms.
        file: from which they come.
        instances: all of the file, by number.
    """

    def __init__(self, schema: Schema, file: ExchangeFile) -> None:
        self.schema = schema
        self.file = file
        self.instances: Mapping[int, Instance] = {one.number: one for one in file.instances}
        self._lineages: dict[int, Lineage] = {}
        self._fields: dict[int, dict[tuple[str, str], Value]] = {}
        self._values: dict[int, dict[str, Value | None]] = {}
        self._extents: dict[str, list[int]] = {name: [] for name in schema.entities}
        self._users: dict[tuple[str, str], dict[int, tuple[int, ...]]] = {}
        for instance in file.instances:
            self._lay_out(instance)

    def _lay_out(self, instance: Instance) -> None:
        lineage = lineage_of(self.schema, instance)
        laid_out = layout(self.schema, instance)
        if lineage is None or laid_out is None:
            return
        self._lineages[instance.number] = lineage
        fields: dict[tuple[str, str], Value] = {}
        for record, parameters in laid_out:
            for parameter, value in zip(parameters, record.values, strict=False):
                fields[parameter.owner, parameter.attribute.name] = value
        self._fields[instance.number] = fields
        self._values[instance.number] = _first_values(fields, lineage)
        for entity in lineage:
            self._extents[entity].append(instance.number)

    def lineage(self, number: int) -> Lineage:
        """Return the entities of an instance, supertypes first; empty if the schema lacks them."""
        return self._lineages.get(number, ())

    def derivations(self, number: int) -> Mapping[tuple[str, str], DerivedAttribute]:
        """Return the derived attributes of an instance, by declaring entity and name."""
        lineage = self._lineages[number]
        if self.schema.lineages[lineage[-1]] == lineage:
            return self.schema.derivations[lineage[-1]]
        return self.schema.derivations_of(lineage)

    def is_a(self, number: int, entity: str) -> bool:
        """Return whether an instance is of an entity or of a subtype of it."""
        return entity in self._lineages.get(number, ())

    def extent(self, entity: str) -> list[int]:
        """Return the instances of an entity and its subtypes, in the order of the file."""
        return self._extents[entity]

    def explicit(self, number: int, owner: str, name: str) -> Value | None:
        """Return a parameter by the entity that declares it and its name; None where there is none."""
        value = self._fields[number].get((owner, name))
        return None if isinstance(value, Absent) else value

    def value(self, number: int, name: str) -> Value | None:
        """Return an explicit attribute by its name; where several entities declare it, that of the first.

        Args:
            number: of an instance with a lineage.
            name: of the attribute, in lower case.
        """
        return self._values[number].get(name) if number in self._values else None

    def users(self, number: int, entity: str, attribute: str) -> tuple[int, ...]:
        """Return the instances of an entity that refer to one by an attribute, in the order of the file."""
        if (entity, attribute) not in self._users:
            self._users[entity, attribute] = self._index(entity, attribute)
        return self._users[entity, attribute].get(number, ())

    def _index(self, entity: str, attribute: str) -> dict[int, tuple[int, ...]]:
        found: dict[int, dict[int, None]] = {}
        for user in self._extents[entity]:
            value = self.value(user, attribute)
            for number in references((value,)) if value is not None else ():
                found.setdefault(number, {})[user] = None
        return {number: tuple(users) for number, users in found.items()}


def _first_values(fields: Mapping[tuple[str, str], Value], lineage: Lineage) -> dict[str, Value | None]:
    """Return the attributes of an instance by name alone, of several of one name that of the first entity."""
    found: dict[str, Value | None] = {}
    for (_, name), value in sorted(fields.items(), key=lambda one: lineage.index(one[0][0])):
        found.setdefault(name, None if isinstance(value, Absent) else value)
    return found


def lineage_of(schema: Schema, instance: Instance) -> Lineage | None:
    """Return the entities that an instance is of, supertypes first; None where the schema lacks one."""
    if len(instance.records) == 1:
        return schema.lineages.get(instance.records[0].keyword.lower())
    names = [record.keyword.lower() for record in instance.records]
    if any(name not in schema.entities for name in names):
        return None
    return tuple(dict.fromkeys(one for name in names for one in schema.lineages[name]))


def layout(schema: Schema, instance: Instance) -> tuple[tuple[Record, tuple[Parameter, ...]], ...] | None:
    """Return the records of an instance with the parameters that each of them has to have.

    A simple instance has all parameters in one record, a complex one the parameters of each entity in a
    separate record. None where the schema lacks one of its entities.
    """
    lineage = lineage_of(schema, instance)
    if lineage is None:
        return None
    if len(instance.records) == 1:
        record = instance.records[0]
        return ((record, schema.parameters[record.keyword.lower()]),)
    return tuple(
        (record, tuple(schema.own_parameters(record.keyword.lower(), lineage))) for record in instance.records
    )


def plain(value: Value | None) -> object:
    """Return the value of a parameter in an expression: without its type's name, logical values as such.

    Args:
        value: None and parameters without a value are None, as UNKNOWN is.
    """
    while isinstance(value, Typed):
        value = value.value
    if isinstance(value, Enumeration):
        return {TRUE: True, FALSE: False}.get(value, None if value.name == "U" else value)
    return None if isinstance(value, Absent) else value
