"""Random chains of short straight moves with zones that an arm can make with its tool down."""

from dataclasses import replace

import numpy as np

from ropsim import robots
from ropsim.core import Span
from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin
from ropsim.kinematics import inverse
from ropsim.model import RobotModel
from ropsim.planning import MotionChain
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station

AMID = 0.42, 0.0, 0.4  # [m], within the reach of small arms
DOWN: Array = np.array([0.0, 1.0, 0.0, 0.0])
REACH = 0.25  # [m], to both sides
FINE = 0.03
"""Share of the points at which the tool stops."""


def random_short_lines(
    rng: np.random.Generator, robot: RobotModel
) -> tuple[MotionChain, list[MoveInstruction], Array]:
    """Return a chain of 2 to 240 lines of 0.5 to 20 mm: entities, moves, joint positions at the start.

    The points wind, some with noise; zones are of any size up to the moves; path limits are the standard
    ones of the arm or those that its joints allow.

    Args:
        rng: decides.
        robot: a small arm.
    """
    n = int(np.exp(rng.uniform(np.log(2.0), np.log(241.0))))
    step = np.exp(rng.uniform(np.log(5e-4), np.log(0.02)))
    steps = step * np.exp(rng.choice([0.0, 0.5]) * rng.normal(size=n))
    along = np.append(0.0, np.cumsum(steps))
    radius, aside = np.exp(rng.uniform(np.log(0.02), np.log(0.3))), REACH * rng.uniform(-0.4, 0.4)
    x = 0.02 * np.sin(along / radius * rng.uniform(0.5, 3.0))
    y = REACH * np.sin((along - 0.5 * along[-1]) / REACH) + aside
    z = 0.02 * np.sin(along / radius * rng.uniform(0.2, 1.0))
    noise = step * rng.choice([0.0, 0.001, 0.03]) * rng.normal(size=(n + 1, 3))
    points = np.stack((x, y, z), axis=1) + AMID + noise
    zones = step * rng.uniform(0.05, 0.9) * np.exp(rng.choice([0.0, 0.5]) * rng.normal(size=n))
    zones[rng.random(n) < FINE] = zones[-1] = 0.0
    speed = float(np.exp(rng.uniform(np.log(0.02), np.log(1.0))))
    moves = [
        MoveInstruction(
            MotionKind.LIN,
            Pose(point, DOWN),
            ModalState(path_speed=speed, zone=zone),
            Origin(Span.on_line("lines.task", line, 1, 9), 0),
        )
        for line, (point, zone) in enumerate(zip(points[1:], zones.tolist(), strict=True), 1)
    ]
    controller = robots.default_controller(robot)
    own = robots.path_limits_of_joints(robot)
    if own and rng.random() < 0.5:
        controller = replace(controller, path=own)
    chain = chain_of(one_station("lines", robot, controller))
    return chain, moves, inverse(robot, Pose(points[0], DOWN)).solutions[0]
