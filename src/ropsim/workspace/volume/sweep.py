"""Effect of the first axis of an arm on a point: it turns or shifts a section of the workspace."""

from enum import Enum

import numpy as np

from ropsim.kinematics import frames_batch
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, frozen, record
from ropsim.workspace.diagnostics import WorkspaceError, first_axis
from ropsim.workspace.point import MovedPoint
from ropsim.workspace.ranges import TURN, AxisRanges, even_rows

SAMPLES = 64
"""Configurations in which an arm is sampled."""
STEP = 1e-5
"""Of difference quotients [rad | m]."""
FLAT = 1e-7
"""A point whose positions are nearer than this to a plane, as a share of their spread, moves in it."""


class SweepKind(Enum):
    """How the workspace follows from its section.

    TURN: the first axis turns the section about z; its coordinates are radius and height. SLIDE: it shifts it
    along z; they are x and y. FLAT: the point moves in the plane z = 0, which is the section, and the
    workspace is an area.
    """

    TURN = "turn"
    SLIDE = "slide"
    FLAT = "flat"


@record
class Sweep:
    """The first axis and the frame S of it.

    Attributes:
        kind: kind of effect.
        X_BS: S in the base frame, homogeneous, shape (4, 4); z is the axis, the origin that point of it which
            is next to that of the base.
        lower: begin of the range of the axis [rad | m]; 0 where flat.
        reach: its range [rad | m]; inf where flat, as nothing is swept.
        axis: number of the axis that sweeps; -1 where flat.
        sense: -1 where the axis turns against z, else 1.
    """

    kind: SweepKind
    X_BS: Array
    lower: float
    reach: float
    axis: int
    sense: float = 1.0

    @property
    def measure(self) -> str:
        """Return the unit of the measure: m³, or m² where the point moves in a plane."""
        return "m²" if self.kind is SweepKind.FLAT else "m³"


def point_jacobian(robot: RobotModel, point: MovedPoint, Q: Array) -> Array:
    """Return ∂p/∂q of a point by central differences, in the base frame, shape (k, 3, n)."""
    n = robot.n
    offsets = np.concatenate((np.eye(n), -np.eye(n))) * STEP
    rows = (Q[:, np.newaxis, :] + offsets).reshape(-1, n)
    p = point.positions(robot, rows).reshape(len(Q), 2, n, 3)
    return np.asarray((p[:, 0] - p[:, 1]).transpose(0, 2, 1) / (2.0 * STEP))


def sweep_of(robot: RobotModel, point: MovedPoint, ranges: AxisRanges) -> Sweep:
    """Return the effect of the first axis of an arm on a point.

    Raises:
        WorkspaceError: W103, neither a turn of the whole arm nor a shift.
    """
    Q = even_rows(ranges, SAMPLES)
    p = point.positions(robot, Q)
    middle = p.mean(axis=0)
    _, spread, directions = np.linalg.svd(p - middle, full_matrices=True)
    if spread[2] <= FLAT * max(spread[0], FLAT):
        return Sweep(SweepKind.FLAT, _frame(_pointing_up(directions[2]), np.zeros(3)), 0.0, np.inf, -1)
    joint = robot.axis_joints[0]
    frame = frames_batch(robot, np.zeros((1, robot.n)))[0, robot.axes[0]]
    axis, origin = frame[:3, 2], frame[:3, 3]
    J = point_jacobian(robot, point, Q)[:, :, 0]
    slides = joint.measure is JointType.PRISMATIC
    expected = np.broadcast_to(axis, J.shape) if slides else np.cross(axis, p - origin)
    if np.abs(J - expected).max() > 1e-6 * max(1.0, float(spread[0])):
        raise WorkspaceError(first_axis(robot.name, joint.name))
    kind = SweepKind.SLIDE if slides else SweepKind.TURN
    if not slides and axis[2] < -0.5:  # the axis counted as pointing up: heights as in common use
        return Sweep(kind, _frame(-axis, origin), -float(ranges.upper[0]), float(ranges.extent[0]), 0, -1.0)
    return Sweep(kind, _frame(axis, origin), float(ranges.lower[0]), float(ranges.extent[0]), 0)


def whole_turn(sweep: Sweep) -> bool:
    """Return whether the first axis turns all around."""
    return sweep.kind is SweepKind.TURN and sweep.reach >= TURN - 1e-9


def _pointing_up(normal: Array) -> Array:
    """Return the one of a normal and its opposite whose first large entry, from z on, is positive."""
    key = next(value for value in normal[::-1] if abs(value) > 0.5)
    return normal if key > 0.0 else -normal


def _frame(z: Array, through: Array) -> Array:
    """Return the frame with this axis whose origin is next to that of the base; x is near the base's x."""
    x = np.array([1.0, 0.0, 0.0]) if abs(z[0]) < 0.9 else np.array([0.0, 1.0, 0.0])
    x = x - (x @ z) * z
    x /= np.linalg.norm(x)
    X = np.eye(4)
    X[:3, 0], X[:3, 1], X[:3, 2] = x, np.cross(z, x), z
    X[:3, 3] = through - (through @ z) * z
    return frozen(X)
