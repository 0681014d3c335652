"""Inverse kinematics: from a pose to all joint coordinates that reach it."""

from itertools import product
from math import ceil, floor, hypot, inf, isnan, pi, remainder, sqrt

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.arrays import joint_vector, pose_rows
from ropsim.kinematics.diagnostics import NotFiniteError
from ropsim.kinematics.posture import POSTURES, Posture
from ropsim.kinematics.result import IkOptions, IkResult, IkStatus, Limits, LimitViolation, Reach
from ropsim.kinematics.wrist import WristArm, wrist_arm
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose

SAME = 1e-6
"""Branches nearer than this [rad] coincide: rounding by 1e-16 moves a stretched elbow by 1e-8."""
LIMIT_SLACK = 1e-9
"""An angle this far beyond a limit [rad] is rounding and is moved to the limit."""
TURN = 2.0 * pi


def inverse_batch(robot: RobotModel, T: npt.ArrayLike) -> Array:
    """Return all branches of many poses, limits ignored; compiled.

    Args:
        robot: arm of the class with closed-form inverse kinematics.
        T: poses X_BM of the mechanical interface as homogeneous matrices, shape (k, 4, 4).

    Returns:
        Joint coordinates in (-π, π] [rad], shape (k, 8, 6); row `Posture.index` belongs to that posture,
        rows of absent branches (and of matrices that are no poses) are NaN. Branches that coincide in a
        singular pose fill both rows; a joint that the pose leaves free is 0.

    Raises:
        NoClosedFormError: M550, the arm is outside the class.
        ArrayShapeError: M551, T has another shape.
    """
    return _solve(wrist_arm(robot), pose_rows(T), np.zeros(6))


def inverse(robot: RobotModel, pose: Pose, options: IkOptions | None = None) -> IkResult:
    """Return all joint coordinates that bring the mechanical interface to a pose.

    Closed form after Pieper (1968): wrist centre, shoulder, elbow, then the wrist as Euler angles; every
    branch is checked by forward kinematics to 1e-9 m and per entry of the rotation matrix.

    Args:
        robot: arm of the class with closed-form inverse kinematics.
        pose: X_BM; for a tool pose give `X_BT @ tool.X_MT.inverse()`.
        options: limits are respected where nothing is said.

    Raises:
        NoClosedFormError: M550, the arm is outside the class.
        ArrayShapeError: M551, `options.near` has another shape than (6,).
        NotFiniteError: M552, the pose or `options.near` holds NaN or infinity.
    """
    chosen = options or IkOptions()
    arm = wrist_arm(robot)
    if not np.isfinite(pose.position).all():
        raise NotFiniteError("pose")
    free = np.zeros(6) if chosen.near is None else joint_vector(robot, chosen.near)
    branches = _solve(arm, pose.matrix()[np.newaxis], free)[0]
    rows = _distinct(branches)
    if not rows:
        return _answer(IkStatus.OUT_OF_REACH, branches, reach=_reach(arm, pose))
    if chosen.limits is Limits.IGNORE:
        return _answer(IkStatus.FOUND, branches, [(row, branches[row], np.empty((0, 6))) for row in rows])
    variants = [(row, _within(robot, branches[row])) for row in rows]
    kept = [(row, found[0], found[1:]) for row, found in variants if len(found)]
    if kept:
        return _answer(IkStatus.FOUND, branches, kept)
    outside = [limit_violations(robot, branches[row]) for row in rows]
    nearest = min(outside, key=lambda violations: violations[0].excess)
    return _answer(IkStatus.OUT_OF_LIMITS, branches, violations=nearest)


def branch(result: IkResult, posture: Posture) -> Array | None:
    """Return the joint coordinates [rad] of one posture, limits ignored, shape (n,); None where absent."""
    row = result.branches[posture.index]
    return None if np.isnan(row).any() else row


def turned_to_limits(robot: RobotModel, q: npt.ArrayLike) -> Array:
    """Return joint coordinates with each joint in the turn that is nearest to the middle of its range.

    Args:
        robot: arm of turning joints.
        q: joint coordinates [rad], shape (n,).
    """
    centres = (robot.lower_limits + robot.upper_limits) / 2.0
    angles = joint_vector(robot, q)
    return np.asarray(angles + TURN * np.round((centres - angles) / TURN))


def limit_violations(robot: RobotModel, q: npt.ArrayLike) -> tuple[LimitViolation, ...]:
    """Return the joints that are outside their limits in every turn, worst first.

    Args:
        robot: arm of turning joints.
        q: joint coordinates [rad], shape (n,), such as a row of `IkResult.branches`.
    """
    found = []
    for index, (joint, angle) in enumerate(
        zip(robot.joints, turned_to_limits(robot, q).tolist(), strict=True)
    ):
        limit = min(max(angle, joint.lower), joint.upper)
        if abs(angle - limit) > LIMIT_SLACK:
            found.append(LimitViolation(index, joint.name, angle, limit))
    return tuple(sorted(found, key=lambda violation: -violation.excess))


def _solve(arm: WristArm, T: Array, free: Array) -> Array:
    from ropsim.kinematics.inverse_kernel import inverse_rows

    out = np.full((len(T), 8, 6), np.nan)
    inverse_rows(
        arm.lengths,
        arm.signs,
        arm.zeros,
        arm.front,
        arm.X_J,
        arm.X_M,
        arm.R_F,
        free,
        T,
        out,
        np.empty((2, 3, 3)),
        np.empty(6),
    )
    return out


def _distinct(branches: Array) -> list[int]:
    """Return the rows that hold a branch, each branch once."""
    angles = branches.tolist()
    rows: list[int] = []
    for row, found in enumerate(angles):
        if not isnan(found[0]) and not any(_coincide(found, angles[other]) for other in rows):
            rows.append(row)
    return rows


def _coincide(one: list[float], other: list[float]) -> bool:
    return all(abs(remainder(a - b, TURN)) <= SAME for a, b in zip(one, other, strict=True))


def _within(robot: RobotModel, q: Array) -> Array:
    """Return q turned by whole turns into the limits in all ways, the least turned first, shape (v, n)."""
    columns = []
    for joint, angle in zip(robot.joints, q.tolist(), strict=True):
        fewest = ceil((joint.lower - LIMIT_SLACK - angle) / TURN)
        most = floor((joint.upper + LIMIT_SLACK - angle) / TURN)
        turns = sorted(range(fewest, most + 1), key=abs)
        columns.append([min(max(angle + turn * TURN, joint.lower), joint.upper) for turn in turns])
    return np.array(list(product(*columns)), dtype=np.float64).reshape(-1, robot.n)


def _reach(arm: WristArm, pose: Pose) -> Reach:
    p_BW = pose.position + pose.rotation() @ arm.X_M[:, 3]
    x, y, z = (arm.X_J[:, :3].T @ (p_BW - arm.X_J[:, 3])).tolist()
    a1, h, D, upper, fore = arm.lengths.tolist()
    radius = hypot(x, y)
    if radius < abs(D):
        return Reach("1", radius, abs(D), inf)
    ahead = sqrt(radius * radius - D * D)
    shortest, longest = abs(upper - fore), upper + fore
    distances = [hypot(side * ahead - a1, z - h) for side in (-1.0, 1.0)]
    best = min(distances, key=lambda distance: max(distance - longest, shortest - distance))
    return Reach("2", best, shortest, longest)


def _answer(
    status: IkStatus,
    branches: Array,
    kept: list[tuple[int, Array, Array]] | None = None,
    violations: tuple[LimitViolation, ...] = (),
    reach: Reach | None = None,
) -> IkResult:
    found = kept or []
    return IkResult(
        status=status,
        solutions=np.array([q for _, q, _ in found]).reshape(-1, branches.shape[1]),
        postures=tuple(POSTURES[row] for row, _, _ in found),
        turns=tuple(turns for _, _, turns in found),
        branches=branches,
        violations=violations,
        reach=reach,
    )
