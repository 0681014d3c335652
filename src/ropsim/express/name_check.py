"""Whether a schema declares all names that it uses."""

from collections.abc import Iterator, Mapping, Sequence

from ropsim.core import did_you_mean
from ropsim.express.declarations import Entity, GlobalRule, TypeDeclaration
from ropsim.express.expressions import Binary, Call, Collection, Expression, Index, Member, Name, Query, Unary
from ropsim.express.types import AggregateType, EnumerationType, NamedType, SelectType, Underlying

Found = tuple[str, str]
"""The declaration with an error, and the error."""


def unknown_names(
    types: Mapping[str, TypeDeclaration], entities: Mapping[str, Entity], rules: Sequence[GlobalRule]
) -> tuple[Found, ...]:
    """Return the errors in names of declarations; names in rules are checked last."""
    missing = tuple(_missing(types, entities, rules)) or tuple(_circles(types, entities))
    return missing or tuple(_unknown_in_rules(types, entities, rules))


def _missing(
    types: Mapping[str, TypeDeclaration], entities: Mapping[str, Entity], rules: Sequence[GlobalRule]
) -> Iterator[Found]:
    both = (*types, *entities)
    for type_ in types.values():
        yield from ((type_.name, fault) for fault in _unknown(_named(type_.underlying), both))
    for entity in entities.values():
        wanted = [*entity.supertypes, *(name for group in entity.one_of for name in group)]
        wanted += [inverse.entity for inverse in entity.inverses]
        yield from ((entity.name, fault) for fault in _unknown(wanted, tuple(entities)))
        named = [name for attribute in entity.attributes for name in _named(attribute.type)]
        yield from ((entity.name, fault) for fault in _unknown(named, both))
    for one in rules:
        yield from ((one.name, fault) for fault in _unknown(one.entities, tuple(entities)))


def _unknown(names: Sequence[str], known: Sequence[str]) -> Iterator[str]:
    for name in names:
        if name not in known:
            yield f"`{name}` is not declared{did_you_mean(name, known)}"


def _named(type_: Underlying) -> tuple[str, ...]:
    match type_:
        case NamedType(name):
            return (name,)
        case AggregateType():
            return _named(type_.element)
        case SelectType(choices):
            return choices
        case _:
            return ()


def _circles(types: Mapping[str, TypeDeclaration], entities: Mapping[str, Entity]) -> Iterator[Found]:
    above = {name: entity.supertypes for name, entity in entities.items()}
    made_of = {name: _named(one.underlying) for name, one in types.items()}
    graphs: tuple[Mapping[str, tuple[str, ...]], ...] = (above, made_of)
    for graph in graphs:
        for name in graph:
            seen: set[str] = set()
            waiting = list(graph[name])
            while waiting:
                other = waiting.pop()
                if other == name:
                    yield name, f"`{name}` is made of itself"
                    return
                if other not in seen:
                    seen.add(other)
                    waiting += graph.get(other, ())


def _unknown_in_rules(
    types: Mapping[str, TypeDeclaration], entities: Mapping[str, Entity], rules: Sequence[GlobalRule]
) -> Iterator[Found]:
    items = {
        item
        for one in types.values()
        if isinstance(one.underlying, EnumerationType)
        for item in one.underlying.items
    }
    for type_ in types.values():
        for where in type_.rules:
            yield from ((type_.name, fault) for fault in _in_expression(where.condition, items))
    for entity in entities.values():
        known = items | _attributes(entity.name, entities)
        expressions = [rule.condition for rule in entity.rules]
        expressions += [derived.expression for derived in entity.derived]
        expressions += [one for unique in entity.uniques for one in unique.attributes]
        for expression in expressions:
            yield from ((entity.name, fault) for fault in _in_expression(expression, known))
    for declared in rules:
        known = items | set(declared.entities)
        for where in declared.rules:
            yield from ((declared.name, fault) for fault in _in_expression(where.condition, known))


def _attributes(name: str, entities: Mapping[str, Entity]) -> set[str]:
    entity = entities[name]
    own = {one.name for one in entity.attributes} | {one.name for one in entity.derived}
    own |= {one.name for one in entity.inverses}
    return own.union(*(_attributes(one, entities) for one in entity.supertypes))


def _in_expression(expression: Expression, known: set[str]) -> Iterator[str]:
    match expression:
        case Name(name):
            if name not in known:
                yield f"`{name}` is not declared{did_you_mean(name, sorted(known))}"
        case Query(variable, source, condition):
            yield from _in_expression(source, known)
            yield from _in_expression(condition, known | {variable})
        case Member(source=source):
            yield from _in_expression(source, known)
        case Index(source, index):
            yield from _in_expression(source, known)
            yield from _in_expression(index, known)
        case Unary(operand=operand):
            yield from _in_expression(operand, known)
        case Binary(left=left, right=right):
            yield from _in_expression(left, known)
            yield from _in_expression(right, known)
        case Call(arguments=items) | Collection(items):
            for item in items:
                yield from _in_expression(item, known)
        case _:
            pass
