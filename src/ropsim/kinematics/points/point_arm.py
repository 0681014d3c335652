"""What an arm with fewer than six axes can choose of the position of its TCP."""

from enum import Enum
from functools import lru_cache

import numpy as np

from ropsim.kinematics.chain.arm_arrays import ArmArrays, arm_arrays
from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.chain.closed_motion import loop_gaps
from ropsim.kinematics.chain.closure import APART
from ropsim.kinematics.chain.jacobian import jacobian_at
from ropsim.kinematics.chain.linear_loops import without_linear_loops
from ropsim.kinematics.chain.path_derivatives_kernel import DerivativeWork
from ropsim.kinematics.points.point_kernel import ROOM, PointArm
from ropsim.kinematics.solutions.configurations import configurations
from ropsim.model import RobotModel, held_arm
from ropsim.spatial import Array, Pose, frozen, record

POSE = 6
"""Coordinates of a pose: an arm with as many axes can choose all of them."""
STARTS = 64
"""Starts of a search, which fill the range of the joints evenly."""
CLOSED_STARTS = 16
"""The same for closed chains, of those at which they can be closed."""
PROBES = 16
"""Configurations from which it is seen what an arm can choose."""
FLAT = 1e-9
"""A direction in which the TCP moves less than this share of the greatest one is none."""
STILL = 1e-9
"""A TCP that a turn of each joint by one radian moves less than this stands still [m]."""
MARGIN_SHARE, MARGIN = 0.1, 0.35
"""Share of the range of a joint, and [rad | m], within which it gives way to others."""
CHOSEN = 5e-3
"""The same for what an arm can choose where it stands: files write angles with three digits."""


class Places(Enum):
    """Where the TCP of an arm can be."""

    SPACE = "the space"
    PLANE = "the plane"
    LINE = "the line"
    SURFACE = "the surface"
    CURVE = "the curve"
    POINT = "the place"


@record
class PointShape:
    """An arm without external axes and its TCP, and where that can be.

    Attributes:
        chain: the arm.
        tcp: in the interface [m], shape (3,).
        space: basis of the directions in which the TCP moves, shape (d, 3).
        rank: how many coordinates of a position the arm can choose, at most d.
        scale: of the joints: their greatest speeds by the greatest of them, shape (n,).
        limits: lower and upper limits [rad | m], shape (2, n).
        margins: before them, within which a joint gives way to others [rad | m]; 0 without joints to spare
            and where there are no limits, shape (n,).
        starts: of a search, shape (s, n).
        places: where the TCP can be.
    """

    chain: ArmArrays
    tcp: Array
    space: Array
    rank: int
    scale: Array
    limits: Array
    margins: Array
    starts: Array
    places: Places

    @property
    def is_flat(self) -> bool:
        """Return whether the places are a straight line, a plane or the space: not bent."""
        return self.rank == len(self.space)

    @property
    def spare(self) -> int:
        """Return how many joints more the arm has than a position needs."""
        return self.chain.n - self.rank

    def for_kernels(self) -> tuple[PointArm, DerivativeWork, Array]:
        """Return the arm, an open chain, for kernels, and room for them."""
        chain = self.chain
        assert isinstance(chain, ChainArrays)
        m, n = len(chain.slides), chain.n
        arm = PointArm(
            chain.flat,
            chain.spread,
            self.tcp,
            self.space,
            self.scale,
            np.array([float(self.rank)]),
            self.limits,
            self.margins,
        )
        work = DerivativeWork(
            np.empty((m + 1, 12)),
            np.empty((7, m)),
            np.empty((6, m)),
            np.empty((12, n)),
            np.empty((6, n + POSE)),
            np.empty((5, max(n, POSE))),
        )
        return arm, work, np.zeros((ROOM, max(n, 3)))


def chooses_points_only(robot: RobotModel) -> bool:
    """Return whether an arm has too few axes for a pose: with a free orientation, the point alone counts.

    Closed chains but parallelograms count if they have no more axes than a position needs.

    Args:
        robot: with its external axes.
    """
    if not (robot.has_arm and 0 < robot.n - len(robot.external) < POSE):
        return False
    return not robot.cuts or _is_simple(robot)


def spare_joints(robot: RobotModel, X_MT: Pose) -> int:
    """Return how many joints more an arm has than it needs to bring the TCP of a tool to a point."""
    return point_shape(robot, X_MT.position).spare


def point_shape(robot: RobotModel, tcp: Array) -> PointShape:
    """Return what an arm can choose of the position of a TCP.

    Args:
        robot: for which `chooses_points_only` holds.
        tcp: in the interface [m], shape (3,).
    """
    return _shape(robot, tuple(tcp.tolist()))


@lru_cache(maxsize=64)
def _is_simple(robot: RobotModel) -> bool:
    """Return whether an arm with closed chains has as many axes as it chooses coordinates of a position."""
    shape = point_shape(robot, np.zeros(3))
    return isinstance(shape.chain, ChainArrays) or shape.spare == 0


@lru_cache(maxsize=64)
def _shape(robot: RobotModel, tcp: tuple[float, float, float]) -> PointShape:
    arm = without_linear_loops(held_arm(robot).arm if robot.external else robot)
    starts, scale = configurations(arm, STARTS), arm.max_speeds / arm.max_speeds.max()
    if arm.cuts:
        starts = np.vstack((arm.home, starts[loop_gaps(arm, starts) <= APART]))[:CLOSED_STARTS]
    limits = np.stack((arm.lower_limits, arm.upper_limits))
    ways = np.array([jacobian_at(arm, q, Pose(np.array(tcp)))[:3] for q in starts[:PROBES]])  # (s, 3, n)
    _, sizes, directions = np.linalg.svd(np.concatenate(ways, axis=1).T, full_matrices=False)
    greatest = float(sizes[0])
    d = int((sizes > FLAT * greatest).sum()) if greatest > STILL else 0
    space = np.eye(3) if d == len(directions) == 3 else directions[:d]
    chosen = np.linalg.svd(ways, compute_uv=False)
    rank = int((chosen > CHOSEN * np.maximum(chosen[:, :1], 1e-300)).sum(axis=1).max()) if d else 0
    return PointShape(
        arm_arrays(arm),
        frozen(tcp),
        frozen(space.reshape(d, 3)),
        min(rank, d),
        frozen(scale),
        frozen(limits),
        frozen(_margins(limits) if arm.n > min(rank, d) else np.zeros(arm.n)),
        frozen(starts),
        _places(d, min(rank, d)),
    )


def _margins(limits: Array) -> Array:
    """Return the margins of limits (2, n), shape (n,)."""
    ranges = limits[1] - limits[0]
    return np.where(np.isfinite(ranges), np.minimum(MARGIN_SHARE * ranges, MARGIN), 0.0)


def _places(d: int, rank: int) -> Places:
    if rank == d:
        return (Places.POINT, Places.LINE, Places.PLANE, Places.SPACE)[d]
    return Places.CURVE if rank == 1 else Places.SURFACE
