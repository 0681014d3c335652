"""Check the instances of an exchange file against a schema.

A rule that comes out as FALSE is broken; one that comes out as UNKNOWN is not, and a hint names it.
"""

from collections.abc import Iterator

from ropsim.core import Diagnostic, Kind, Severity, did_you_mean
from ropsim.express import diagnostics as kinds
from ropsim.express.declarations import WhereRule
from ropsim.express.evaluation import Evaluation, TooMuchWorkError
from ropsim.express.population import Population, layout, lineage_of
from ropsim.express.schema import Parameter
from ropsim.express.value_check import ValueCheck
from ropsim.part21 import Absent, Instance, Record, Reference, Value

MAX_FINDINGS = 50
"""Maximum number of findings of one file."""


def validate(population: Population) -> tuple[Diagnostic, ...]:
    """Return the errors in the instances of a file: up to `MAX_FINDINGS`.

    Rules are evaluated where all instances are complete and all parameters of their types.

    Args:
        population: the instances in terms of a schema; their references lead to instances of the file.
    """
    checking = _Checking(population)
    found: list[Diagnostic] = []
    try:
        for part in (checking.shapes, checking.rules):
            for finding in part():
                found.append(finding)
                if len(found) >= MAX_FINDINGS:
                    return tuple(found)
            if any(one.severity is Severity.ERROR for one in found):
                break
    except TooMuchWorkError:
        found.append(kinds.UNDECIDED.at(None, "the file is too large for its rules to be checked"))
    return tuple(found)


class _Checking:
    """One file while it is checked."""

    def __init__(self, population: Population) -> None:
        self._population = population
        self._schema = population.schema
        self._evaluation = Evaluation(population)
        self._values = ValueCheck(population, self._evaluation)
        self._undecided: set[str] = set()

    def shapes(self) -> Iterator[Diagnostic]:
        """Yield the errors in entities and parameters of instances, one by one."""
        for instance in self._population.file.instances:
            laid_out = layout(self._schema, instance)
            if laid_out is None:
                yield self._unknown(instance)
                continue
            impossible = self._impossible(instance)
            if impossible:
                yield self._at(kinds.IMPOSSIBLE_ENTITY, instance, impossible)
            for number, (record, parameters) in enumerate(laid_out):
                yield from self._parameters(instance, number, record, parameters)

    def rules(self) -> Iterator[Diagnostic]:
        """Yield the rules that do not hold: rules of instances, uniqueness, global rules."""
        for instance in self._population.file.instances:
            for entity in self._population.lineage(instance.number):
                scope = {"self": Reference(instance.number)}
                for rule in self._schema.entities[entity].rules:
                    yield from self._rule(f"{entity}.{rule.label}", rule, scope, instance)
                yield from self._inverses(instance, entity)
        for entity in self._schema.entities:
            yield from self._uniques(entity)
        for declared in self._schema.rules:
            extents = {
                name: tuple(map(Reference, self._population.extent(name))) for name in declared.entities
            }
            for rule in declared.rules:
                yield from self._rule(f"{declared.name}.{rule.label}", rule, extents, None)
        for label in sorted(self._undecided):
            yield kinds.UNDECIDED.at(None, f"the rule `{label}` could not be decided everywhere")

    def _unknown(self, instance: Instance) -> Diagnostic:
        names = [record.keyword for record in instance.records]
        name = next(one for one in names if one.lower() not in self._schema.entities)
        near = did_you_mean(name.lower(), self._schema.entities)
        message = f"#{instance.number} is of `{name}`, which {self._schema.name} does not have{near}"
        return self._at(kinds.UNKNOWN_ENTITY, instance, message)

    def _impossible(self, instance: Instance) -> str:
        """Return why an instance is impossible; empty if it is possible."""
        names = [record.keyword.lower() for record in instance.records]
        lineage = lineage_of(self._schema, instance) or ()
        number = f"#{instance.number}"
        if len(set(names)) < len(names):
            return f"{number} names an entity twice, allowed is once"
        if len(names) > 1 and set(names) != set(lineage):
            missing = ", ".join(f"`{one}`" for one in lineage if one not in names)
            return f"{number} lacks records of its supertypes {missing}"
        for entity in lineage:
            declared = self._schema.entities[entity]
            below = [one for one in lineage if entity in self._schema.entities[one].supertypes]
            if declared.abstract and not below:
                return f"{number} is of `{entity}`, allowed are its subtypes"
            for group in declared.one_of:
                chosen = [one for one in group if one in lineage]
                if len(chosen) > 1:
                    return (
                        f"{number} is of {' and '.join(f'`{one}`' for one in chosen)}, allowed is one of them"
                    )
        return ""

    def _parameters(
        self, instance: Instance, number: int, record: Record, parameters: tuple[Parameter, ...]
    ) -> Iterator[Diagnostic]:
        if len(parameters) != len(record.values):
            names = ", ".join(one.attribute.name for one in parameters) or "none"
            found, allowed = len(record.values), len(parameters)
            message = f"{record.keyword} has {found} parameters, allowed are {allowed}: {names}"
            span = self._population.file.span(instance)
            yield kinds.WRONG_COUNT.at(span, message, data={"found": found, "allowed": allowed})
            return
        for place, (parameter, value) in enumerate(zip(parameters, record.values, strict=True)):
            name = f"`{parameter.attribute.name}` of {record.keyword}"
            for rule, sentence in self._wrong(parameter, value):
                kind = kinds.RULE_BROKEN if rule else kinds.WRONG_VALUE
                broken = f"found {sentence}, which breaks the rule `{rule}`" if rule else sentence
                span = self._population.file.span(instance, number, place)
                yield kind.at(span, f"{name}: {broken}")

    def _wrong(self, parameter: Parameter, value: Value) -> Iterator[tuple[str, str]]:
        if (value is Absent.DERIVED) is not parameter.derived:
            yield (
                "",
                "allowed is `*`" if parameter.derived else "found `*`, which is for derived attributes only",
            )
        elif value is Absent.UNSET and not parameter.attribute.optional:
            yield "", "found `$`, which is for optional attributes only"
        elif not isinstance(value, Absent):
            yield from self._values.wrong(value, parameter.attribute.type)

    def _inverses(self, instance: Instance, entity: str) -> Iterator[Diagnostic]:
        for inverse in self._schema.entities[entity].inverses:
            users = self._population.users(instance.number, inverse.entity, inverse.attribute)
            found = len(users)
            if found < inverse.lower or (inverse.upper is not None and found > inverse.upper):
                allowed = f"{inverse.lower} to {'any number' if inverse.upper is None else inverse.upper}"
                sentence = (
                    f"#{instance.number}: {found} of `{inverse.entity}` refer to it, allowed are {allowed}"
                )
                yield self._at(kinds.RULE_BROKEN, instance, sentence)

    def _uniques(self, entity: str) -> Iterator[Diagnostic]:
        for unique in self._schema.entities[entity].uniques:
            seen: dict[tuple[object, ...], int] = {}
            for number in self._population.extent(entity):
                scope = {"self": Reference(number)}
                key = tuple(self._evaluation.value(one, scope) for one in unique.attributes)
                if None in key:
                    continue
                if key in seen:
                    instance = self._population.instances[number]
                    sentence = (
                        f"#{number} agrees with #{seen[key]} in what `{entity}.{unique.label}` makes unique"
                    )
                    yield self._at(kinds.NOT_UNIQUE, instance, sentence)
                seen.setdefault(key, number)

    def _rule(
        self,
        label: str,
        rule: WhereRule,
        scope: dict[str, Reference] | dict[str, tuple[Reference, ...]],
        instance: Instance | None,
    ) -> Iterator[Diagnostic]:
        truth = self._evaluation.truth(rule.condition, scope)
        if truth is None:
            self._undecided.add(label)
        if truth is False:
            kind = kinds.DOUBTFUL if rule.is_doubt else kinds.RULE_BROKEN
            who = f"#{instance.number} {instance.keyword}: " if instance else ""
            yield self._at(kind, instance, f"{who}the rule `{label}` does not hold")

    def _at(self, kind: Kind, instance: Instance | None, message: str) -> Diagnostic:
        return kind.at(self._population.file.span(instance) if instance else None, message)
