"""The dexterous workspace: in how many directions the tool can point at each place, where in all of them."""

from functools import lru_cache

import numpy as np

from ropsim.kinematics import Method, inverse_batch, redundant_solver_of, solver_of, turning_axes
from ropsim.model import RobotModel, coupled_limits
from ropsim.spatial import Array, Pose, record
from ropsim.workspace.diagnostics import WorkspaceError, no_dexterity
from ropsim.workspace.directions import azimuth_shares, orientations, sphere
from ropsim.workspace.ranges import TURN
from ropsim.workspace.volume.reachable import Reachable
from ropsim.workspace.volume.sweep import SweepKind, whole_turn

AT_ONCE = 40_000
"""Poses that are solved in one go."""
MOST_POSES, MOST_CELLS = 40_000, 1_000
"""Work that takes about a second."""
SLACK = 1e-9
"""Rounding of a coordinate that stands on its limit [rad | m]."""
HELD = 6
"""Sampled values of the free coordinate of an arm of seven axes at a pose."""
FEW = 6
"""Axes below which an arm cannot turn its tool in all directions."""


@record
class Directions:
    """The tool directions that are requested.

    They are turned with the azimuth of the place, as the arm is by its first axis.

    Attributes:
        count: directions, spread evenly over the sphere.
        rolls: turns about the direction that are tried; one that is reached is enough.
    """

    count: int = 26
    rolls: int = 4


@record
class Dexterity:
    """Share of the directions that is reached, in square cells of the section.

    Attributes:
        directions: that were requested; of an arm with fewer than six axes only the one that it has at home.
        size: side of a cell [m].
        centres: radius and height of the cells that are reached [m], shape (k, 2).
        share: of directions, the mean over the azimuths at which the cell is reached, shape (k,).
        volume: where all directions are reached [m³].
        error: difference to cells of twice the side, and the open area of cells along the border [m³].
        half: where half of the directions or more are reached [m³].
        half_error: of that, in the same way [m³].
    """

    directions: Directions
    size: float
    centres: Array
    share: Array
    volume: float
    error: float
    half: float
    half_error: float


@lru_cache(maxsize=32)
def dexterity(
    robot: RobotModel, workspace: Reachable, X_MT: Pose, directions: Directions | None = None
) -> Dexterity:
    """Return in which share of the directions a tool can point within the workspace of its TCP.

    Args:
        robot: the arm.
        workspace: of the TCP of the tool, or of the flange without one.
        X_MT: tool frame in the frame of the mechanical interface.
        directions: that are requested; None for the usual ones.

    Raises:
        WorkspaceError: W105, the arm has no solver that finds all branches, or its first axis turns nothing.
    """
    solver = solver_of(robot)
    turns = workspace.sweep.kind is SweepKind.TURN
    free = redundant_solver_of(robot) is not None
    exact = solver.method is Method.CLOSED_FORM
    if solver.method is Method.NUMERIC or (free and not exact) or not turns or robot.external:
        raise WorkspaceError(no_dexterity(robot.name))
    tools = _tools(robot, workspace, X_MT, directions or Directions())
    poses = MOST_POSES if exact else MOST_POSES // 8
    count = min(poses // (tools.shape[0] * tools.shape[1] * (HELD if free else 1)), MOST_CELLS)
    fine = _cells(workspace, count)
    share, arcs, half = _shares(robot, workspace, X_MT, fine[1], tools)
    volume = _volume(*fine, arcs)
    rough = _cells(workspace, count // 4)
    _, rough_arcs, rough_half = _shares(robot, workspace, X_MT, rough[1], tools)
    error = abs(volume - _volume(*rough, rough_arcs)) + _left_open(*fine, arcs)
    most = _volume(*fine, half)
    half_error = abs(most - _volume(*rough, rough_half)) + _left_open(*fine, half)
    used = Directions(len(tools), tools.shape[1])
    return Dexterity(used, fine[0], fine[1], share, volume, error, most, half_error)


def _tools(robot: RobotModel, workspace: Reachable, X_MT: Pose, directions: Directions) -> Array:
    """Return orientations of the tool in the frame of the sweep, shape (directions, rolls, 3, 3)."""
    if robot.n >= FEW:
        made = orientations(sphere(directions.count), directions.rolls)
        return made.reshape(directions.count, directions.rolls, 3, 3)
    from ropsim.kinematics import forward

    home = workspace.sweep.X_BS[:3, :3].T @ (forward(robot, robot.home) @ X_MT).matrix()[:3, 2]
    return orientations(home[np.newaxis], 12)[np.newaxis]


def _cells(workspace: Reachable, count: int) -> tuple[float, Array]:
    """Return side and centres of about `count` cells of the section that are reached, shape (k, 2)."""
    section = workspace.section
    area = float(section.covered.sum()) * section.spacing**2
    size = max((area / max(count, 1)) ** 0.5, section.spacing)
    places = section.places()[section.covered > 0.0]
    numbers, weight = np.unique(np.floor(places / size).astype(int), axis=0, return_counts=True)
    kept = weight * section.spacing**2 > 0.5 * size * size
    return size, (numbers[kept] + 0.5) * size


def _shares(
    robot: RobotModel, workspace: Reachable, X_MT: Pose, centres: Array, tools: Array
) -> tuple[Array, Array, Array]:
    """Return the share of directions, and the shares of azimuths with all and with half of them, (k,)."""
    back, X_BS = X_MT.inverse().matrix(), workspace.sweep.X_BS
    d, rolls = tools.shape[:2]
    at_once = max(1, AT_ONCE // (d * rolls))
    found = [np.empty((0, 3))]
    for start in range(0, len(centres), at_once):
        some = centres[start : start + at_once]
        T = np.zeros((len(some), d, rolls, 4, 4))
        T[..., :3, :3], T[..., 3, 3] = tools, 1.0
        T[..., 0, 3], T[..., 2, 3] = some[:, 0, np.newaxis, np.newaxis], some[:, 1, np.newaxis, np.newaxis]
        first = _first_axes(robot, workspace, (X_BS @ T @ back).reshape(-1, 4, 4)).reshape(len(some), d, -1)
        if whole_turn(workspace.sweep):
            count = np.isfinite(first).any(axis=2).sum(axis=1)
            found.append(np.stack((count / d, count == d, 2 * count >= d), axis=1))
        else:
            found.append(azimuth_shares(first, float(workspace.ranges.extent[0])))
    share, arc, half = np.concatenate(found).T
    return share, arc, half


def _first_axes(robot: RobotModel, workspace: Reachable, T: Array) -> Array:
    """Return places of the first axis, in any turn, for poses (k, 4, 4) that the others can take.

    Returns:
        [rad], NaN where a limit of another axis is broken, shape (k, m).
    """
    ranges = workspace.ranges
    turning = turning_axes(robot)
    centre = 0.5 * (ranges.lower + ranges.upper)
    found = []
    for held in _held(robot, workspace):
        Q = inverse_batch(robot, T, held)
        Q = Q + TURN * turning * np.round((centre - Q) / TURN)
        inside = np.logical_and(ranges.lower - SLACK <= Q, ranges.upper + SLACK >= Q)
        good = np.logical_and.reduce(inside[:, :, 1:], axis=2)
        if coupled_limits(robot).joints:
            good &= np.logical_and.reduce(coupled_limits(robot).excess(Q) == 0.0, axis=-1)
        found.append(np.where(good, Q[:, :, 0], np.nan))
    return np.concatenate(found, axis=1)


def _held(robot: RobotModel, workspace: Reachable) -> list[Array | None]:
    """Return axes at which a redundant arm holds its free coordinate; None for another arm."""
    if redundant_solver_of(robot) is None:
        return [None]
    ranges = workspace.ranges
    shares = (np.arange(HELD) + 0.5) / HELD
    rows = np.tile(robot.home, (HELD, 1))
    rows[:, 2] = ranges.lower[2] + shares * ranges.extent[2]
    return list(rows)


def _volume(size: float, centres: Array, arcs: Array) -> float:
    """Return the volume of cells that are turned about the axis, each for its share of the turn [m³]."""
    return float((centres[:, 0] * arcs).sum()) * TURN * size * size


def _left_open(size: float, centres: Array, arcs: Array) -> float:
    """Return the open area of cells along the border, as in `reachable`: about 4·√k of k cells lie there."""
    there = arcs > 0.0
    if not there.any():
        return 0.0
    border = 4.0 * float(np.count_nonzero(there)) ** 0.5
    turn = TURN * float(arcs[there].mean())
    return float(3.0 * np.sqrt(border / 12.0) * turn * size * size * centres[:, 0].mean())
