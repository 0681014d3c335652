"""The parts, supplies and sinks of a cell file."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from ropsim.core import Span
from ropsim.model import PART_COLOUR, Material, Part, Sink
from ropsim.spatial import Array, Pose, frozen
from ropsim.workbench import cell_diagnostics as kinds
from ropsim.workbench.cell_poses import ORIGIN, read_pose
from ropsim.workbench.cell_shapes import read_colour, read_material
from ropsim.workbench.quantity import MASS, Units
from ropsim.workbench.toml_checks import Findings, TomlTable

_MOST_PARTS = 10_000
_SMALL_EDGE = 0.05  # [m], stands in while a wrong size is being reported


@dataclass(frozen=True, slots=True)
class PartGroup:
    """The parts of one table of the file: a single one, a grid, or a supply."""

    table: TomlTable
    parts: tuple[Part, ...]


def read_parts(
    parts: tuple[TomlTable, ...], supplies: tuple[TomlTable, ...], taken: Mapping[str, str], units: Units
) -> tuple[PartGroup, ...]:
    """Return single parts and grids, then supplies, in the order of the file.

    Args:
        parts: the tables `[[parts]]`.
        supplies: the tables `[[supplies]]`.
        taken: who has them, for names that no part may have.
        units: of the file.
    """
    groups = (
        *(PartGroup(table, tuple(_parts_of(table, units))) for table in parts),
        *(PartGroup(table, tuple(_supply(table, units))) for table in supplies),
    )
    if groups:
        report_doubles(groups[0].table.findings, _named_spans(groups), taken)
    return groups


def read_sinks(tables: tuple[TomlTable, ...], units: Units) -> tuple[Sink, ...]:
    """Return the places where released parts leave the cell."""
    sinks = []
    for table in tables:
        table.require("name", "position", "radius")
        x, y, z = table.numbers("position", 3, units.position, ORIGIN)
        radius = table.number("radius", units.extent, _SMALL_EDGE)
        sinks.append(Sink(table.text("name", ""), (x, y, z), radius))
        table.finish()
    if tables:
        spans = ((sink.name, table.value_span("name")) for table, sink in zip(tables, sinks, strict=True))
        report_doubles(tables[0].findings, spans)
    return tuple(sinks)


def _parts_of(table: TomlTable, units: Units) -> list[Part]:
    table.require("name", "size", "mass", "position")
    name = table.text("name", "")
    size, mass = _body(table, units)
    colour, material = read_colour(table, PART_COLOUR), read_material(table, Material.PAINT)
    X_WO = read_pose(table, units)
    shifts = _grid(table.table("grid"), units) if "grid" in table else None
    table.finish()
    if shifts is None:
        return [Part(name, size, mass, X_WO, colour=colour, material=material)]
    poses = (Pose(X_WO.position + shift, X_WO.orientation) for shift in shifts)
    return [
        Part(f"{name}_{k}", size, mass, pose, colour=colour, material=material)
        for k, pose in enumerate(poses, start=1)
    ]


def _supply(table: TomlTable, units: Units) -> list[Part]:
    table.require("name", "size", "mass", "position", "count")
    name = table.text("name", "")
    size, mass = _body(table, units)
    colour, material = read_colour(table, PART_COLOUR), read_material(table, Material.PAINT)
    X_WO = read_pose(table, units)
    count = table.integer("count", 1, _MOST_PARTS, 1)
    table.finish()
    return [
        Part(f"{name}_{turn + 1}", size, mass, X_WO, name, turn, colour, material) for turn in range(count)
    ]


def _body(table: TomlTable, units: Units) -> tuple[Array, float]:
    size = table.numbers("size", 3, units.extent, (_SMALL_EDGE,) * 3)
    return frozen(size), table.number("mass", MASS, 0.0)


def _grid(table: TomlTable, units: Units) -> list[Array]:
    """Return the shifts in world axes [m], shape (3,) each; the first direction runs fastest."""
    table.require("counts", "step")
    counts = _items(table, "counts")
    nx, ny = (table.integer_at(("counts", k), counts[k], 1, 100, 1) for k in range(2)) if counts else (1, 1)
    steps = _items(table, "step")
    directions = [
        np.array(table.numbers_at(("step", k), step, 3, units.position, ORIGIN))
        for k, step in enumerate(steps)
    ]
    table.finish()
    if len(directions) != 2:
        return [np.zeros(3)]
    return [i * directions[0] + j * directions[1] for j in range(ny) for i in range(nx)]


def _items(table: TomlTable, key: str) -> list[object]:
    """Return the two items of a list, or nothing."""
    value = table.values.get(key, []) if key in table else []
    if not isinstance(value, list):
        table.wrong_type((key,), value, "a list of two")
        return []
    if len(value) == 2 or key not in table:
        return value
    message = f"`{table.name_of(key)}` has {len(value)} items, needed are 2"
    table.findings.add(kinds.WRONG_VALUE_COUNT, table.value_span(key), message)
    return []


def _named_spans(groups: Iterable[PartGroup]) -> Iterator[tuple[str, Span]]:
    for group in groups:
        span = group.table.value_span("name")
        for part in group.parts:
            yield part.name, span


def report_doubles(
    findings: Findings, named: Iterable[tuple[str, Span]], taken: Mapping[str, str] = MappingProxyType({})
) -> None:
    """Note each name that occurs again or that something else has; empty names have been reported as missing.

    Args:
        findings: get the notes.
        named: names with the places where they are given.
        taken: who has them, for names that are in use elsewhere.
    """
    seen: dict[str, Span] = {}
    reported = {""}
    for name, span in named:
        if (name in seen or name in taken) and name not in reported:
            hint = taken.get(name) or f"the other one stands in line {seen[name].line}"
            findings.add(kinds.DUPLICATE_CELL_NAME, span, f"the name `{name}` is taken", hint)
            reported.add(name)
        seen.setdefault(name, span)
