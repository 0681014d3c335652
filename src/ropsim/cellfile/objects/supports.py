"""The section `[supports]` of a cell file, and the parts that nothing supports or that are in something."""

from collections.abc import Iterable, Sequence

from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.objects.objects import PartGroup
from ropsim.kinematics import Standing, standings_at_start
from ropsim.model import Cell, SupportLimits, lying_words, spoken_body
from ropsim.tomltext import TomlTable, Units, cut

_WIDEST = 1.0  # [m]


def read_supports(table: TomlTable, units: Units) -> SupportLimits:
    """Return when a part lies on something."""
    default, length = SupportLimits(), units.position.within(0.0, _WIDEST)
    limits = SupportLimits(
        table.number("gap", length, default.gap), table.number("depth", length, default.depth)
    )
    table.finish()
    return limits


def note_standings(cell: Cell, groups: Iterable[PartGroup]) -> None:
    """Note each table of parts of which some lie on nothing at time 0, or are in something else."""
    found = {part.name: standing for part, standing in standings_at_start(cell)}
    things = {
        *(one.name for one in cell.objects),
        *(one.name for one in cell.parts),
    }  # a pin may stand inside its support
    for group in groups:
        there = [(part.name, found[part.name]) for part in group.parts if part.name in found]
        _note_in_the_air(group.table, [name for name, one in there if one.on is None], cell.supports)
        deep = [
            (name, one) for name, one in there if one.depth > cell.supports.depth and one.inside not in things
        ]
        _note_inside(group.table, deep, cell)


def _note_in_the_air(table: TomlTable, names: Sequence[str], limits: SupportLimits) -> None:
    if names:
        message = f"part {_several(names)} lies in the air at the start"
        hint = (
            f"{lying_words(limits)}: mend its position, which is the centre of its top face, "
            "or describe what carries it under `[[objects]]`"
        )
        table.findings.add(kinds.PART_IN_THE_AIR, table.value_span("position"), message, hint)


def _note_inside(table: TomlTable, there: Sequence[tuple[str, Standing]], cell: Cell) -> None:
    if there:
        deepest, allowed = there[0][1], cell.supports.depth
        where = spoken_body(cell, deepest.inside)
        message = (
            f"part {_several([name for name, _ in there])} is in {where} at the start: "
            f"it would be free {deepest.depth * 1e3:.1f} mm higher, allowed are {allowed * 1e3:g} mm"
        )
        hint = "its position is the centre of its top face; the depth allowed is `depth` in `[supports]`"
        table.findings.add(kinds.PART_INSIDE, table.value_span("position"), message, hint)


def _several(names: Sequence[str]) -> str:
    more = f" and {len(names) - 1} more of its table" if len(names) > 1 else ""
    return f"`{cut(names[0])}`{more}"
