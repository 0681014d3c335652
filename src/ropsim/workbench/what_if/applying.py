"""A changed cell, and the settings of moves under a change."""

from dataclasses import replace

from ropsim.flow import ModalState, MoveInstruction
from ropsim.model import Cell, PathDefaults, Tool
from ropsim.simulation import Adaptation
from ropsim.workbench.what_if.change import BAD_CHANGE, Change, Subject, WhatIfError

_SPEEDS = ("path_speed", "orientation_speed")
_ACCELERATIONS = ("path_acceleration", "orientation_acceleration", "path_jerk")
_OF_CELL = {
    Subject.SPEED: ("speed", "orientation_speed"),
    Subject.ACCELERATION: ("acceleration", "jerk", "orientation_acceleration", "orientation_jerk"),
}


def changed_cell(cell: Cell, change: Change) -> Cell:
    """Return a cell with a change: masses of parts or tools, or defaults of programs.

    Raises:
        WhatIfError: X896, it lacks the entity to be changed.
    """
    match change.subject:
        case Subject.PAYLOAD:
            if not cell.parts:
                raise _nothing("no parts", "`tool=…kg` changes the mass of its tools")
            return replace(cell, parts=tuple(replace(part, mass=change.value) for part in cell.parts))
        case Subject.TOOL:
            if not any(tool.mass for one in cell.stations.values() for tool in one.tools.values()):
                raise _nothing("no tool with a mass", "`payload=…kg` changes the mass of its parts")
            stations = {
                name: replace(one, tools={key: _weighing(tool, change) for key, tool in one.tools.items()})
                for name, one in cell.stations.items()
            }
            return replace(cell, stations=stations)
        case Subject.ZONES:
            return cell
        case subject:
            stations = {}
            for name, one in cell.stations.items():
                path = _faster(one.controller.path, _OF_CELL[subject], change.value)
                stations[name] = replace(one, controller=replace(one.controller, path=path))
            return replace(cell, stations=stations)


def adaptation(change: Change) -> Adaptation:
    """Return the change of the settings of moves.

    Shares of joint limits stay at 100 % at most: the joints have no reserve.
    """

    def adapt(move: MoveInstruction) -> MoveInstruction:
        modal = move.modal
        match change.subject:
            case Subject.SPEED:
                share = min(modal.ptp_speed * change.value, 1.0)
                modal = _scaled(replace(modal, ptp_speed=share), _SPEEDS, change.value)
            case Subject.ACCELERATION:
                share = min(modal.ptp_acceleration * change.value, 1.0)
                modal = _scaled(replace(modal, ptp_acceleration=share), _ACCELERATIONS, change.value)
            case Subject.ZONES if change.line == 0 or _place(move) == (change.source, change.line):
                modal = replace(modal, zone=0.0, passes=False)
            case _:
                return move
        return replace(move, modal=modal)

    return adapt


def _place(move: MoveInstruction) -> tuple[str, int]:
    span = move.origin.span
    return (span.source, span.line) if span else ("", 0)


def _scaled(modal: ModalState, names: tuple[str, ...], factor: float) -> ModalState:
    """Return a modal state with some settings times a factor; defaults of the cell are scaled there."""
    given = {name: value for name in names if (value := getattr(modal, name)) is not None}
    return replace(modal, **{name: value * factor for name, value in given.items()})


def _faster(path: PathDefaults, names: tuple[str, ...], factor: float) -> PathDefaults:
    return replace(path, **{name: getattr(path, name) * factor for name in names})


def _weighing(tool: Tool, change: Change) -> Tool:
    """Return a tool of another mass, its inertia in proportion; one without a mass stays unchanged."""
    if not tool.mass:
        return tool
    return replace(tool, mass=change.value, inertia=tool.inertia * (change.value / tool.mass))


def _nothing(found: str, hint: str) -> WhatIfError:
    return WhatIfError(BAD_CHANGE.at(None, f"the cell has {found}", hint=hint))
