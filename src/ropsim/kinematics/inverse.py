"""Inverse kinematics: from a pose to all joint coordinates that reach it. The one door for all arms."""

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.arm_arrays import arm_arrays, turning_axes
from ropsim.kinematics.chain.arrays import chain_arrays, joint_rows, joint_vector, pose_rows
from ropsim.kinematics.chain.forward import forward_batch
from ropsim.kinematics.diagnostics import NotFiniteError
from ropsim.kinematics.recognition import redundant_solver_of, solver_of
from ropsim.kinematics.solutions.followers import FollowerLimits, follower_limits
from ropsim.kinematics.solutions.held import in_arm_base, of_robot, result_of_robot
from ropsim.kinematics.solutions.limits import limit_violations
from ropsim.kinematics.solutions.polish import polished, unbounded
from ropsim.kinematics.solutions.redundancy import intervals_of, nearest_answer, reachable
from ropsim.kinematics.solutions.result import (
    Free,
    FreeInterval,
    IkOptions,
    IkResult,
    IkStatus,
    Limits,
    Posture,
)
from ropsim.kinematics.solutions.selection_kernel import HEAD, SAME
from ropsim.kinematics.solutions.sheet import Sheet, sheet
from ropsim.kinematics.solutions.solver import InverseSolver, RedundantSolver
from ropsim.model import RobotModel, held_arm
from ropsim.spatial import Array, Pose, frozen

NEIGHBOUR = 0.1
"""A pose this near to that of `near` [m, entries of the rotation matrix] may be its neighbour on a path."""
TURN = 2.0 * np.pi


@dataclass(frozen=True, slots=True, eq=False)
class _Desk:
    """Data for solving one arm, and free sheets of earlier calls.

    Attributes:
        solver: of the arm.
        redundant: the same, where a pose leaves something free that it holds.
        names: of the branches, in the order of the rows.
        limits: lower and upper limits [rad | m] and 1.0 for joints that turn, shape (3, n).
        unlimited: the same without limits.
        rest: zeros, shape (n,).
        coupled: limits of joints that are no axes.
        sheets: sheets that are not in use: each thread takes its own.
        named: postures of listed branches, by the sum of 2^row of them.
    """

    solver: InverseSolver
    redundant: RedundantSolver | None
    names: tuple[Posture, ...]
    limits: Array
    unlimited: Array
    rest: Array
    coupled: FollowerLimits
    sheets: list[Sheet]
    named: dict[float, tuple[Posture, ...]]

    def sheet(self) -> Sheet:
        """Return a sheet that is not in use; it must be returned."""
        try:
            return self.sheets.pop()
        except IndexError:
            return sheet(self.solver, self.limits)


def inverse_batch(robot: RobotModel, T: npt.ArrayLike, held: npt.ArrayLike | None = None) -> Array:
    """Return all branches of many poses, limits ignored; compiled.

    Args:
        robot: arm with n axes.
        T: poses X_BM of the mechanical interface as homogeneous matrices, shape (k, 4, 4).
        held: coordinates of the axes [rad | m], shape (n,), or (k, n) with a row for each pose, at whose
            external ones the arm is solved, and at which a redundant one holds its free coordinate
            (`RedundantSolver`); None for the home position.

    Returns:
        Joint coordinates [rad | m], revolute ones in (-π, π], shape (k, b, n); row i has the posture
        `solver_of(robot).postures[i]`, rows of absent branches (and of matrices that are no poses) are NaN.
        Branches that coincide in a singular pose fill both rows; a joint that the pose leaves free is 0.

    Raises:
        ArrayShapeError: M551, T or `held` has another shape.
        NotFiniteError: M552, `held` holds NaN or infinity.
    """
    if robot.external:
        whole, q = held_arm(robot), _held_rows(robot, held)
        own = np.ascontiguousarray(q[..., list(whole.axes)])
        return of_robot(whole, q, inverse_batch(whole.arm, in_arm_base(robot, whole, q, pose_rows(T)), own))
    redundant = redundant_solver_of(robot)
    if redundant is None:
        return solver_of(robot).branches(pose_rows(T), np.zeros(robot.n))
    rows = np.atleast_2d(_held_rows(robot, held))
    free = np.array([redundant.free(q).value for q in rows])
    poses = pose_rows(T)
    return redundant.branches_at(poses, rows[0], np.array(np.broadcast_to(free, len(poses))))


def inverse(robot: RobotModel, pose: Pose, options: IkOptions | None = None) -> IkResult:
    """Return all joint coordinates that bring the mechanical interface to a pose.

    The solver is that of the arm's class, see `solver_of`. External axes keep their values of `options.near`,
    by default of the home position. Every answer reaches the pose to 1e-9 m and per entry of the rotation
    matrix, by forward kinematics; for arms with fewer than six joints, coordinates of the pose that they
    cannot choose may be off by `TASK_SLACK`.

    Args:
        robot: arm with n joints.
        pose: X_BM; for a tool pose pass `X_BT @ tool.X_MT.inverse()`.
        options: limits are respected where nothing is said.

    Raises:
        ArrayShapeError: M551, `options.near` has another shape than (n,).
        NotFiniteError: M552, the pose or `options.near` holds NaN or infinity.
    """
    if robot.external:
        return _with_held_axes(robot, pose, options or IkOptions())
    desk = _desk(robot)
    near = desk.rest if options is None or options.near is None else joint_vector(robot, options.near)
    if desk.redundant is not None:
        asked = pose.matrix(), near
        return _with_free_coordinate(robot, desk, desk.redundant, asked, options or IkOptions())
    one = desk.sheet()
    T = one.X_BM
    pose.write_matrix(T)
    _solve(robot, desk, one, near)
    answer = _answer(robot, desk, T, one, Limits.RESPECT if options is None else options.limits)
    desk.sheets.append(one)
    return answer


def branches_near(robot: RobotModel, pose: Pose, near: Array) -> Array | None:
    """Return the `branches` that `inverse` finds near to joint coordinates, sooner than with all else of it.

    Limits are ignored, but for a redundant arm, whose free coordinate is chosen within them.

    Args:
        robot: arm with n joints.
        pose: X_BM.
        near: finite joint coordinates [rad | m], shape (n,).

    Returns:
        shape (m, n) with NaN rows, None where no row is there and `inverse` says why.
    """
    desk = _desk(robot)
    if robot.external or desk.redundant is not None:
        found = inverse(robot, pose, IkOptions(near=near))
        return None if found.shortfall else found.branches
    one = desk.sheet()
    pose.write_matrix(one.X_BM)
    _solve(robot, desk, one, near)
    branches = one.branches.copy()
    desk.sheets.append(one)
    return None if np.isnan(branches[:, 0]).all() else branches


def free_intervals(
    robot: RobotModel, pose: Pose, near: npt.ArrayLike | None = None
) -> tuple[FreeInterval, ...]:
    """Return where the free coordinate of a redundant arm may be at a pose, within the joint limits.

    The ends are where a joint meets a limit or where the free coordinate turns back at the border of reach.
    `inverse` with `IkOptions.free` gives the answers at a value. External axes keep their values of `near`.

    Args:
        robot: arm with n joints.
        pose: X_BM.
        near: joint coordinates [rad | m] of which the external ones count, shape (n,); None for the home
            position.

    Returns:
        The intervals in order, none where the pose has no answer within the limits or the arm has no free
        coordinate (`redundant_solver_of`).

    Raises:
        ArrayShapeError: M551, `near` has another shape than (n,).
        NotFiniteError: M552, the pose or `near` holds NaN or infinity.
    """
    if robot.external:
        whole, q = held_arm(robot), _external(robot, near)
        X = in_arm_base(robot, whole, q, pose.matrix()[np.newaxis])[0]
        return free_intervals(whole.arm, Pose.from_matrix(X))
    T, desk = pose.matrix(), _desk(robot)
    if near is not None:
        joint_vector(robot, near)
    if not np.isfinite(T).all():
        raise NotFiniteError("pose")
    if desk.redundant is None:
        return ()
    return intervals_of(reachable(desk.redundant, chain_arrays(robot), T, desk.limits))


def posture(robot: RobotModel, q: npt.ArrayLike) -> Posture:
    """Return the posture of a configuration, in the words of the arm's class.

    Where two branches coincide the first of the two names is given.

    Args:
        robot: arm with n joints.
        q: joint coordinates [rad | m], shape (n,).

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    values = joint_vector(robot, q)
    return solver_of(robot).posture(values[list(held_arm(robot).axes)] if robot.external else values)


def branch(result: IkResult, posture: Posture) -> Array | None:
    """Return the joint coordinates [rad | m] of a posture, limits ignored, shape (n,); None if absent."""
    rows = [q for q, name in zip(result.branches, result.names, strict=True) if name == posture]
    return next((q for q in rows if q[0] == q[0]), None)


def _solve(robot: RobotModel, desk: _Desk, one: Sheet, near: Array) -> None:
    """Write the branches of the pose on a sheet to it, with the answer next to `near` (n,)."""
    one.solve(near)
    if near is not desk.rest and desk.solver.may_stay(near):
        beside = _next_to(robot, desk, one.X_BM, near)
        if beside is not None:
            _put(desk, beside, one.branches)


def _with_free_coordinate(
    robot: RobotModel, desk: _Desk, solver: RedundantSolver, asked: tuple[Array, Array], options: IkOptions
) -> IkResult:
    """Return the answer of a redundant arm for a pose (4, 4) and `near` (n,)."""
    T, near = asked
    beside = None if near is desk.rest or options.free is not None else _next_to(robot, desk, T, near)
    free = solver.free(near if beside is None else beside)
    if options.free is not None:
        free = Free(free.name, float(options.free))
    branches = solver.branches_at(T[np.newaxis], near, np.array([free.value]))[0]
    if beside is not None:
        _put(desk, beside, branches)
    one = desk.sheet()

    def answer(rows: Array) -> IkResult:
        one.branches[:] = rows
        return _answer(robot, desk, T, one, options.limits)

    last = replace(answer(branches), free=free)
    if last.status is not IkStatus.FOUND and options.free is None:
        limits = desk.limits if options.limits is Limits.RESPECT else desk.unlimited
        last = nearest_answer(solver, chain_arrays(robot), (T, near, limits), last, answer)
    desk.sheets.append(one)
    return last


def _answer(robot: RobotModel, desk: _Desk, T: Array, one: Sheet, limits: Limits) -> IkResult:
    """Return the answer of which the branches stand on a sheet."""
    names, respected = desk.names, limits is Limits.RESPECT
    branches, found = one.branches.copy(), one.found
    rows, n = branches.shape
    found[0] = 1.0 if respected else 0.0
    one.select()
    first = HEAD + 2 * rows
    present, listed, of_rows, further, *marks = found[:first].tolist()
    if listed:
        count = int(listed)
        solutions = found[first : first + count * n].reshape(count, n).copy()
        turns = (solutions[:0],) * count
        if further:
            first += rows * n
            # copied, so that no view keeps all of `found`
            variants = found[first : first + int(further) * n].reshape(-1, n).copy()
            turns = _turns(variants, marks[1 : 2 * count : 2])
        postures = desk.named.get(of_rows) or _postures(desk, of_rows)
        result = IkResult(IkStatus.FOUND, solutions, postures, turns, branches, names)
        return _within(robot, desk.coupled, result) if respected and desk.coupled.joints else result
    solutions = np.empty((0, n))
    if not present:
        if not np.isfinite(T).all():
            raise NotFiniteError("pose")
        shortfall = desk.solver.shortfall(T)
        return IkResult(shortfall.status, solutions, (), (), branches, names, (), shortfall)
    return _out_of_limits(robot, branches, names)


def _out_of_limits(robot: RobotModel, branches: Array, names: tuple[Posture, ...]) -> IkResult:
    """Return the answer where every branch breaks a limit, with the violations of the best one."""
    outside = [limit_violations(robot, q) for q in branches if q[0] == q[0]]
    nearest = min((one for one in outside if one), key=lambda violations: violations[0].excess)
    return IkResult(IkStatus.OUT_OF_LIMITS, branches[:0].copy(), (), (), branches, names, nearest)


def _within(robot: RobotModel, coupled: FollowerLimits, found: IkResult) -> IkResult:
    """Return an answer without branches beyond the limits of joints that follow axes."""
    kept = []
    for first, posture_, turns in zip(found.solutions, found.postures, found.turns, strict=True):
        variants = np.vstack((first, turns))
        inside = variants[(coupled.excess(variants) == 0.0).all(axis=1)]
        if len(inside):
            kept.append((posture_, inside))
    if not kept:
        return _out_of_limits(robot, found.branches, found.names)
    return replace(
        found,
        solutions=np.array([inside[0] for _, inside in kept]),
        postures=tuple(one for one, _ in kept),
        turns=tuple(inside[1:].copy() for _, inside in kept),
    )


def _with_held_axes(robot: RobotModel, pose: Pose, options: IkOptions) -> IkResult:
    """Return the answers of the arm of a robot, in its moved base, with its external axes added."""
    whole, q = held_arm(robot), _external(robot, options.near)
    near = None if options.near is None else frozen(q[list(whole.axes)])
    X = in_arm_base(robot, whole, q, pose.matrix()[np.newaxis])[0]
    found = inverse(whole.arm, Pose.from_matrix(X), replace(options, near=near))
    return result_of_robot(whole, q, found)


def _external(robot: RobotModel, held: npt.ArrayLike | None) -> Array:
    """Return the coordinates at which external axes are held, with the other coordinates, shape (n,)."""
    return robot.home if held is None else joint_vector(robot, held)


def _held_rows(robot: RobotModel, held: npt.ArrayLike | None) -> Array:
    """Return `_external` for all poses, shape (n,), or finite rows for each of them, shape (k, n)."""
    if held is None or np.ndim(held) != 2:
        return _external(robot, held)
    rows = joint_rows(robot, held)
    if not np.isfinite(rows).all():
        raise NotFiniteError("Q")
    return rows


def _turns(variants: Array, counts: list[float]) -> tuple[Array, ...]:
    """Return the further turns of each solution, of which there are `counts`."""
    turns, end, none = [], 0, variants[:0]
    for count in counts:
        begin, end = end, end + int(count)
        turns.append(variants[begin:end] if count else none)
    return tuple(turns)


def _postures(desk: _Desk, of_rows: float) -> tuple[Posture, ...]:
    """Return the postures of rows, given the sum of 2^row of them."""
    chosen = int(of_rows)
    names = tuple([name for row, name in enumerate(desk.names) if chosen >> row & 1])
    desk.named[of_rows] = names
    return names


def _next_to(robot: RobotModel, desk: _Desk, T: Array, near: Array) -> Array | None:
    """Return the answer next to `near` (n,), found from there; None where the pose is no neighbour."""
    if not np.abs(forward_batch(robot, near[np.newaxis])[0] - T).max() <= NEIGHBOUR:
        return None
    start = near[np.newaxis, np.newaxis]
    q: Array = polished(arm_arrays(robot), T[np.newaxis], start, desk.solver.slack)[0, 0]
    return None if np.isnan(q[0]) else q


def _put(desk: _Desk, q: Array, branches: Array) -> None:
    """Put an answer q (n,) into its row, where a singular pose lets the arm have it.

    Away from singular poses it is one of the branches and nothing is done.
    """
    apart = branches - q
    apart -= desk.limits[2] * (TURN * np.round(apart / TURN))
    if not (np.abs(apart).max(axis=1) <= SAME).any():  # false for NaN
        branches[desk.solver.postures.index(desk.solver.posture(q))] = q


@lru_cache(maxsize=64)
def _desk(robot: RobotModel) -> _Desk:
    solver = solver_of(robot)
    limits = frozen(np.stack((robot.lower_limits, robot.upper_limits, turning_axes(robot))))
    unlimited = frozen(np.stack((*unbounded(robot.n), limits[2])))
    rest = frozen(np.zeros(robot.n))
    redundant, coupled = redundant_solver_of(robot), follower_limits(robot)
    return _Desk(solver, redundant, solver.postures, limits, unlimited, rest, coupled, [], {})
