"""Lines: straight, of the length of the way, turning evenly."""

import math

import numpy as np
import pytest

from ropsim.motion import Line, OrientationMode, enter_distances, tool_turn
from ropsim.spatial import Pose
from support.paths import brute_distances, inner_places, random_pose, tool_differences

ROUNDING = 1e-12
DIFFERENCES = 1e-9  # of order 4 over 1/1000 of a length of metres
MODES = list(OrientationMode)


@pytest.mark.parametrize("mode", MODES)
def test_a_line_leads_from_its_start_to_its_end(mode: OrientationMode) -> None:
    rng = np.random.default_rng(1)
    start, end = random_pose(rng), random_pose(rng)
    line = Line(start, end, mode)
    ends = line.tool(np.array([0.0, line.length])).matrices
    assert np.abs(ends - [start.matrix(), end.matrix()]).max() < ROUNDING


@pytest.mark.parametrize("mode", MODES)
def test_the_derivatives_of_a_line_are_those_of_its_poses(mode: OrientationMode) -> None:
    rng = np.random.default_rng(2)
    line = Line(random_pose(rng), random_pose(rng), mode)
    s = inner_places(line.length)
    d1, d2 = tool_differences(line, s, 1e-3 * line.length)
    assert np.abs(line.tool(s).d1 - d1).max() < DIFFERENCES
    assert np.abs(line.tool(s).d2 - d2).max() < DIFFERENCES


@pytest.mark.parametrize("mode", MODES)
def test_the_tool_turns_as_it_does_on_any_path_of_its_mode(mode: OrientationMode) -> None:
    """The compiled loop of a line beside the sums of arrays that arcs use."""
    rng = np.random.default_rng(4)
    for _ in range(20):
        line = Line(random_pose(rng), random_pose(rng), mode)
        s = line.length * np.linspace(0.0, 0.99, 12)
        found, wanted = line.tool(s), tool_turn(line.X_start, line.X_end, mode).at(s / line.length)
        assert np.abs(found.matrices[:, :3, :3] - wanted.rotations).max() < ROUNDING
        assert np.abs(found.d1[:, 3:] * line.length - wanted.d1).max() < ROUNDING
        assert np.abs(found.d2[:, 3:] * line.length**2 - wanted.d2).max() < ROUNDING


@pytest.mark.parametrize("mode", MODES)
def test_at_its_end_a_line_is_there_to_the_bit(mode: OrientationMode) -> None:
    rng = np.random.default_rng(5)
    for _ in range(20):
        line = Line(random_pose(rng), random_pose(rng), mode)
        assert line.tool(np.array([line.length])).matrices[0].tolist() == line.X_end.matrix().tolist()


def test_a_drive_transform_turns_with_angular_acceleration() -> None:
    line = Line(Pose(), Pose(np.ones(3), np.array([0.5, 0.1, 0.5, 0.4])), OrientationMode.DRIVE_TRANSFORM)
    assert np.linalg.norm(line.tool(inner_places(line.length)).d2[:, 3:], axis=1).min() > 0.01


def test_the_length_is_the_way_of_the_tcp() -> None:
    line = Line(Pose(), Pose(np.array([0.3, 0.4, 1.2]), np.array([0.0, 1.0, 0.0, 0.0])))
    assert line.length == pytest.approx(1.3, rel=ROUNDING)
    assert line.tool(inner_places(1.3)).d1[:, :3] == pytest.approx(
        np.tile([0.3 / 1.3, 0.4 / 1.3, 1.2 / 1.3], (23, 1)), rel=ROUNDING
    )


def test_where_the_tcp_stands_the_length_is_the_angle() -> None:
    end = Pose(np.array([1e-10, 0.0, 0.0]), np.array([math.cos(0.4), 0.0, 0.0, math.sin(0.4)]))
    line = Line(Pose(), end)
    assert line.length == pytest.approx(0.8, rel=ROUNDING)
    points = line.tool(np.array([0.0, 0.2, 0.8]))
    assert points.d1[:, 5] == pytest.approx(np.ones(3), rel=ROUNDING)
    assert math.atan2(points.matrices[1, 1, 0], points.matrices[1, 0, 0]) == pytest.approx(0.2, rel=ROUNDING)


def test_where_nothing_moves_there_is_no_length() -> None:
    line = Line(Pose(), Pose(np.array([0.0, 1e-10, 0.0]), np.array([1.0, 1e-10, 0.0, 0.0])))
    assert line.length == 0.0
    points = line.tool(np.zeros(2))
    assert np.isfinite(points.matrices).all()
    assert not points.d1.any()
    assert line.positions(np.zeros(2)).tolist() == [[0.0, 0.0, 0.0]] * 2


def test_the_distance_is_that_from_the_segment() -> None:
    line = Line(Pose(), Pose(np.array([2.0, 0.0, 0.0])))
    points = np.array([[1.0, 3.0, 4.0], [-3.0, 0.0, 4.0], [5.0, 4.0, 0.0], [0.5, 0.0, 0.0]])
    assert line.distance(points).tolist() == pytest.approx([5.0, 5.0, 5.0, 0.0], abs=ROUNDING)


def test_the_distance_from_a_line_without_length_is_that_from_its_start() -> None:
    assert Line(Pose(), Pose()).distance(np.array([[0.0, 3.0, 4.0]])).tolist() == [5.0]


def test_the_distance_agrees_with_a_search() -> None:
    rng = np.random.default_rng(3)
    line = Line(random_pose(rng), random_pose(rng))
    points = rng.normal(size=(50, 3)) * 2.0
    brute = brute_distances(line, points)
    assert (line.distance(points) <= brute + ROUNDING).all()
    assert line.distance(points) == pytest.approx(brute, abs=1e-6)


def test_positions_are_those_of_the_poses() -> None:
    rng = np.random.default_rng(4)
    line = Line(random_pose(rng), random_pose(rng))
    s = inner_places(line.length)
    assert np.abs(line.positions(s) - line.tool(s).matrices[:, :3, 3]).max() == 0.0


def test_distances_from_many_lines_are_those_from_each_one() -> None:
    chosen = np.random.default_rng(8)
    lines = [Line(Pose(start), Pose(end)) for start, end in chosen.normal(size=(3, 2, 3))]
    lines.append(Line(Pose(np.ones(3)), Pose(np.ones(3))))
    points, spans = chosen.normal(size=(40, 3)), [(2, 11), (11, 11), (15, 30), (30, 37)]
    points[5] = np.nan
    distances = np.full(40, -1.0)
    enter_distances(lines, spans, points, distances)
    for line, (first, last) in zip(lines, spans, strict=True):
        across = points[first:last, np.newaxis] - line.positions(np.linspace(0.0, line.length, 2001))
        fine = np.linalg.norm(across, axis=2).min(axis=1)
        np.testing.assert_allclose(distances[first:last], fine, rtol=0.0, atol=1e-5)
    on_none = np.ones(40, dtype=bool)
    for first, last in spans:
        on_none[first:last] = False
    assert set(distances[on_none].tolist()) == {-1.0}
