"""The fixed objects of a cell file: tables, conveyors, stands."""

from collections.abc import Mapping
from dataclasses import replace

from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.library_parts import read_painted, read_part
from ropsim.cellfile.mounts import Mount
from ropsim.cellfile.objects.objects import body_name, report_doubles
from ropsim.model import Box, FixedObject, Shape
from ropsim.parts import Use
from ropsim.spatial import Pose, frozen
from ropsim.tomltext import CONFLICTING_KEYS, Look, TomlTable, Units, cut, read_look, read_pose, read_shapes

_SMALL_EDGE = 0.05  # [m], stands in while a wrong size is being reported
_SHOWN = 8  # objects of a ring in one message


def read_objects(
    tables: tuple[TomlTable, ...], taken: Mapping[str, str], mounts: Mapping[str, Mount], units: Units
) -> tuple[FixedObject, ...]:
    """Return the objects in the order of the file; one may hang on another, wherever that stands in the file.

    Args:
        tables: `[[objects]]`.
        taken: who has them, for names that no object may have.
        mounts: further mounts of objects: body, and the frame in it, by name.
        units: of the file.
    """
    parents = dict.fromkeys((*(str(table.values.get("name", "")) for table in tables), *mounts))
    objects = tuple(_object(table, parents, mounts, units) for table in tables)
    if tables:
        named = ((thing.name, table) for table, thing in zip(tables, objects, strict=True))
        report_doubles(tables[0].findings, named, taken)
    return _without_rings(objects, tables)


def _object(
    table: TomlTable, parents: Mapping[str, None], mounts: Mapping[str, Mount], units: Units
) -> FixedObject:
    table.require("name", "position")
    name = body_name(table)
    parent = table.reference("parent", parents, "object")
    X_PO = read_pose(table, units)
    shapes = _shapes(table, units)
    table.finish()
    if parent in mounts:
        body, X_BM = mounts[parent]
        return FixedObject(name, X_BM @ X_PO, shapes, body)
    return FixedObject(name, X_PO, shapes, parent)


def _shapes(table: TomlTable, units: Units) -> tuple[Shape, ...]:
    """Return the shapes: a block of the key `size`, else `shapes`, else those of a library part."""
    given = read_part(table, units, Use.OBJECT)
    short = "size" in table
    if short and "shapes" in table:
        message = "`size` and `shapes` both say what the object looks like"
        table.findings.add(CONFLICTING_KEYS, table.key_span("shapes"), message, "keep one of them")
    if short:
        return _block(table, units, read_look(table, Look()))
    if given is not None:
        return read_painted(table, units, given.part)
    if "part" not in table:
        table.require("shapes")
    return read_shapes(table, units, read_look(table, Look()))


def _without_rings(
    objects: tuple[FixedObject, ...], tables: tuple[TomlTable, ...]
) -> tuple[FixedObject, ...]:
    """Return the objects, with cyclic mounts noted and put into the world."""
    parents = {thing.name: thing.parent for thing in objects}
    ringed = _ringed(parents)
    kept = []
    for thing, table in zip(objects, tables, strict=True):
        if thing.name in ringed:
            hint = "let one of them hang on nothing, or on another object"
            table.findings.add(
                kinds.OBJECTS_IN_A_RING,
                table.value_span("parent"),
                f"objects hang on each other in a ring: {_around(parents, thing.name)}",
                hint,
            )
        kept.append(replace(thing, parent="") if thing.name in ringed else thing)
    return tuple(kept)


def _ringed(parents: Mapping[str, str]) -> set[str]:
    """Return the objects that hang on themselves in the end; each one is passed once."""
    found: set[str] = set()
    passed: set[str] = set()
    for start in parents:
        way: list[str] = []
        name = start
        while name and name in parents and name not in passed:
            passed.add(name)
            way.append(name)
            name = parents[name]
        if name and name in way:
            found.update(way[way.index(name) :])
    return found


def _around(parents: Mapping[str, str], start: str) -> str:
    """Return the way around a ring from one of its objects on; the middle of a long one is left out."""
    names = [start]
    while (name := parents[names[-1]]) != start and len(names) < _SHOWN:
        names.append(name)
    shown = [f"`{cut(one)}`" for one in names]
    return " on ".join([*shown, *(["…"] if name != start else []), shown[0]])


def _block(table: TomlTable, units: Units, look: Look) -> tuple[Shape, ...]:
    """Return the box of the key `size`, below its position as parts are."""
    x, y, z = table.numbers("size", 3, units.extent, (_SMALL_EDGE,) * 3)
    return (look.shape(Box((x, y, z)), Pose(frozen([0.0, 0.0, -z / 2.0]))),)
