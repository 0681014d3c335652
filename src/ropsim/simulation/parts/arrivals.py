"""Whether parts are at their destinations when a run ends."""

import math
from collections.abc import Collection, Mapping

import numpy as np

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.model import Destination, Part
from ropsim.simulation.diagnostics.part_diagnostics import NOT_AT_DESTINATION
from ropsim.simulation.parts.moment import Moment
from ropsim.simulation.parts.placements import Exit, Placements
from ropsim.spatial import Pose

_STILL = 1e-3
"""Parts moved by less count as unmoved, since drives do not stop exactly [m | rad]."""


@frozen_dataclass
class Arrivals:
    """State of the parts with a destination.

    Attributes:
        wanted: their number.
        findings: one for each that is not there.
    """

    wanted: int
    findings: tuple[Diagnostic, ...]


def arrivals(
    state: Placements, parts: Mapping[str, Part], tools: Collection[str], moment: Moment
) -> Arrivals:
    """Return the state of the parts with a destination.

    Args:
        state: where the parts are at the end.
        parts: of the cell, by name.
        tools: names of the bodies of all tools.
        moment: where everything is at the end.
    """
    wanted = [(name, part.destination) for name, part in parts.items() if part.destination]
    found = [_finding(state, name, destination, tools, moment) for name, destination in wanted]
    return Arrivals(len(wanted), tuple(one for one in found if one is not None))


def are_untouched(state: Placements, parts: Mapping[str, Part], moment: Moment) -> bool:
    """Return whether all parts are where they were at the start; parts waiting in a supply count.

    Args:
        state: where the parts are at the end.
        parts: of the cell, by name.
        moment: where everything is at the end.
    """
    return not state.left and all(
        _is_there(moment.pose(seat), parts[name].X_WO) for name, seat in state.seats.items()
    )


def _is_there(pose: Pose, X_WO: Pose) -> bool:
    return bool(np.linalg.norm(pose.position - X_WO.position) < _STILL) and _angle(pose, X_WO) < _STILL


def _finding(
    state: Placements, name: str, destination: Destination, tools: Collection[str], moment: Moment
) -> Diagnostic | None:
    """Return the reason why a part is not at its destination, None if it is there."""
    seat = state.seats.get(name)
    if seat is None:
        where = _departure(state.left[name]) if name in state.left else "still waits in its supply"
        return _not_at_destination(
            name, f"part `{name}` {where}, it was to be at {_place(destination.X_WO)}", {}
        )
    pose, is_held = moment.pose(seat), seat.rides in tools
    distance = float(np.linalg.norm(pose.position - destination.X_WO.position))
    turn = _angle(pose, destination.X_WO)
    held = ", still in the gripper," if is_held else ""
    data: dict[str, object] = {"distance_m": distance, "turn_rad": turn}
    wrong = []
    if distance > destination.distance:
        wrong.append(f"{distance * 1e3:.1f} mm away, allowed are {destination.distance * 1e3:g} mm")
    if destination.turn is not None and turn > destination.turn:
        allowed = f"{math.degrees(destination.turn):g}°"
        wrong.append(f"turned by {math.degrees(turn):.1f}°, allowed are {allowed}")
    if not wrong and not is_held:
        return None
    why = " and ".join(wrong) or "not released"
    message = (
        f"part `{name}`{held} is at {_place(pose)}, its destination is {_place(destination.X_WO)}: {why}"
    )
    return _not_at_destination(name, message, data)


def _departure(gone: Exit) -> str:
    """Return how a part has left the cell, as a part of a sentence."""
    if gone.sink:
        return f"has left the cell by the sink `{gone.sink}`"
    return f"has run off the end of the belt `{gone.device}`"


def _not_at_destination(name: str, message: str, data: dict[str, object]) -> Diagnostic:
    hint = "mend the program, or `destination` of the part in the cell file"
    return NOT_AT_DESTINATION.at(None, message, hint=hint, data={"part": name, **data})


def _angle(one: Pose, other: Pose) -> float:
    """Return the angle between two orientations [rad]."""
    between = one.inverse() @ other
    return 2.0 * math.asin(min(1.0, float(np.linalg.norm(between.orientation[1:]))))


def _place(pose: Pose) -> str:
    x, y, z = (1e3 * pose.position).tolist()
    return f"({x:.1f}, {y:.1f}, {z:.1f}) mm"
