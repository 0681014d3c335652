"""Masses of palletizers by rule: shares of the mass of the arm for column, arms, crank, rods and wrist.

The shares are unproven: no maker publishes masses of the links of palletizers.
"""

import numpy as np

from ropsim.kinematics import frames_batch
from ropsim.model import Link, RobotModel
from ropsim.robotfile.estimation.link_masses import cylinder
from ropsim.robotfile.estimation.recognition import level_chain
from ropsim.spatial import Array

COLUMN, LOWER_ARM, FOREARM, CRANK, RODS = 0.34, 0.18, 0.15, 0.05, 0.05
WRIST, FLANGE = 0.03, 0.01
"""Shares of the mass of the arm with its base."""
_MIDDLE = 0.5
_PARALLEL = 1e-9


def palletizer_links(robot: RobotModel, total: float) -> tuple[Link, ...]:
    """Return the links of a palletizer with masses by rule, as cylinders from joint to joint.

    A rod of a parallelogram is as long as the arm that it stays parallel to; bodies next to the arms that are
    parallel to none, such as triangles, reach from joint to joint. They share one mass equally.

    Args:
        robot: a palletizer (`level_chain`).
        total: mass with the base [kg].
    """
    chain = level_chain(robot)
    shares = dict(zip(chain, (COLUMN, LOWER_ARM, FOREARM, WRIST, FLANGE), strict=True)) | {
        robot.axes[2]: CRANK
    }
    rods = [number for number in range(len(robot.links)) if number not in shares]
    shares |= {number: RODS / len(rods) for number in rods}
    lines = _lines(robot, chain)
    found = []
    for number, (link, (begin, end)) in enumerate(zip(robot.links, lines, strict=True)):
        made = cylinder(begin, end, total * shares[number], _MIDDLE)
        found.append(Link(made.mass, made.com, made.inertia, link.shapes))
    return tuple(found)


def palletizer_length(robot: RobotModel) -> float:
    """Return the length of the stretched palletizer from axis 2 to the wrist and on to axis 4 [m]."""
    _, *chain = level_chain(robot)
    places = frames_batch(robot, robot.home[None])[0, chain, :3, 3]
    return float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum())


def _lines(robot: RobotModel, chain: tuple[int, ...]) -> list[tuple[Array, Array]]:
    """Return from where to where the bodies reach, in the frames of their joints [m]."""
    moved = robot.home + 0.1 * np.arange(1.0, robot.n + 1.0)
    frames = frames_batch(robot, np.array([robot.home, moved]))
    origins = frames[0, :, :3, 3]
    column, arm, forearm, wrist, flange = chain
    ends = {
        column: origins[arm],
        arm: origins[forearm],
        forearm: origins[wrist],
        wrist: origins[flange],
        flange: origins[-1],
    }
    found = []
    for number in range(len(robot.links)):
        begin = origins[number]
        if number == column:
            begin = begin * np.array([1.0, 1.0, 0.0])
        parallel = next((one for one in (arm, forearm) if _is_parallel(frames, number, one)), None)
        child = next((k for k, joint in enumerate(robot.joints) if joint.parent == number), None)
        if number in ends:
            end = ends[number]
        elif child is not None:
            end = origins[child]
        else:
            end = begin + (ends[parallel] - origins[parallel] if parallel is not None else 0.0)
        X_JB = np.linalg.inv(frames[0, number])
        first, last = ((X_JB @ [*point, 1.0])[:3] for point in (begin, end))
        found.append((first, last))
    return found


def _is_parallel(frames: Array, one: int, other: int) -> bool:
    """Return whether a body keeps its direction to another one while the axes move."""
    relative = frames[:, other, :3, :3].transpose(0, 2, 1) @ frames[:, one, :3, :3]
    return bool(np.abs(relative[0] - relative[1]).max() < _PARALLEL)
