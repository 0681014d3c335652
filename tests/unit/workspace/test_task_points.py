"""Points of a task: read from tables, reached or missed by so much, arms and bases ranked."""

from math import pi, radians

import numpy as np
import pytest

from ropsim import kinematics, robots
from ropsim.core import SourceText
from ropsim.spatial import Pose, frozen, quaternion
from ropsim.workspace import (
    Candidate,
    PointKind,
    Setting,
    TaskPoint,
    checked,
    compared,
    distances,
    moved_point,
    placements,
    reachable,
    read_points,
    size_of,
)
from ropsim.workspace.position_only import reaching

PUMA = robots.load("puma560")
TOOL = Pose(np.array([0.0, 0.0, 0.1]))


def points(text: str) -> tuple[TaskPoint, ...]:
    found, findings = read_points(SourceText("points.csv", text))
    assert not findings
    return found


def test_a_table_has_points_in_millimetres_and_degrees() -> None:
    one, other = points("name, x, y, z, roll, pitch, yaw\npick, 500, -200, 50, 180, 0, 90\nvia, 1, 2, 3\n")
    assert one.name == "pick"
    assert one.position.tolist() == [0.5, -0.2, 0.05]
    assert one.orientation is not None
    assert one.orientation == pytest.approx(quaternion.from_zyx(radians(90), 0.0, pi))
    assert other.position.tolist() == [0.001, 0.002, 0.003]
    assert other.orientation is None


def test_a_list_of_points_of_a_project_has_its_own_angles() -> None:
    """Pitch before roll: the approach direction, with the azimuth of the point where there is no yaw."""
    down, level, along_x = points(
        "name,x,y,z,pitch,roll,yaw\n,mm,mm,mm,deg,deg,deg\na,400,-300,40,90,0,0\nb,0,500,40,0,0,\nc,0,500,40,0,0,0\n"
    )
    axes = [
        Pose(one.position, one.orientation).rotation()[:, 2]
        for one in (down, level, along_x)
        if one.orientation is not None
    ]
    assert np.array(axes) == pytest.approx(np.array([[0, 0, -1], [0, 1, 0], [1, 0, 0]]), abs=1e-12)


@pytest.mark.parametrize(
    "text",
    [
        "x [m]; z (cm); y\n0.5; 5; -200",
        "name,x,y,z\n,m,mm,cm\na,0.5,-200,5\n",
        "a\t500\t-200\t50",
        "500,-200,50",
    ],
)
def test_titles_units_and_separators_are_as_people_write_them(text: str) -> None:
    (point,) = points(text)
    assert point.position == pytest.approx([0.5, -0.2, 0.05])


@pytest.mark.parametrize(
    ("text", "code", "line"),
    [
        ("x,y,z\n1,2,three\n", "W110", 2),
        ("x,y,z\n1,nan,3\n", "W110", 2),
        ("x,y,z\n1,2,inf\n", "W110", 2),
        ("x,y,z\n1,2\n", "W110", 2),
        ("x,y\n1,2\n", "W110", 1),
        ("x,y,zed\n1,2,3\n", "W110", 1),
        ("x,y,z [kg]\n1,2,3\n", "W110", 1),
        ("1,2,3,4\n", "W110", 1),
        ("x,y,z\n5e6,2,3\n", "W110", 2),
        ("x,y,z\n1_000,2,3\n", "W110", 2),
        ("x,y,z\n1,2,3,4\n", "W110", 2),
        ("name,x,y,z\n1,2,3,4,180,0,90\n", "W110", 2),
        pytest.param("x,y,z\n1,2,3\n1,2," + 140_000 * "3" + "\n", "W110", 3, id="a cell without end"),
        ("# nothing\n\n", "W111", None),
        ("", "W111", None),
    ],
)
def test_a_wrong_line_is_told_by_its_place(text: str, code: str, line: int | None) -> None:
    found, (finding,) = read_points(SourceText("points.csv", text))
    assert not found
    assert finding.code == code
    assert (finding.span.line if finding.span else None) == line


def test_an_orientation_without_columns_for_it_is_told() -> None:
    """The first line of numbers tells the columns; one of six numbers below it has three too many."""
    found, (finding,) = read_points(SourceText("points.csv", "1,2,3\n4,5,6,180,0,90\n"))
    assert len(found) == 1
    assert finding.span is not None
    assert finding.span.line == 2
    assert "`180`" in finding.message


def test_empty_cells_behind_the_columns_are_nothing() -> None:
    assert len(points("x,y,z\n1,2,3,,\n")) == 1


def test_good_lines_stay_beside_wrong_ones() -> None:
    found, findings = read_points(SourceText("points.csv", "x,y,z\n1,2,3\noh,2,3\n4,5,6\n"))
    assert [len(found), len(findings)] == [2, 1]


def test_a_point_that_the_arm_takes_is_reached_with_what_is_left_to_its_limits() -> None:
    q = PUMA.home + 0.1
    pose = kinematics.forward(PUMA, q) @ TOOL
    found = checked(Setting(PUMA, Pose(), TOOL, 0.9), TaskPoint("p", pose.position, pose.orientation))
    assert found.reach is not None
    again = kinematics.forward(PUMA, found.reach.q) @ TOOL
    assert again.position == pytest.approx(pose.position, abs=1e-9)
    left = np.minimum(found.reach.q - PUMA.lower_limits, PUMA.upper_limits - found.reach.q)
    half = 0.5 * (PUMA.upper_limits - PUMA.lower_limits)
    assert found.reach.margin.share == pytest.approx((left / half).min())
    assert found.reach.margin.left == pytest.approx(left[found.reach.margin.joint])
    own = np.minimum(q - PUMA.lower_limits, PUMA.upper_limits - q) / half
    assert found.reach.margin.share >= own.min() - 1e-9


@pytest.mark.parametrize("name", ["scara", "two_link", "ur5e"])
def test_where_any_orientation_will_do_a_place_is_reached(name: str) -> None:
    robot = robots.load(name)
    place = kinematics.forward(robot, robot.home).position
    found = checked(Setting(robot, Pose(), Pose(), 1.0), TaskPoint("p", place))
    assert found.reach is not None
    assert kinematics.forward(robot, found.reach.q).position == pytest.approx(place, abs=1e-6)


def test_a_place_out_of_reach_is_missed_by_the_distance() -> None:
    """A planar arm of 2 m: 2.5 m away half a metre is missing."""
    robot = robots.load("two_link")
    place = kinematics.forward(robot, np.zeros(2)).position
    found = checked(Setting(robot, Pose(), Pose(), 2.0), TaskPoint("p", frozen(1.25 * place)))
    assert found.reach is None
    assert found.miss is not None
    assert found.miss.distance == pytest.approx(0.25 * float(np.linalg.norm(place)), abs=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["irb460_110_240", "cobra600"])
def test_a_miss_is_told_as_the_distance_to_the_workspace(name: str) -> None:
    """By steps of the axes and by the raster of the section, which is exact to its spacing."""
    robot = robots.load(name)
    space = reachable(robot, moved_point(robot, PointKind.FLANGE))
    size = 1.5 * max(abs(one.value) for one in space.extremes)
    places = np.random.default_rng(7).uniform(-size, size, (40, 3))
    off = distances(space, places)
    far = np.flatnonzero(off > 0.0)[:20]
    assert len(far) == 20
    told = np.array([reaching(robot, np.zeros(3), one)[1] for one in places[far]])
    cell = float(np.sqrt(2.0)) * space.section.spacing
    assert (told <= off[far] + cell).all()
    assert (told >= off[far] - 2.0 * cell).all()


def test_an_arm_that_stands_at_its_limits_comes_as_near_as_the_other_axes_let_it() -> None:
    """Axes at 113.59°, 40.06° and -19.37° leave 245 mm."""
    robot = robots.load("irb460_110_240")
    found = checked(Setting(robot, Pose(), Pose(), 2.4), TaskPoint("p", frozen([-0.92, 2.07, 1.69])))
    assert found.miss is not None
    assert 0.2 < found.miss.distance <= 0.245


def test_task_and_base_moved_together_change_nothing() -> None:
    X_WB = Pose(np.array([1.0, -2.0, 0.3]), np.array(quaternion.from_zyx(0.7, 0.0, 0.0)))
    pose = kinematics.forward(PUMA, PUMA.home)
    moved = X_WB @ pose
    here = checked(Setting(PUMA, Pose(), Pose(), 0.9), TaskPoint("p", pose.position, pose.orientation))
    there = checked(Setting(PUMA, X_WB, Pose(), 0.9), TaskPoint("p", moved.position, moved.orientation))
    assert here.reach is not None
    assert there.reach is not None
    assert there.reach.q == pytest.approx(here.reach.q, abs=1e-9)
    assert there.reach.manipulability == pytest.approx(here.reach.manipulability)


def test_manipulability_counts_lengths_in_units_of_the_reach() -> None:
    """Of the six rows of the Jacobian three are lengths, so √det(J·Jᵀ) goes with the third power of them."""
    pose = kinematics.forward(PUMA, PUMA.home + 0.3)
    point = TaskPoint("p", pose.position, pose.orientation)
    whole, half = (checked(Setting(PUMA, Pose(), Pose(), size), point).reach for size in (0.9, 0.45))
    assert whole is not None
    assert half is not None
    assert whole.manipulability > 0.01
    assert half.manipulability == pytest.approx(8.0 * whole.manipulability)


def test_candidates_are_ranked_by_points_then_by_margin() -> None:
    pose = kinematics.forward(PUMA, PUMA.home)
    task = [TaskPoint("p", pose.position, pose.orientation)]
    far, near = (
        Candidate(PUMA, Pose(np.array([x, 0.0, 0.0])), name) for x, name in ((5.0, "far"), (0.0, "near"))
    )
    scara = Candidate(robots.load("scara"), Pose(), "scara")
    ranked = compared([far, scara, near], task, Pose())
    assert ranked[0].candidate == near
    assert [one.reached for one in ranked] == [1, 0, 0]
    assert ranked[0].manipulability > 0.0


def test_bases_are_tried_all_around_the_points() -> None:
    task = [TaskPoint("a", frozen([1.0, 0.0, 0.0])), TaskPoint("b", frozen([3.0, 2.0, 0.0]))]
    places = np.array([one.position for one in placements(task, 0.9, 0.2, 3)])
    assert places.mean(axis=0) == pytest.approx([2.0, 1.0, 0.2])
    assert np.ptp(places, axis=0) == pytest.approx([1.8, 1.8, 0.0])


def test_the_size_of_an_arm_is_its_largest_radius() -> None:
    assert size_of(robots.load("scara"), Pose()) == pytest.approx(0.6, abs=1e-9)
