"""The key `part` of tools, objects and devices in a cell file: a part of the library."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from ropsim import parts
from ropsim.core import Severity, define, frozen_dataclass
from ropsim.model import Payload, Shape
from ropsim.parts import CONFLICTING_MEASURES, LibraryPart, Measure, Parameter, PartKind, Use, Values
from ropsim.spatial import Pose
from ropsim.tomltext import (
    MASS,
    TIME,
    Look,
    Quantity,
    Question,
    Sort,
    TomlTable,
    Units,
    read_kind,
    read_look,
    read_pose,
    read_shapes,
)

PART_OF_ANOTHER_USE = define(
    "X923",
    "part-of-another-use",
    Severity.ERROR,
    "a library part stands in a table of the cell file that it is not for",
    """
Each kind of part is for one table: what an arm carries for `[tools.NAME]`, what stands still for
`[[objects]]`, conveyors and turntables for `[devices.NAME]` of the kinds `conveyor` and `turntable`.
`ropsim part list` prints the kinds with their use.

```toml
[tools.jaws]
part = { kind = "eur_pallet" }              # wrong
part = { kind = "two_finger_gripper" }      # right
```
""",
)

_WORDS: Mapping[Use, str] = MappingProxyType(
    {
        Use.TOOL: "a tool",
        Use.OBJECT: "an object",
        Use.CONVEYOR: "a device of the kind `conveyor`",
        Use.TURNTABLE: "a device of the kind `turntable`",
    }
)


@frozen_dataclass
class GivenPart:
    """A library part as a cell file describes it.

    Attributes:
        part: the finished part.
        values: parameters that it is made from [SI].
    """

    part: LibraryPart
    values: Values


def read_part(table: TomlTable, units: Units, use: Use) -> GivenPart | None:
    """Return the library part of the key `part`; None where the key is absent or its kind is wrong.

    A tool may be mounted at a pose in the mechanical interface frame, in front of an adapter.

    Args:
        table: of a tool, an object or a device.
        units: of the file.
        use: table that it is.
    """
    inner = table.table("part")
    if not inner.present:
        return None
    kind = _kind(inner, use)
    if kind is None:
        return None
    noted = len(inner.findings.items)
    product = None
    if kind.products:
        names = tuple(one.name for one in kind.products)
        inner.ask("model", Question(Sort.TEXT, choices=names))
        product = kind.product(inner.choice("model", names, "")) if "model" in inner else None
    values = kind.defaults(product)
    for parameter in kind.parameters:
        value = _value(inner, parameter, values.get(parameter.name), units)
        if value is not None:
            values[parameter.name] = value
    if len(inner.findings.items) == noted:
        _note_conflict(inner, kind, values, units)
    X_MP = read_pose(inner, units) if use is Use.TOOL else Pose()
    inner.finish()
    fits = kind.conflict(values) is None
    return GivenPart(parts.mounted(kind.make(values if fits else kind.defaults()), X_MP), values)


def read_painted(table: TomlTable, units: Units, part: LibraryPart) -> tuple[Shape, ...]:
    """Return the shapes of a tool or object with a library part: the key `shapes`, or those of the part.

    The keys `colour`, `opacity` and `material` hold for shapes without their own, and for those of the part
    that have its main colour.
    """
    if "shapes" in table:
        return read_shapes(table, units, read_look(table, Look()))
    return painted(table, part.shapes, part.colour)


def painted(table: TomlTable, shapes: Sequence[Shape], main: str) -> tuple[Shape, ...]:
    """Return shapes in which those of the colour `main` have the look of a table, where it gives one."""
    look = read_look(table, Look(main))
    keys = {key for key in ("opacity", "material") if key in table}
    return tuple(
        replace(
            shape,
            colour=look.colour,
            opacity=look.opacity if "opacity" in keys else shape.opacity,
            material=look.material if "material" in keys else shape.material,
        )
        if shape.colour == main
        else shape
        for shape in shapes
    )


def placed(table: TomlTable, given: Pose, own: Pose | None) -> Pose:
    """Return a pose of a table, completed by the own pose of a part where it gives no position or no turn."""
    if own is None:
        return given
    turned = "rpy" in table or "quaternion" in table
    return Pose(
        given.position if "position" in table else own.position,
        given.orientation if turned else own.orientation,
    )


def reweighed(load: Payload, mass: float) -> Payload:
    """Return a body of another mass [kg] that is distributed as before."""
    share = mass / load.mass if load.mass else 0.0
    return Payload(mass, load.com, share * load.inertia)


def _kind(inner: TomlTable, use: Use) -> PartKind | None:
    """Return the kind of part; a wrong one is noted."""
    known = {kind.name: kind for kind in parts.kinds_for(use)}
    name = inner.values.get("kind")
    if isinstance(name, str) and name in parts.PART_KINDS and name not in known:
        inner.ask("kind", Question(Sort.TEXT, choices=tuple(known)))
        other = parts.PART_KINDS[name].use
        message = f"`{name}` is a part for {_WORDS[other]}, and not for {_WORDS[use]}"
        hint = f"for {_WORDS[use]}: {', '.join(f'`{kind}`' for kind in known)}"
        inner.findings.add(PART_OF_ANOTHER_USE, inner.value_span("kind"), message, hint)
        return None
    return known.get(read_kind(inner, tuple(known)))


def _value(inner: TomlTable, parameter: Parameter, default: float | None, units: Units) -> float | None:
    """Return the value of a parameter [SI]; its default where it is absent or wrong."""
    name, quantity = parameter.name, _quantity(parameter, units)
    if parameter.measure is Measure.COUNT:
        value: float | None = float(
            inner.integer(name, round(parameter.low), round(parameter.high), round(default or parameter.low))
        )
        sort = Sort.WHOLE
    else:
        low = parameter.low if default is None else default
        value = inner.number(name, quantity, low)
        value = default if name not in inner else value
        sort = Sort.NUMBER
    inner.ask(name, Question(sort, quantity, default, meaning=parameter.meaning))
    return value


def _quantity(parameter: Parameter, units: Units) -> Quantity:
    known = {Measure.LENGTH: units.position, Measure.MASS: MASS, Measure.TIME: TIME}
    quantity = known.get(parameter.measure, Quantity("", 1.0, 0.0, 1.0))
    return quantity.within(parameter.low, parameter.high)


def _note_conflict(inner: TomlTable, kind: PartKind, values: Values, units: Units) -> None:
    """Note the first parameter that exceeds another one."""
    conflict = kind.conflict(values)
    if conflict is None:
        return
    small, large = conflict
    scaled = ((values[one.name], _quantity(one, units)) for one in conflict)
    shown = [quantity.show(value / quantity.scale) for value, quantity in scaled]
    message, hint = parts.conflict_words(inner.name_of(small.name), conflict, shown)
    place = small.name if small.name in inner else large.name
    inner.findings.add(CONFLICTING_MEASURES, inner.value_span(place), message, hint)
