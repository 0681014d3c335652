"""The task frames of a cell file: `[frames.NAME]`, in the world or on a body moved by an external axis."""

from collections.abc import Collection, Mapping

from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.mounts import Mount
from ropsim.model import Frame
from ropsim.tomltext import UNKNOWN_CELL_NAME, TomlTable, Units, cut, read_pose


def read_frames(
    tables: Mapping[str, TomlTable], axes: Mapping[str, Mount], others: Collection[str], units: Units
) -> dict[str, Frame]:
    """Return the task frames by name.

    Args:
        tables: `[frames.NAME]`.
        axes: body of each external axis that a frame can lie on, and the frame in it, by name.
        others: names of devices and objects, on which no frame can lie.
        units: of the file.
    """
    frames = {}
    for name, table in tables.items():
        table.require("position")
        X_PK = read_pose(table, units)
        frames[name] = Frame(X_PK)
        parent = _parent(table, axes, others)
        if parent:
            body, X_BP = axes[parent]
            frames[name] = Frame(X_BP @ X_PK, body)
        table.finish()
    return frames


def note_moving(table: TomlTable, key: str, what: str, name: str) -> None:
    """Note that the value of a key names something that an external axis moves, where that cannot be."""
    message = f"{what} `{name}` moves with an external axis, here is needed one that stands still"
    hint = f"name another {what}, or leave out `parent` of its frame"
    table.findings.add(kinds.UNFIT_FRAME, table.value_span(key), message, hint)


def _parent(table: TomlTable, axes: Mapping[str, Mount], others: Collection[str]) -> str:
    name = table.values.get("parent")
    if isinstance(name, str) and name in others and name not in axes:
        table.text("parent", "")
        message = f"a task frame cannot lie on `{name}`"
        known = ", ".join(f"`{one}`" for one in sorted(axes)) or "none in this cell"
        hint = f"it can lie on external axes: {known}; without `parent` it stands in the world"
        table.findings.add(kinds.UNFIT_FRAME, table.value_span("parent"), message, hint)
        return ""
    if isinstance(name, str) and name and not axes:
        table.text("parent", "")
        message = f"parent `{cut(name)}` is not defined in this cell: no robot of it has external axes"
        hint = (
            "a task frame lies on an external axis: give the station a `positioner` or a `track`; "
            "without `parent` the frame stands in the world"
        )
        table.findings.add(UNKNOWN_CELL_NAME, table.value_span("parent"), message, hint)
        return ""
    return table.reference("parent", axes, "parent")
