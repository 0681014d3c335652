"""Workspaces: the wrist centre of the PUMA 560 within 1 % in two seconds, and flanges of other arms."""

from typing import Any

import pytest
from measuring import Measure

import ropsim
from ropsim.model import RobotModel
from ropsim.spatial import Pose
from ropsim.workspace import PointKind, Reachable, dexterity, moved_point, reachable

EXACT = 2.51654
"""Volume [m³] by inverse kinematics on a grid of 2 mm and 1440 azimuths."""


def computed(robot: RobotModel, kind: PointKind) -> Reachable:
    """Return a workspace that is not remembered."""
    return reachable.__wrapped__(robot, moved_point(robot, kind))


def test_the_wrist_of_the_puma(benchmark: Any) -> None:
    measure = Measure(benchmark)
    robot = ropsim.robots.load("puma560")
    found, time = measure(lambda: computed(robot, PointKind.WRIST_CENTRE), rounds=5)
    measure.figure("s", time.best, most=2.0)
    measure.figure("volume [m3]", found.volume)
    measure.figure("stated error [%]", 100.0 * found.error / found.volume, most=1.0)
    measure.figure("error [%]", 100.0 * abs(found.volume - EXACT) / EXACT, most=0.1)


@pytest.mark.parametrize("name", ["irb120", "ur5e", "panda"])
def test_the_flange(benchmark: Any, name: str) -> None:
    measure = Measure(benchmark)
    robot = ropsim.robots.load(name)
    found, time = measure(lambda: computed(robot, PointKind.FLANGE), rounds=1)
    measure.figure("s", time.best)
    measure.figure("stated error [%]", 100.0 * found.error / found.volume, most=5.0)


def test_the_tool_directions_of_the_puma(benchmark: Any) -> None:
    measure = Measure(benchmark)
    robot = ropsim.robots.load("puma560")
    space = computed(robot, PointKind.FLANGE)
    _, time = measure(lambda: dexterity.__wrapped__(robot, space, Pose()), rounds=2)
    measure.figure("s", time.best)
