"""Every arm of the house with its standard controller, as random walks take them."""

from dataclasses import replace
from functools import cache

from ropsim import robots
from ropsim.model import OrientationMode, RobotModel, on_track
from ropsim.planning import MotionChain
from support.built_in import WRITTEN
from support.cells import chain_of, one_station

TRACK, WRIST = " on a track", " with wrist angles"
LED = ("puma560", f"puma560{TRACK}")
SPECIAL = (f"puma560{TRACK}", *(f"{name}{WRIST}" for name in LED))
WALKERS = (*WRITTEN, *SPECIAL, "panda", "ur5e")
"""Arms that the tests walk: each class of wrist, few and many axes, wrist angles, an external axis."""


def every_arm() -> tuple[str, ...]:
    """Return the names of all arms that can walk."""
    return (*robots.names(), *SPECIAL)


@cache
def chain(name: str) -> MotionChain:
    """Return the entities of an arm; some are on a track, or turn their tools by wrist angles."""
    robot = _robot(name.removesuffix(WRIST))
    mode = OrientationMode.WRIST_ANGLES if name.endswith(WRIST) else OrientationMode.FIXED_AXIS
    controller = replace(robots.default_controller(robot), orientation=mode)
    return chain_of(one_station("walk", robot, controller))


def _robot(name: str) -> RobotModel:
    robot = robots.load(name.removesuffix(TRACK))
    return on_track(robot, robots.linear_track(4.0)) if name.endswith(TRACK) else robot
