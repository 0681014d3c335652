"""The parts, supplies and sinks of a cell file."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

import numpy as np

from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.objects.destinations import Surroundings, read_destinations
from ropsim.cellfile.objects.grid import read_grid
from ropsim.core import frozen_dataclass
from ropsim.model import PART_COLOUR, Material, Part, Sink
from ropsim.spatial import Array, Pose, frozen
from ropsim.tomltext import (
    MASS,
    MISSING_KEY,
    ORIGIN,
    Findings,
    TomlTable,
    Units,
    read_colour,
    read_material,
    read_pose,
)

_MOST_PARTS = 10_000
_SMALL_EDGE = 0.05  # [m], stands in while a wrong size is being reported
_TINY = 1e-3
"""A part without an edge of this length is most often one in metres [m]."""
_METRES = 'are these metres? Then write millimetres, or `length = "m"` under `[units]`'


@frozen_dataclass
class PartGroup:
    """The parts of one table of the file: a single one, a grid, or a supply."""

    table: TomlTable
    parts: tuple[Part, ...]


def read_parts(
    parts: tuple[TomlTable, ...],
    supplies: tuple[TomlTable, ...],
    taken: Mapping[str, str],
    around: Surroundings,
) -> tuple[PartGroup, ...]:
    """Return single parts and grids, then supplies, in the order of the file.

    Args:
        parts: the tables `[[parts]]`.
        supplies: the tables `[[supplies]]`.
        taken: who has them, for names that no part may have.
        around: data of the rest of the file.
    """
    groups = (
        *(PartGroup(table, tuple(_parts_of(table, around))) for table in parts),
        *(PartGroup(table, tuple(_supply(table, around))) for table in supplies),
    )
    if groups:
        named = ((part.name, group.table) for group in groups for part in group.parts)
        report_doubles(groups[0].table.findings, named, taken)
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
        named = ((sink.name, table) for table, sink in zip(tables, sinks, strict=True))
        report_doubles(tables[0].findings, named)
    return tuple(sinks)


def _parts_of(table: TomlTable, around: Surroundings) -> list[Part]:
    units = around.units
    table.require("name", "size", "mass", "position")
    name = body_name(table)
    size, mass = _body(table, units)
    colour, material = read_colour(table, PART_COLOUR), read_material(table, Material.PAINT)
    X_WO = read_pose(table, units)
    shifts = read_grid(table.table("grid"), units) if "grid" in table else [np.zeros(3)]
    goals = read_destinations(table, around, shifts)
    table.finish()
    names = [f"{name}_{k}" for k in range(1, len(shifts) + 1)] if "grid" in table else [name]
    return [
        Part(
            one,
            size,
            mass,
            Pose(X_WO.position + shift, X_WO.orientation),
            colour=colour,
            material=material,
            destination=goal,
        )
        for one, shift, goal in zip(names, shifts, goals, strict=True)
    ]


def _supply(table: TomlTable, around: Surroundings) -> list[Part]:
    units = around.units
    table.require("name", "size", "mass", "position", "count")
    name = body_name(table)
    size, mass = _body(table, units)
    colour, material = read_colour(table, PART_COLOUR), read_material(table, Material.PAINT)
    X_WO = read_pose(table, units)
    count = table.integer("count", 1, _MOST_PARTS, 1)
    goals = read_destinations(table, around, [np.zeros(3)] * count)
    table.finish()
    return [
        Part(f"{name}_{turn + 1}", size, mass, X_WO, name, turn, colour, material, goal)
        for turn, goal in enumerate(goals)
    ]


def body_name(table: TomlTable) -> str:
    """Return the name of a body; an empty one is noted, since no name stands for the world."""
    name = table.text("name", "")
    if table.values.get("name") == "":
        message = f"`{table.name_of('name')}` is empty"
        table.findings.add(MISSING_KEY, table.value_span("name"), message, "give it a name")
    return name


def _body(table: TomlTable, units: Units) -> tuple[Array, float]:
    size = table.numbers("size", 3, units.extent, (_SMALL_EDGE,) * 3)
    if max(size) < _TINY:
        edges = " x ".join(f"{edge * 1e3:g}" for edge in size)
        table.findings.add(kinds.TINY_PART, table.value_span("size"), f"the part has {edges} mm", _METRES)
    return frozen(size), table.number("mass", MASS, 0.0)


def report_doubles(
    findings: Findings,
    named: Iterable[tuple[str, TomlTable]],
    taken: Mapping[str, str] = MappingProxyType({}),
) -> None:
    """Note each name that occurs again or that something else has; empty names have been reported as missing.

    Args:
        findings: get the notes.
        named: names with their tables.
        taken: who has them, for names that are in use elsewhere.
    """
    seen: dict[str, TomlTable] = {}
    reported = {""}
    for name, table in named:
        if (name in seen or name in taken) and name not in reported:
            hint = taken.get(name) or f"the other one stands in line {seen[name].value_span('name').line}"
            span = table.value_span("name")
            findings.add(kinds.DUPLICATE_CELL_NAME, span, f"the name `{name}` is taken", hint)
            reported.add(name)
        seen.setdefault(name, table)
