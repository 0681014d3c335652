"""The section `[supports]` of a cell file, and the parts that nothing supports."""

from collections.abc import Iterable

from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.objects import PartGroup
from ropsim.cellfile.quantity import Units
from ropsim.cellfile.tomltext.checks import TomlTable
from ropsim.cellfile.tomltext.words import cut
from ropsim.kinematics import parts_in_the_air
from ropsim.model import Cell, SupportLimits

_WIDEST = 1.0  # [m]


def read_supports(table: TomlTable, units: Units) -> SupportLimits:
    """Return when a part lies on something."""
    default, length = SupportLimits(), units.position.within(0.0, _WIDEST)
    limits = SupportLimits(
        table.number("gap", length, default.gap), table.number("depth", length, default.depth)
    )
    table.finish()
    return limits


def note_parts_in_the_air(cell: Cell, groups: Iterable[PartGroup]) -> None:
    """Note each table of parts of which some lie on nothing at time 0."""
    names = {part.name for part in parts_in_the_air(cell)}
    for group in groups:
        found = [part.name for part in group.parts if part.name in names]
        if not found:
            continue
        several = f" and {len(found) - 1} more of its table" if len(found) > 1 else ""
        message = f"part `{cut(found[0])}`{several} lies in the air at the start"
        hint = (
            f"up to {cell.supports.gap * 1e3:g} mm above an object, a part or the floor it lies on it: "
            "mend its position, or describe what carries it under `[[objects]]`"
        )
        span = group.table.value_span("position")
        group.table.findings.add(kinds.PART_IN_THE_AIR, span, message, hint)
