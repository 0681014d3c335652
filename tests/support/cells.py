"""Cells with one station, and changes of that station."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from ropsim.model import ROBOT, Cell, ControllerModel, RobotModel, Station, Tool
from ropsim.planning import MotionChain, standard_chain
from ropsim.spatial import Array, Pose, frozen


def one_station(
    name: str,
    robot: RobotModel,
    controller: ControllerModel,
    *,
    X_WB: Pose | None = None,
    tools: Mapping[str, Tool] | None = None,
    default_tool: str = "",
    start: Array | None = None,
    program: str = "main",
    **around: Any,
) -> Cell:
    """Return a cell whose only station is called `robot`; the other arguments are those of `Cell`."""
    station = Station(
        ROBOT,
        robot,
        controller,
        X_WB or Pose(),
        tools or {},
        default_tool,
        frozen([]) if start is None else start,
        program,
    )
    return Cell(name, {"robot": station}, **around)


def with_station(cell: Cell, **changes: Any) -> Cell:
    """Return a cell whose first station is changed."""
    first = cell.first
    return replace(cell, stations={**cell.stations, first.name: replace(first, **changes)})


def chain_of(cell: Cell) -> MotionChain:
    """Return the built-in entities of the first station."""
    return standard_chain(cell, cell.first)
