"""Durations over the least ones on the very way flown, by toppra with limits of speed and acceleration only.

Random sequences of lines and of joint-space moves with zones, and of curves through points, on several arms;
with the jerk limits lifted a thousandfold, and as they are. `sh tools/venv.sh test bench` installs toppra.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from measuring import Measure
from time_optimal import least_time

from ropsim import robots
from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.kinematics import forward
from ropsim.model import RobotModel
from ropsim.motion import ProfileLimits, plan_profile
from ropsim.planning import MotionChain, MotionPlan, MotionState, MoveLimits, plan
from ropsim.spatial import Pose
from support.cells import chain_of, one_station

ARMS = ("irb120", "ur5e", "kr210_r2700_2", "panda", "scara")
EACH = 4
"""Sequences of each kind on each arm: 20 of each kind."""
MOVES = 6
LIFTED = 1e3
SPEED = 1.0
"""Programmed speed [m/s]."""
SEED = 3
MOST_REFUSED = 100


def chain(name: str, lift: float) -> MotionChain:
    """Return the entities of an arm whose torques do not count, with limits of jerk that are lifted."""
    robot, controller = replace(robots.load(name), drives=()), robots.default_controller(name)
    joints = tuple(replace(one, max_jerk=lift * one.max_jerk) for one in robot.joints)
    path = controller.path
    path = replace(path, jerk=lift * path.jerk, orientation_jerk=lift * path.orientation_jerk)
    robot = replace(robot, joints=joints)
    return chain_of(one_station("t", robot, replace(controller, path=path), start=robot.home))


def sequence(kind: MotionKind, robot: RobotModel, rng: np.random.Generator) -> list[MoveInstruction]:
    """Return random moves around the home position; a curve leads through as many points as others have."""
    X_BM, zone = forward(robot, robot.home), float(rng.uniform(0.01, 0.1))
    size = 0.25 * float(np.linalg.norm(X_BM.position))
    poses = []
    for _ in range(MOVES):
        position = X_BM.position + rng.uniform(-size, size, 3) * (1.0, 1.0, 0.5)
        turn = Pose(np.zeros(3), np.array([1.0, *rng.uniform(-0.3, 0.3, 3)]))
        poses.append(Pose(position, (X_BM if robot.n < 6 else X_BM @ turn).orientation))
    if kind is MotionKind.SPLINE:
        *via, target = poses
        return [MoveInstruction(kind, target, ModalState(path_speed=SPEED), via=tuple(via))]
    zones = (*[zone] * (MOVES - 1), 0.0)
    return [
        MoveInstruction(kind, pose, ModalState(zone=one, path_speed=SPEED))
        for pose, one in zip(poses, zones, strict=True)
    ]


def planned(kind: MotionKind, name: str, lift: float) -> Iterator[tuple[MotionPlan, RobotModel]]:
    """Yield the plans of random sequences of which no move is refused."""
    by, rng, count = chain(name, lift), np.random.default_rng(SEED), 0
    for _ in range(MOST_REFUSED):
        found, refusal = plan(by, sequence(kind, by.robot, rng), MotionState.at_rest(by.robot.home))
        if refusal is None and found is not None:
            yield found, by.robot
            count += 1
            if count == EACH:
                return


def ratios(kind: MotionKind, lift: float) -> list[float]:
    found = []
    for name in ARMS:
        for motion, robot in planned(kind, name, lift):
            limits = motion.moves[0].limits
            assert limits is not None
            tool = None if kind is MotionKind.PTP else limits.tool
            found.append(motion.duration / least_time(motion, robot, tool))
    return found


@pytest.mark.parametrize(
    ("kind", "lift", "most"),
    [
        (MotionKind.LIN, LIFTED, 1.15),
        (MotionKind.SPLINE, LIFTED, 1.25),
        (MotionKind.PTP, LIFTED, 1.25),
        (MotionKind.LIN, 1.0, 1.8),
        (MotionKind.SPLINE, 1.0, 2.0),
        (MotionKind.PTP, 1.0, 1.4),
    ],
    ids=lambda one: getattr(one, "value", None) or f"{one:g}",
)
def test_durations_over_the_least_ones(kind: MotionKind, lift: float, most: float, benchmark: Any) -> None:
    pytest.importorskip("toppra")
    measure = Measure(benchmark)
    found, _ = measure(lambda: ratios(kind, lift), rounds=1, warmup=0)
    measure.figure("sequences", len(found), least=len(ARMS) * EACH)
    measure.figure("mean", float(np.mean(found)))
    measure.figure("median", float(np.median(found)))
    measure.figure("worst", max(found), least=0.995, most=most)


def alone(by: MotionChain, move: MoveInstruction) -> tuple[MotionPlan, MoveLimits]:
    """Return the plan of one move from the home position, and its limits."""
    motion, refusal = plan(by, [move], MotionState.at_rest(by.robot.home))
    assert refusal is None
    assert motion is not None
    limits = motion.moves[0].limits
    assert limits is not None
    return motion, limits


def test_the_least_time_of_one_straight_move_is_that_of_its_closed_form(benchmark: Any) -> None:
    """From rest to rest over a distance: with the whole acceleration up to the speed, and down again."""
    pytest.importorskip("toppra")
    measure, by = Measure(benchmark), chain("irb120", LIFTED)
    robot, X_BM = by.robot, forward(by.robot, by.robot.home)
    target = Pose(X_BM.position + np.array([0.0, 0.2, -0.05]), X_BM.orientation)
    modal = ModalState(path_speed=0.3, path_acceleration=1.0)
    line, limits = alone(by, MoveInstruction(MotionKind.LIN, target, modal))
    least, _ = measure(lambda: least_time(line, robot, limits.tool), rounds=1, warmup=0)
    way = float(np.linalg.norm(target.position - X_BM.position))
    measure.figure("line", least / (way / 0.3 + 0.3), least=0.997, most=1.003)
    goal = tuple((robot.home + np.array([0.5, -0.2, 0.1, 0.3, -0.2, 0.1])).tolist())
    motion, limits = alone(by, MoveInstruction(MotionKind.PTP, goal, ModalState()))
    ways = np.abs(np.array(goal) - robot.home)
    speed, acceleration = (limits.joints.speed / ways).min(), (limits.joints.acceleration / ways).min()
    whole = plan_profile(1.0, ProfileLimits(float(speed), float(acceleration), 1e9)).duration
    measure.figure("joints", least_time(motion, robot, None) / whole, least=0.997, most=1.003)
