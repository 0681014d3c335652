"""Parts in the cell: grasp and release by a gripper, and the effect on the payload."""

import math
from collections.abc import Collection, Mapping
from functools import lru_cache
from types import MappingProxyType

import numpy as np

from ropsim.model import WORLD, Cell, Part, Payload, Tool, box, combine
from ropsim.simulation.parts.moment import Moment
from ropsim.simulation.parts.placements import Exit, Placements, Seat
from ropsim.spatial import Pose, PoseTuple

_DIGITS = 6
"""Digits behind the point of a pose [m] with which a part enters the payload."""


def initial_parts(cell: Cell) -> Placements:
    """Return the parts at time 0: of every supply only the first one is there."""
    seats = {part.name: Seat(WORLD, WORLD, part.X_WO) for part in cell.parts if part.turn == 0}
    queued = frozenset(part.name for part in cell.parts if part.turn > 0)
    return Placements(MappingProxyType(seats), queued)


def close_on(state: Placements, cell: Cell, tool: Tool, hand: str, moment: Moment) -> Placements:
    """Return the placements after the fingers have closed: the nearest part within the capture is held.

    It hangs on the tool now, also where another tool held it; parts on it come along.

    Args:
        state: before; the tool holds nothing.
        cell: the cell.
        tool: the tool that closes; it must have a gripper.
        hand: name of the body of the tool.
        moment: where everything is now.
    """
    capture = tool.gripper.capture if tool.gripper else 0.0
    X_WM = moment.carriers[hand]
    tcp = (X_WM @ tool.X_MT).position
    poses = moment.poses(state)
    at = tcp.tolist()
    distances = {name: math.dist(pose.position.tolist(), at) for name, pose in poses.items()}
    near = [name for name, distance in distances.items() if distance <= capture]
    if not near:
        return state
    name = min(near, key=lambda candidate: (distances[candidate], candidate))
    X_MW = X_WM.inverse()
    lifted = {one: Seat(state.seats[one].parent, hand, X_MW @ poses[one]) for one in state.family(name)}
    lifted[name] = Seat(hand, hand, lifted[name].pose)
    supplied = _successors(state, cell, name)
    seats = {**state.seats, **lifted, **supplied}
    return Placements(MappingProxyType(seats), state.queued - set(supplied), state.left)


def release(state: Placements, cell: Cell, hands: Collection[str], moment: Moment) -> Placements:
    """Return the placements after the fingers have opened: the part stays where it is or leaves by a sink.

    Args:
        state: before.
        cell: the cell.
        hands: names of the bodies of the tools whose fingers they are.
        moment: where everything is now.
    """
    name = state.held(hands)
    if not name:
        return state
    poses = {one: moment.pose(state.seats[one]) for one in state.carried(hands)}
    for sink in cell.sinks:
        if float(np.linalg.norm(poses[name].position - np.array(sink.position))) <= sink.radius:
            return state.without({one: Exit(pose, sink.name) for one, pose in poses.items()})
    left = {one: Seat(state.seats[one].parent, WORLD, pose) for one, pose in poses.items()}
    left[name] = Seat(WORLD, WORLD, poses[name])
    return state.with_seats(left)


def payload(carried: Mapping[str, Pose], parts: Mapping[str, Part], tool: Tool | None) -> Payload:
    """Return the one rigid body that tool and carried parts form at the mechanical interface.

    Parts count as they lie in it to the micrometre: so the payload does not depend on the last digits of the
    attained pose, which depend on the path of the arm to the grasp.

    Args:
        carried: pose X_MO of each part that it carries, by name.
        parts: of the cell, by name.
        tool: that is mounted, None for none.
    """
    bodies = []
    for name, attained in carried.items():
        part = parts[name]
        bodies.append((part.mass, tuple(part.size.tolist()), _to_the_micrometre(attained)))
    return _loaded(tool, tuple(bodies))


def mounted_load(tool: Tool | None) -> Payload:
    """Return the rigid body that an empty tool forms at the mechanical interface; None for no tool."""
    return _loaded(tool, ())


@lru_cache(maxsize=1024)
def _loaded(tool: Tool | None, carried: tuple[tuple[float, tuple[float, ...], PoseTuple], ...]) -> Payload:
    """Return the one rigid body of a tool and of boxes, by their masses [kg], edges [m] and poses X_MO."""
    bodies = () if tool is None else tool.loads
    for mass, size, lies in carried:
        X_MO = Pose.from_tuple(lies)
        R_MO = X_MO.rotation()
        centre = X_MO.position + R_MO @ np.array([0.0, 0.0, -size[2] / 2.0])
        bodies += (box(mass, np.array(size), centre, R_MO),)
    return combine(bodies)


def _to_the_micrometre(X: Pose) -> PoseTuple:
    """Return the numbers of a pose rounded to millionths; the sign of its quaternion has no effect."""
    numbers = np.round(np.concatenate((X.position, X.orientation)), _DIGITS) + 0.0  # no zero has a sign
    x, y, z, qw, qx, qy, qz = numbers.tolist()
    return (x, y, z, qw, qx, qy, qz)


def _successors(state: Placements, cell: Cell, taken: str) -> dict[str, Seat]:
    """Return the seat of the part that appears in a supply when the one before it is taken."""
    supplies = {(part.supply, part.turn) for part in cell.parts if part.name == taken and part.supply}
    return {
        part.name: Seat(WORLD, WORLD, part.X_WO)
        for part in cell.parts
        if part.name in state.queued and (part.supply, part.turn - 1) in supplies
    }
