"""Parts in the cell: which lie where, which one the gripper holds, what that does to the payload."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

import numpy as np

from ropsim.model import Cell, Part, Payload, Tool, box, combine
from ropsim.spatial import Pose


@dataclass(frozen=True, slots=True)
class Grasp:
    """The part in the gripper.

    Attributes:
        part: which one.
        X_MO: its frame in the mechanical interface frame.
    """

    part: Part
    X_MO: Pose


@dataclass(frozen=True, slots=True)
class PartsState:
    """Where every part is.

    Attributes:
        resting: pose X_WO of each part that lies in the cell, by name.
        queued: names of parts still waiting in their supply.
        grasp: the part in the gripper, or None.
        left: names of parts that have left the cell, in order.
    """

    resting: Mapping[str, Pose] = field(default_factory=lambda: MappingProxyType({}))
    queued: frozenset[str] = frozenset()
    grasp: Grasp | None = None
    left: tuple[str, ...] = ()


def initial_parts(cell: Cell) -> PartsState:
    """Return the parts at time 0: of every supply only the first one is there."""
    resting = {part.name: part.X_WO for part in cell.parts if part.turn == 0}
    queued = frozenset(part.name for part in cell.parts if part.turn > 0)
    return PartsState(MappingProxyType(resting), queued)


def close_on(state: PartsState, cell: Cell, tool: Tool, X_WM: Pose) -> PartsState:
    """Return the state after the fingers have closed: the nearest part within the capture is held.

    Args:
        state: before.
        cell: the cell.
        tool: the tool that closes; it must have a gripper.
        X_WM: attained pose of the mechanical interface.
    """
    capture = tool.gripper.capture if tool.gripper else 0.0
    tcp = (X_WM @ tool.X_MT).position
    distances = {name: float(np.linalg.norm(pose.position - tcp)) for name, pose in state.resting.items()}
    near = [name for name, distance in distances.items() if distance <= capture]
    if state.grasp is not None or not near:
        return state
    name = min(near, key=lambda candidate: (distances[candidate], candidate))
    part = _part(cell, name)
    resting = {key: pose for key, pose in state.resting.items() if key != name}
    following = [
        other for other in cell.parts if other.supply == part.supply != "" and other.turn == part.turn + 1
    ]
    for successor in following:
        if successor.name in state.queued:
            resting[successor.name] = successor.X_WO
    return replace(
        state,
        resting=MappingProxyType(resting),
        queued=state.queued - {successor.name for successor in following},
        grasp=Grasp(part, X_WM.inverse() @ state.resting[name]),
    )


def release(state: PartsState, cell: Cell, X_WM: Pose) -> PartsState:
    """Return the state after the fingers have opened: the part stays where it is, or leaves by a sink."""
    if state.grasp is None:
        return state
    X_WO = X_WM @ state.grasp.X_MO
    name = state.grasp.part.name
    for sink in cell.sinks:
        if float(np.linalg.norm(X_WO.position - np.array(sink.position))) <= sink.radius:
            return replace(state, grasp=None, left=(*state.left, name))
    return replace(state, resting=MappingProxyType({**state.resting, name: X_WO}), grasp=None)


def payload(state: PartsState, tool: Tool | None) -> Payload:
    """Return the one rigid body that tool and grasped part form at the mechanical interface."""
    bodies: tuple[Payload, ...] = ()
    if tool is not None:
        bodies += (Payload(tool.mass, tool.com, tool.inertia),)
    if state.grasp is not None:
        part, X_MO = state.grasp.part, state.grasp.X_MO
        R_MO = X_MO.rotation()
        centre = X_MO.position + R_MO @ np.array([0.0, 0.0, -part.size[2] / 2.0])
        bodies += (box(part.mass, part.size, centre, R_MO),)
    return combine(bodies)


def _part(cell: Cell, name: str) -> Part:
    return next(part for part in cell.parts if part.name == name)
