"""Choices that the standard path planner carries out: exact stops, and the joint limits of a time law."""

from dataclasses import replace

from ropsim.model import RobotModel
from ropsim.motion import ACCELERATION_RISES
from ropsim.planning.moves.path_planner import StandardPathPlanner
from ropsim.planning.records.motion_chain import MotionChain


def exact_stops(chain: MotionChain) -> MotionChain:
    """Return a chain whose path planner lets each path end in a stop, whatever zone the program sets.

    Args:
        chain: with the standard path planner.
    """
    planner = chain.planner
    assert isinstance(planner, StandardPathPlanner)
    return replace(chain, planner=replace(planner, stops=True))


def timed_by(name: str, chain: MotionChain) -> MotionChain:
    """Return a chain whose paths are timed by a law.

    Where accelerations of the law go in steps, those of the joints do, too: their limits of jerk are so high
    that they come to their greatest accelerations within the rise time of the law.

    Args:
        name: of the law, see `motion.TIME_LAWS`.
        chain: with the standard path planner.
    """
    chain = replace(chain, time_law=name)
    rise = ACCELERATION_RISES.get(name)
    if rise is None:
        return chain
    robot, planner = _with_rise(chain.robot, rise), chain.planner
    assert isinstance(planner, StandardPathPlanner)
    return replace(chain, robot=robot, planner=replace(planner, robot=robot))


def _with_rise(robot: RobotModel, rise: float) -> RobotModel:
    """Return an arm whose joints come to their greatest accelerations within a time [s]."""
    joints = tuple(replace(one, max_jerk=one.max_acceleration / rise) for one in robot.joints)
    return replace(robot, joints=joints)
