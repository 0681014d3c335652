"""An exchange file after ROPSIM_CONTROL_V1 to a diagram."""

from enum import StrEnum
from typing import TypeVar

from ropsim.blockdiagram.blocks import Block
from ropsim.blockdiagram.checks.check import MOST, faults_of
from ropsim.blockdiagram.checks.fault import CONTROLLER, Part
from ropsim.blockdiagram.diagnostics import NOT_A_DIAGRAM, WRONG_WIRING
from ropsim.blockdiagram.diagram import Diagram, Link, OutputKind
from ropsim.blockdiagram.fields import FieldKind, Kind
from ropsim.blockdiagram.forms import FORM_OF_ENTITY
from ropsim.blockdiagram.schema_text import NAME, control_schema
from ropsim.blockdiagram.signals import Role, Signal, Unit
from ropsim.core import Diagnostic, SourceText, Span, did_you_mean, frozen_dataclass
from ropsim.express import Population, plain, validate
from ropsim.part21 import Enumeration, ExchangeFile, Reference, read_exchange, references

T = TypeVar("T", bound=StrEnum)


@frozen_dataclass
class ReadDiagram:
    """A diagram read from a file.

    Attributes:
        diagram: that is right; None where an error forbids one.
        findings: in the order of the file.
    """

    diagram: Diagram | None
    findings: tuple[Diagnostic, ...]


def read_diagram(source: SourceText) -> ReadDiagram:
    """Return the controller that a file describes, checked against the schema and as a diagram.

    Args:
        source: content of the file; any text is allowed.
    """
    file, findings = read_exchange(source)
    if any(one.is_error for one in findings):
        return ReadDiagram(None, findings)
    if NAME not in file.schemas:
        return ReadDiagram(None, (_other_schema(file),))
    population = Population(control_schema(), file)
    strange = _strange(population)
    if strange is not None:
        return ReadDiagram(None, (*findings, strange))
    found = (*findings, *validate(population))
    if any(one.is_error for one in found):
        return ReadDiagram(None, found[:MOST])
    reading = _Reading(population)
    diagram = reading.diagram()
    faults = tuple(one.finding(reading.span(one.part)) for one in faults_of(diagram)) or reading.left_over()
    return ReadDiagram(diagram if not faults else None, (*found, *faults)[:MOST])


def _other_schema(file: ExchangeFile) -> Diagnostic:
    names = ", ".join(f"`{one[:60]}`" for one in file.schemas[:6]) or "none"
    span = file.places.span(0) if file.places else None
    message = f"the schema of the file is {names}, allowed is `{NAME}`"
    return NOT_A_DIAGRAM.at(span, message, hint="see docs/reference/controller-file.md")


def _strange(population: Population) -> Diagnostic | None:
    """Return a finding where an instance refers to one of an entity that the schema does not have."""
    for number, instance in population.instances.items():
        values = [value for record in instance.records for value in record.values]
        for wrong in references(tuple(values)) if population.lineage(number) else ():
            if not population.lineage(wrong):
                keyword = population.instances[wrong].keyword[:60]
                message = f"#{number} refers to #{wrong}, which is of `{keyword}`: there is no such entity"
                hint = (
                    did_you_mean(keyword.lower(), FORM_OF_ENTITY) or "see docs/reference/controller-file.md"
                )
                return WRONG_WIRING.at(population.file.span(instance), message, hint=hint)
    return None


class _Reading:
    """A file that keeps to the schema."""

    def __init__(self, population: Population) -> None:
        self._population = population
        self._controller = population.extent("controller")[0]
        listed = ("signals", "blocks", "links")
        self._parts = {name: self._references(self._controller, name) for name in listed}

    def left_over(self) -> tuple[Diagnostic, ...]:
        """Return a finding for each signal, block or link that is in no list of the controller."""
        found = []
        for entity, name in (("signal", "signals"), ("block", "blocks"), ("link", "links")):
            for number in self._population.extent(entity):
                if number not in self._parts[name]:
                    instance = self._population.instances[number]
                    message = f"#{number} {instance.keyword} is not among the {name} of the controller"
                    span = self._population.file.span(instance)
                    found.append(WRONG_WIRING.at(span, message, hint="add it to the list, or take it out"))
        return tuple(found)

    def span(self, part: Part) -> Span | None:
        """Return where a part of the diagram stands."""
        number = self._controller if part == CONTROLLER else self._parts[f"{part[0]}s"][part[1]]
        return self._population.file.span(self._population.instances[number])

    def diagram(self) -> Diagram:
        """Return the controller as it stands there, unchecked."""
        controller = self._controller
        holding = self._value(controller, "holding")
        period = self._value(controller, "period")
        delay = self._value(controller, "delay")
        return Diagram(
            name=self._text(controller, "name"),
            period=period if isinstance(period, float) else 0.0,
            signals=tuple(map(self._signal, self._parts["signals"])),
            blocks=tuple(map(self._block, self._parts["blocks"])),
            output_kind=_member(OutputKind, self._value(controller, "puts_out")),
            links=tuple(map(self._link, self._parts["links"])),
            holding=self._text(holding.number, "name") if isinstance(holding, Reference) else "",
            delay=delay if isinstance(delay, int) else 0,
            arm=self._text(controller, "arm"),
            description=self._text(controller, "description"),
        )

    def _signal(self, number: int) -> Signal:
        size, units = self._value(number, "size"), self._value(number, "units")
        return Signal(
            self._text(number, "name"),
            size if isinstance(size, int) else 0,
            tuple(_member(Unit, one) for one in (units if isinstance(units, tuple) else ())),
            _member(Role, self._value(number, "role")),
            self._text(number, "channel"),
        )

    def _block(self, number: int) -> Block:
        form = FORM_OF_ENTITY[self._population.lineage(number)[-1]]
        values = self._population.instances[number].records[0].values
        names = tuple(self._name_of(one) for one in self._references(number, "inputs"))
        own = (_field(plain(value), kind) for value, (_, kind) in zip(values[3:], form.fields, strict=True))
        (output,) = self._references(number, "output")
        return form.block(self._text(number, "name"), names, self._name_of(output), *own)

    def _link(self, number: int) -> Link:
        ends = [self._name_of(self._references(number, name)[0]) for name in ("source", "target")]
        numbers = [self._value(number, name) for name in ("source_first", "target_first", "count")]
        source, target, count = (one if isinstance(one, int) else 0 for one in numbers)
        return Link(ends[0], source - 1, ends[1], target - 1, count)

    def _references(self, number: int, name: str) -> list[int]:
        value = self._population.value(number, name)
        every = value if isinstance(value, tuple) else (value,)
        return [one.number for one in every if isinstance(one, Reference)]

    def _name_of(self, number: int) -> str:
        return self._text(number, "name")

    def _text(self, number: int, name: str) -> str:
        value = self._value(number, name)
        return value if isinstance(value, str) else ""

    def _value(self, number: int, name: str) -> object:
        return plain(self._population.value(number, name))


def _field(value: object, kind: Kind) -> object:
    """Return a parameter as the field of a block."""
    if isinstance(kind, type):
        return _member(kind, value)
    if kind is FieldKind.MATRIX:
        return tuple(
            row if isinstance(row, tuple) else () for row in (value if isinstance(value, tuple) else ())
        )
    if kind in (FieldKind.REALS, FieldKind.OPTIONAL_REALS, FieldKind.INTEGERS):
        return value if isinstance(value, tuple) else ()
    return value


def _member(kind: type[T], value: object) -> T:
    """Return the item of an enumeration; the schema has the same ones."""
    return kind(value.name.lower()) if isinstance(value, Enumeration) else next(iter(kind))
