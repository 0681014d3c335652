"""An arm on a track beside a tilting turntable with task frames on it; where the tool is, seen from there."""

from dataclasses import replace

import numpy as np

from ropsim import robots
from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin
from ropsim.kinematics import forward_batch, frames_batch
from ropsim.model import Cell, Frame, RobotModel, Tool, beside, link_name, on_track
from ropsim.planning import MotionPlan
from ropsim.spatial import Array, Pose
from support.cells import one_station
from support.motion import LINE, PASS, PUMA, references

X_MT = Pose(np.array([0.02, -0.03, 0.15]), np.array([0.9, 0.1, 0.2, 0.3]))
X_LK = Pose(np.array([0.1, -0.05, 0.08]), np.array([0.9, 0.1, -0.3, 0.2]))
X_LN = Pose(np.array([-0.1, 0.02, 0.03]), np.array([0.5, 0.5, 0.1, -0.6]))  # of a second one on the plate
PLATE = ModalState(frame="plate", tool="torch")
NEST = ModalState(frame="nest", tool="torch")
ROOM = ModalState(tool="torch")


def carried_cell(arm: RobotModel = PUMA, seed: int = 0) -> Cell:
    """Return a cell with an arm, its track E1 and a tilting turntable E2, E3, whose place follows a seed."""
    rng = np.random.default_rng(seed)
    turned = Pose(np.array([0.0, 0.1, 0.3]), np.array([1.0, 0.0, 0.0, rng.uniform(-0.4, 0.4)]))
    place = Pose(
        np.array([0.9, *rng.uniform(-0.3, 0.3, 1), -0.4]), np.array([1.0, *rng.uniform(-0.2, 0.2, 3)])
    )
    robot = beside(on_track(arm, robots.linear_track(4.0), turned), robots.tilting_turntable(0.3), place)
    on_plate = link_name(len(robot.joints))
    return one_station(
        "carried",
        robot,
        robots.default_controller(robot),
        tools={"torch": Tool("torch", X_MT)},
        frames={"plate": Frame(X_LK, on_plate), "nest": Frame(X_LN, on_plate)},
    )


def from_plate(robot: RobotModel, Q: Array, X_LF: Pose = X_LK) -> Array:
    """Return X_FT of the torch at rows of coordinates of all axes (k, n), frame F on the plate, (k, 4, 4)."""
    X_BF = frames_batch(robot, Q)[:, len(robot.joints) - 1] @ X_LF.matrix()
    return np.asarray(np.linalg.inv(X_BF) @ forward_batch(robot, Q) @ X_MT.matrix())


def tool_poses(robot: RobotModel, Q: Array) -> Array:
    """Return X_BT of the torch at rows of coordinates of all axes (k, n), shape (k, 4, 4)."""
    return np.asarray(forward_batch(robot, Q) @ X_MT.matrix())


def to_plate(robot: RobotModel, q: Array, kind: str = MotionKind.LIN) -> MoveInstruction:
    """Return the move to where the torch is on the plate at q, with its external values."""
    target = Pose.from_matrix(from_plate(robot, q[None])[0])
    return replace(_move(kind, target, PLATE), external=tuple(q[list(robot.external)].tolist()))


def to_room(robot: RobotModel, q: Array, kind: str = MotionKind.LIN) -> MoveInstruction:
    """Return the move to where the torch is in the base frame at q, with its external values."""
    target = Pose.from_matrix(tool_poses(robot, q[None])[0])
    return replace(_move(kind, target, ROOM), external=tuple(q[list(robot.external)].tolist()))


def commanded(plan: MotionPlan) -> Array:
    """Return the coordinates of all axes at the control ticks of a plan [rad | m], shape (ticks + 1, n)."""
    return references(plan)[0]


def _move(kind: str, target: Pose, modal: ModalState) -> MoveInstruction:
    return MoveInstruction(kind, target, modal, Origin(LINE, PASS))
