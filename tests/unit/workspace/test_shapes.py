"""Outline, surface and tool directions of workspaces."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from ropsim import robots
from ropsim.meshes import stl_bytes
from ropsim.meshes.formats.stl import read_stl
from ropsim.spatial import Array, Pose
from ropsim.workspace import (
    Directions,
    PointKind,
    Reachable,
    Resolution,
    WorkspaceError,
    dexterity,
    moved_point,
    outline,
    reachable,
    surface,
)
from ropsim.workspace.directions import azimuth_shares
from ropsim.workspace.ranges import TURN

COARSE = Resolution(100, 10_000)
FEW = Directions(6, 2)


def flange(name: str) -> Reachable:
    robot = robots.load(name)
    return reachable(robot, moved_point(robot, PointKind.FLANGE), COARSE)


def enclosed(line: Array) -> float:
    """Return the area within a closed line, negative clockwise [m²] (Gauss)."""
    x, y = line.T
    return 0.5 * float((x[:-1] * y[1:] - x[1:] * y[:-1]).sum())


@pytest.mark.parametrize("name", ["scara", "puma560"])
def test_the_outline_encloses_what_is_covered(name: str) -> None:
    section = flange(name).section
    lines = outline(section)
    assert all((line[0] == line[-1]).all() for line in lines)
    area = float(section.covered.sum()) * section.spacing**2
    assert sum(map(enclosed, lines)) == pytest.approx(area, rel=1e-3)


def test_the_surface_is_closed_and_holds_the_volume_also_as_a_file() -> None:
    found = flange("puma560")
    points, faces = surface(found)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]) @ [1, len(points)]
    back = np.concatenate([faces[:, [1, 0]], faces[:, [2, 1]], faces[:, [0, 2]]]) @ [1, len(points)]
    assert (np.sort(edges) == np.sort(back)).all()  # each edge is walked in both directions
    a, b, c = (points[faces[:, k]] for k in range(3))
    volume = float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6.0
    assert volume == pytest.approx(found.volume, rel=0.03)
    read = read_stl(stl_bytes(1e3 * points, faces)).corners
    assert np.abs(read - 1e3 * points[faces]).max() < 1e-3  # mm in single precision


def test_a_wrist_without_limits_points_everywhere() -> None:
    """The flange of the PUMA is its wrist centre: with free axes of the wrist each place has all."""
    puma = robots.load("puma560")
    free = [
        replace(one, lower=-7.0, upper=7.0) if k not in (1, 2) else one for k, one in enumerate(puma.joints)
    ]
    robot = replace(puma, joints=tuple(free))
    space = reachable(robot, moved_point(robot, PointKind.FLANGE), COARSE)
    found = dexterity(robot, space, Pose(), FEW)
    assert abs(found.volume - space.volume) <= found.error + space.error
    assert (found.share == 1.0).mean() > 0.95  # the others lie across the border


def test_a_wrist_that_cannot_turn_back_points_in_fewer_directions() -> None:
    """Joint 5 of the PUMA ends at 100°: no tool points back along the forearm."""
    puma = robots.load("puma560")
    found = dexterity(puma, flange("puma560"), Pose(), FEW)
    assert found.volume < 0.2 * flange("puma560").volume
    assert found.half > 0.8 * flange("puma560").volume


@pytest.mark.parametrize("name", ["palletizer", "irb460_110_240"])
@pytest.mark.parametrize("half", [0.5, 4.9, 14.0, 95.0])
def test_an_arm_that_keeps_its_tool_upright_points_wherever_it_reaches(name: str, half: float) -> None:
    """However narrow the first axis is: the one direction that it has, it has everywhere."""
    robot = robots.load(name)
    first = replace(robot.joints[0], lower=-radians(half), upper=radians(half))
    robot = replace(robot, joints=(first, *robot.joints[1:]))
    space = reachable(robot, moved_point(robot, PointKind.FLANGE), COARSE)
    found = dexterity(robot, space, Pose())
    assert abs(found.volume - space.volume) <= found.error + space.error
    assert found.error <= 0.05 * found.volume
    assert (found.share == 1.0).mean() > 0.95


def test_azimuths_of_all_directions_are_where_their_ranges_overlap() -> None:
    """One direction from 6.0 over the end of the turn to 1.2, another from 1.0 to 2.0."""
    first = np.array([[[6.0, 0.2, np.nan], [1.0, np.nan, np.nan]], [[np.nan] * 3, [-0.3, 0.1, -0.3]]])
    shares = azimuth_shares(first, 1.0)
    turned = TURN - 6.0 + 1.2
    assert shares[0] == pytest.approx(
        [0.5 * (turned + 1.0) / (turned + 0.8), 0.2 / TURN, (turned + 0.8) / TURN]
    )
    assert shares[1] == pytest.approx([0.5, 0.0, 1.4 / TURN])


def test_an_arm_whose_branches_are_not_all_found_says_so() -> None:
    with pytest.raises(WorkspaceError) as refused:
        dexterity(robots.load("panda"), flange("scara"), Pose())
    assert refused.value.diagnostic.code == "W105"
