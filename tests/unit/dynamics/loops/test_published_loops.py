"""Published mechanisms with closed chains move as published."""

import numpy as np
import pytest

from ropsim.dynamics import free_motion
from ropsim.model import Direction, RobotModel
from ropsim.spatial import Array
from support.loops import (
    ANDREWS_END,
    ANDREWS_START,
    ANDREWS_TORQUE,
    IN_PLANE,
    PIN,
    andrews,
    bricard,
    energies,
    four_bars,
)

FOUR_BARS = 2
TIMES = (0.5, 1.0, 2.5, 5.0, 7.5, 10.0)
TIPS = np.array(
    [
        [0.6952866332, 0.7187325634],
        [-0.1950203019, -0.9807992057],
        [0.8072373605, 0.5902269427],
        [-0.8113104610, -0.5846155454],
        [-0.3041628242, 0.9526200588],
        [0.3284581115, 0.9445185382],
    ]
)
"""End of the first crank of problem A02 of the library of the IFToMM with N = 2 loops, at `TIMES` [m]. All
cranks stay parallel: θ'' = b/a·sin(θ), a = (N + 1)/3 + N, b = ((N + 1)/2 + N)·g, θ(0) = 0, θ'(0) = 1."""


def tips(y: Array) -> Array:
    return np.stack((np.cos(y[:, 0]), np.sin(y[:, 0])), axis=1)


@pytest.mark.parametrize("held", [IN_PLANE, PIN], ids=["plane", "pins"])
def test_the_four_bars_pass_their_singular_pose(held: tuple[Direction, ...]) -> None:
    """They lie flat again and again, where each could fold; pins in space hold three rows each twice."""
    robot = four_bars(FOUR_BARS, held)
    up, down = [np.pi / 2] * (FOUR_BARS + 1), [-np.pi / 2] * FOUR_BARS
    v = [-1.0] * (FOUR_BARS + 1) + [1.0] * FOUR_BARS
    motion = free_motion(robot, up + down, v, 1e-3, 10_000, every=500)
    rows = [round(time / 0.5) for time in TIMES]
    assert np.abs(tips(motion.y)[rows] - TIPS).max() < 2e-9  # found 1e-10
    assert motion.gap.max() < 1e-9
    cranks = motion.yd[:, : FOUR_BARS + 1]
    assert np.abs(cranks - cranks[:, :1]).max() < 1e-6


def test_andrews_mechanism_ends_where_published() -> None:
    motion = free_motion(andrews(), ANDREWS_START, np.zeros(7), 1e-5, 3000, tau=[ANDREWS_TORQUE], every=3000)
    assert np.abs(motion.y[-1] - ANDREWS_END).max() < 5e-9  # found 1.5e-9
    assert motion.yd[-1, :3] == pytest.approx([1139.920302151208, -1424.379294994111, 11.03291221937134])
    assert motion.gap.max() < 1e-9


@pytest.mark.parametrize("robot", [bricard(), four_bars(FOUR_BARS, PIN)], ids=["Bricard", "four bars"])
def test_energy_and_loops_are_kept_for_ten_seconds(robot: RobotModel) -> None:
    """Bricard's mechanism falls from its cube and swings; a row of its cut is redundant."""
    y, yd = np.zeros(len(robot.joints)), np.zeros(len(robot.joints))
    if len(robot.cuts) == FOUR_BARS:
        y[:3], y[3:], yd[:3], yd[3:] = np.pi / 2, -np.pi / 2, -1.0, 1.0
    motion = free_motion(robot, y, yd, 1e-3, 10_000, every=20)
    found = energies(robot, motion.y, motion.yd)
    assert np.ptp(motion.y[:, 0]) > 1.0
    assert np.abs(found - found[0]).max() < 1e-6  # [J] of 60 J that move; found 1e-8
    assert motion.gap.max() < 1e-9
