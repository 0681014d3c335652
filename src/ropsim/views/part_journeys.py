"""Journeys of parts: where each part of a cell is during a run, told from the recording alone."""

from dataclasses import dataclass
from enum import Enum

import numpy as np

from ropsim.flow import Event, Recording
from ropsim.kinematics import forward
from ropsim.model import Cell, Part
from ropsim.spatial import Pose
from ropsim.views.pack_steps import DECIMALS


class Stay(Enum):
    """How a part is where it is."""

    WAITING = "waits in its supply, unseen"
    RESTING = "lies in the cell"
    CARRIED = "rides on the mechanical interface"
    LEFT = "has left by a sink, unseen"


@dataclass(frozen=True, slots=True)
class Placement:
    """Where a part is from one time on.

    Attributes:
        time: [s].
        stay: how it is there.
        pose: X_MO while carried, else X_WO.
    """

    time: float
    stay: Stay
    pose: Pose


def part_journeys(recording: Recording, cell: Cell) -> dict[str, tuple[Placement, ...]]:
    """Return the placements of every part by name, in order of time; the first one is at time 0.

    A part is taken, or left, when the gripper has closed or opened: at the end of that event. The next part
    of a supply appears when the one before it is taken; parts in `parts_left` of the header leave with
    their last release.

    Args:
        recording: with the attained coordinates `q` and the events of a run in this cell.
        cell: as it was simulated.
    """
    journeys = {part.name: [_at_start(part)] for part in cell.parts}
    parts = {part.name: part for part in cell.parts}
    ends = _ends(recording)
    for event in recording.events:
        name = event.data.get("part")
        if event.kind not in {"grip", "release"} or not isinstance(name, str) or name not in parts:
            continue
        time = round(event.time + event.duration, DECIMALS)
        X_WM, journey = attained(recording, cell, time), journeys[name]
        carried = journey[-1].stay is Stay.CARRIED
        if event.kind == "grip" and not carried:
            journey.append(Placement(time, Stay.CARRIED, X_WM.inverse() @ journey[-1].pose))
            _supply(journeys, cell, parts[name], time)
        elif event.kind == "release" and carried:
            stay = Stay.LEFT if event is ends.get(name) else Stay.RESTING
            journey.append(Placement(time, stay, X_WM @ journey[-1].pose))
    return {name: tuple(journey) for name, journey in journeys.items()}


def attained(recording: Recording, cell: Cell, time: float) -> Pose:
    """Return the attained pose X_WM of the mechanical interface at a time, linear between two rows."""
    rows = recording.channels["q"].values
    return cell.X_WB @ forward(
        cell.robot, np.array([np.interp(time, recording.time, column) for column in rows.T])
    )


def _at_start(part: Part) -> Placement:
    return Placement(0.0, Stay.RESTING if part.turn == 0 else Stay.WAITING, part.X_WO)


def _ends(recording: Recording) -> dict[str, Event]:
    """Return the last release of every part that has left the cell."""
    left = recording.header.get("parts_left")
    gone = {str(name) for name in left} if isinstance(left, (list, tuple)) else set()
    return {
        str(event.data["part"]): event
        for event in recording.events
        if event.kind == "release" and event.data.get("part") in gone
    }


def _supply(journeys: dict[str, list[Placement]], cell: Cell, taken: Part, time: float) -> None:
    """Let the next part of a supply appear, unless it has already done so."""
    for part in cell.parts:
        if taken.supply and part.supply == taken.supply and part.turn == taken.turn + 1:
            journey = journeys[part.name]
            if journey[-1].stay is Stay.WAITING:
                journey.append(Placement(time, Stay.RESTING, part.X_WO))
