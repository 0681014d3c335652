"""A diagram to an exchange file after ROPSIM_CONTROL_V1."""

from enum import StrEnum

from ropsim.blockdiagram.blocks import Block
from ropsim.blockdiagram.checks.check import check_diagram
from ropsim.blockdiagram.diagnostics import NOT_WRITTEN, DiagramError
from ropsim.blockdiagram.diagram import Diagram, Link
from ropsim.blockdiagram.fields import FieldKind, Kind
from ropsim.blockdiagram.forms import FORM_OF
from ropsim.blockdiagram.schema_text import NAME, control_schema
from ropsim.blockdiagram.signals import Signal
from ropsim.express import Population, validate
from ropsim.part21 import (
    Absent,
    Enumeration,
    ExchangeFile,
    Instance,
    Record,
    Reference,
    Value,
    write_exchange,
)
from ropsim.version import __version__

_FIRST_SIGNAL = 2


def write_diagram(diagram: Diagram) -> str:
    """Return the exchange file of a diagram in its one canonical form; read again it is the same diagram.

    Raises:
        DiagramError: C621 to C625, C627: it is wrong, or cannot be written.
    """
    check_diagram(diagram)
    file = ExchangeFile(_header(diagram), _instances(diagram))
    try:
        text = write_exchange(file)
    except ValueError as error:
        raise DiagramError(NOT_WRITTEN.at(None, str(error))) from error
    wrong = [one for one in validate(Population(control_schema(), file)) if one.is_error]
    if wrong:
        raise DiagramError(NOT_WRITTEN.at(None, wrong[0].message))
    return text


def _header(diagram: Diagram) -> tuple[Record, ...]:
    return (
        Record("FILE_DESCRIPTION", (("joint controller",), "2;1")),
        Record("FILE_NAME", (diagram.name, "", ("",), ("",), "ropsim", f"ropsim {__version__}", "")),
        Record("FILE_SCHEMA", ((NAME,),)),
    )


def _instances(diagram: Diagram) -> tuple[Instance, ...]:
    signals = {one.name: _FIRST_SIGNAL + k for k, one in enumerate(diagram.signals)}
    first_block = _FIRST_SIGNAL + len(signals)
    blocks = {one.name: first_block + k for k, one in enumerate(diagram.blocks)}
    first_link = first_block + len(blocks)
    links = [Reference(first_link + k) for k in range(len(diagram.links))]
    controller = (
        *(diagram.name, diagram.description or Absent.UNSET, diagram.arm or Absent.UNSET, diagram.period),
        *(_item(diagram.output_kind), diagram.delay),
        tuple(map(Reference, signals.values())),
        tuple(map(Reference, blocks.values())),
        tuple(links),
        Reference(blocks[diagram.holding]) if diagram.holding else Absent.UNSET,
    )
    made = [Instance(1, (Record("CONTROLLER", controller),))]
    made += [Instance(signals[one.name], (_signal(one),)) for one in diagram.signals]
    made += [Instance(blocks[one.name], (_block(one, signals),)) for one in diagram.blocks]
    made += [
        Instance(place.number, (_link(one, signals),))
        for place, one in zip(links, diagram.links, strict=True)
    ]
    return tuple(made)


def _signal(signal: Signal) -> Record:
    units = tuple(map(_item, signal.units))
    values = (signal.name, signal.size, units, _item(signal.role), signal.channel or Absent.UNSET)
    return Record("SIGNAL", values)


def _block(block: Block, signals: dict[str, int]) -> Record:
    form = FORM_OF[type(block)]
    inputs = tuple(Reference(signals[name]) for name in block.inputs)
    own = (_value(getattr(block, name), kind) for name, kind in form.fields)
    return Record(form.entity.upper(), (block.name, inputs, Reference(signals[block.output]), *own))


def _link(link: Link, signals: dict[str, int]) -> Record:
    source = Reference(signals[link.source]), link.source_first + 1
    return Record("LINK", (*source, Reference(signals[link.target]), link.target_first + 1, link.count))


def _value(value: object, kind: Kind) -> Value:
    match kind, value:
        case FieldKind.OPTIONAL_REALS, ():
            return Absent.UNSET
        case ((FieldKind.REALS | FieldKind.OPTIONAL_REALS), tuple()):
            return tuple(map(float, value))
        case FieldKind.MATRIX, tuple():
            return tuple(tuple(map(float, row)) for row in value)
        case FieldKind.INTEGERS, tuple():
            return tuple(map(int, value))
        case FieldKind.REAL, int() | float():
            return float(value)
        case FieldKind.INTEGER, int():
            return value
        case _, StrEnum():
            return _item(value)
        case _:
            raise DiagramError(NOT_WRITTEN.at(None, f"a field of a block holds `{value}`"))


def _item(value: StrEnum) -> Enumeration:
    return Enumeration(value.value.upper())
