"""Reachable workspaces of robots of the library: published figures, inverse kinematics, sampling."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import configurations, inverse_batch
from ropsim.model import RobotModel, coupled_limits
from ropsim.spatial import Pose
from ropsim.workspace import (
    PointKind,
    Reachable,
    Resolution,
    WorkspaceError,
    distances,
    moved_point,
    reachable,
)

PUMA = robots.load("puma560")
PEDESTAL = 0.67183
"""Height of the shoulder above the base frame [m]."""
COARSE = Resolution(100, 10_000)


def wrist(robot: RobotModel, resolution: Resolution | None = None) -> Reachable:
    return reachable(robot, moved_point(robot, PointKind.WRIST_CENTRE), resolution)


def test_the_wrist_of_the_puma_has_the_published_workspace() -> None:
    """2.520 m³ by 2 million random configurations, extremes from a2, a3, d3, d4; limits of Fu et al."""
    found = wrist(PUMA)
    assert found.volume == pytest.approx(2.520, rel=0.01)
    assert found.error < 0.002
    least, most, lowest, highest = (one.value for one in found.extremes)
    assert least == pytest.approx(0.15005, abs=1e-6)  # the offset of the shoulder
    assert most == pytest.approx(0.877009, abs=1e-6)
    assert lowest - PEDESTAL == pytest.approx(-0.738, abs=5e-4)
    assert highest - PEDESTAL == pytest.approx(0.8640, abs=1e-3)


def test_inverse_kinematics_finds_the_same_volume() -> None:
    """Cells of the section that some branch of joints 2 and 3 reaches, times the arcs of joint 1."""
    h, bins = 0.015, 90
    r, z = np.meshgrid(np.arange(h / 2, 0.88, h), np.arange(-0.745, 0.87, h) + PEDESTAL, indexing="ij")
    T = np.tile(np.eye(4), (r.size, 1, 1))
    T[:, 0, 3], T[:, 2, 3] = r.ravel(), z.ravel()
    Q = inverse_batch(PUMA, T)[:, ::2]  # the flange is the wrist centre, either wrist will do
    lower, upper = PUMA.lower_limits, PUMA.upper_limits
    middle = 0.5 * (lower + upper)
    turned = Q + 2.0 * np.pi * np.round((middle - Q) / (2.0 * np.pi))
    inside = np.asarray(((turned >= lower) & (turned <= upper))[:, :, 1:3].all(axis=2))
    azimuths = (np.arange(bins) + 0.5) * 2.0 * np.pi / bins
    first = Q[:, :, :1] + azimuths
    first -= 2.0 * np.pi * np.round(first / (2.0 * np.pi))
    there = np.asarray((first >= lower[0]) & (first <= upper[0]) & inside.reshape(*inside.shape, 1))
    share = there.any(axis=1).mean(axis=1)
    volume = float((share * 2.0 * np.pi * r.ravel()).sum()) * h * h
    assert wrist(PUMA).volume == pytest.approx(volume, rel=5e-3)


def test_less_work_states_a_greater_error_that_holds() -> None:
    exact, rough = wrist(PUMA), wrist(PUMA, Resolution(60, 2_000))
    assert exact.error < rough.error
    assert abs(rough.volume - exact.volume) <= rough.error


@pytest.mark.parametrize("name", ["ur5e", "palletizer", "scara", "lr_mate_200id"])
def test_wherever_the_arm_goes_it_is_in_its_workspace(name: str) -> None:
    robot = robots.load(name)
    point = moved_point(robot, PointKind.FLANGE)
    found = reachable(robot, point, COARSE)
    Q = configurations(robot, 150)
    Q = Q[(coupled_limits(robot).excess(Q) == 0.0).all(axis=1)]
    off = distances(found, point.positions(robot, Q))
    assert len(off) > 60
    assert off.max() <= 3.0 * found.section.spacing


def test_a_place_outside_is_told_by_how_much() -> None:
    """The greatest radius is 0.877 m at the height of the shoulder."""
    found = wrist(PUMA)
    places = np.array([[-0.977009, 0.0, PEDESTAL], [0.0, 0.0, PEDESTAL + 0.3], [0.5, 0.3, PEDESTAL + 0.2]])
    off = distances(found, places)
    assert off[0] == pytest.approx(0.1, abs=2.0 * found.section.spacing)
    assert off[1] == pytest.approx(0.15005, abs=2.0 * found.section.spacing)
    assert off[2] == 0.0


def test_a_tool_makes_the_workspace_larger() -> None:
    robot = robots.load("scara")
    longer = Pose(np.array([0.1, 0.0, 0.0]))
    tool = reachable(robot, moved_point(robot, PointKind.TCP, longer), COARSE)
    bare = reachable(robot, moved_point(robot, PointKind.FLANGE), COARSE)
    assert tool.extremes[1].value == pytest.approx(bare.extremes[1].value + 0.1, abs=1e-6)
    assert tool.volume > bare.volume


@pytest.mark.parametrize("name", ["ur5e", "scara", "palletizer"])
def test_an_arm_without_wrist_centre_says_so(name: str) -> None:
    with pytest.raises(WorkspaceError) as refused:
        moved_point(robots.load(name), PointKind.WRIST_CENTRE)
    assert refused.value.diagnostic.code == "W101"


def test_the_same_question_gives_the_same_bits() -> None:
    point = moved_point(PUMA, PointKind.WRIST_CENTRE)
    one, other = (reachable.__wrapped__(PUMA, point, Resolution(60, 2_000)) for _ in range(2))
    assert one == other
