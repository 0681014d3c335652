"""Ways beside a path of the tool: axes that go along, a tool that stands, a path seen from another frame."""

import numpy as np

from ropsim.motion import JointPoints, Line, Seen, Standing, evenly, numeric_points, smoothly
from ropsim.spatial import Pose

ROUNDING = 1e-12
LINE = Line(
    Pose(np.array([0.1, -0.2, 0.3]), np.array([0.9, 0.1, 0.2, 0.3])),
    Pose(np.array([0.4, 0.1, -0.2]), np.array([0.3, -0.5, 0.2, 0.1])),
)
X_RP = Pose(np.array([1.0, 0.5, -0.4]), np.array([0.2, 0.7, -0.3, 0.5]))
PLACES = np.linspace(0.0, LINE.length, 7)


def test_axes_go_evenly_from_one_place_to_another() -> None:
    start, end = np.array([0.2, -1.0]), np.array([0.8, 2.0])
    points = evenly(0.6, start, end).joints(np.array([0.0, 0.15, 0.6]))
    np.testing.assert_allclose(
        points.q, np.array([[0.2, -1.0], [0.35, -0.25], [0.8, 2.0]]), rtol=0, atol=ROUNDING
    )
    np.testing.assert_allclose(points.d1, np.tile([1.0, 5.0], (3, 1)), rtol=0, atol=ROUNDING)
    assert not points.d2.any()


def test_axes_go_smoothly_from_one_slope_and_bend_to_another() -> None:
    start, end = (
        JointPoints(*(np.array([[value]]) for value in row)) for row in ((0.2, 3.0, -5.0), (0.7, -1.0, 2.0))
    )
    curve = smoothly(0.4, start, end)
    ends = curve.joints(np.array([0.0, 0.4]))
    np.testing.assert_allclose(ends.q[:, 0], [0.2, 0.7], rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(ends.d1[:, 0], [3.0, -1.0], rtol=0, atol=1e-11)
    np.testing.assert_allclose(ends.d2[:, 0], [-5.0, 2.0], rtol=0, atol=1e-10)
    s, h = np.array([0.1, 0.23]), 1e-5
    before, here, after = (curve.joints(s + step) for step in (-h, 0.0, h))
    np.testing.assert_allclose((after.q - before.q) / (2.0 * h), here.d1, rtol=1e-7)
    np.testing.assert_allclose((after.d1 - before.d1) / (2.0 * h), here.d2, rtol=1e-7)


def test_a_tool_that_stands_has_no_way() -> None:
    stands = Standing(X_RP, 2.0)
    points = stands.tool(np.array([0.0, 1.3]))
    np.testing.assert_array_equal(points.matrices, [X_RP.matrix()] * 2)
    assert not points.d1.any()
    assert not points.d2.any()
    away = X_RP.position + np.array([[0.0, 3.0, 4.0], [0.0, 0.0, 0.0]])
    np.testing.assert_allclose(stands.distance(away), [5.0, 0.0], rtol=0, atol=ROUNDING)
    np.testing.assert_array_equal(stands.positions(np.zeros(2)), [X_RP.position] * 2)


def test_a_path_seen_from_another_frame_is_the_same_path() -> None:
    seen = Seen(LINE, X_RP)
    points, own = seen.tool(PLACES), LINE.tool(PLACES)
    np.testing.assert_allclose(points.matrices, X_RP.matrix() @ own.matrices, rtol=0, atol=ROUNDING)
    by_differences = numeric_points(lambda s: seen.tool(s).matrices, PLACES, LINE.length)
    np.testing.assert_allclose(points.d1, by_differences.d1, rtol=0, atol=1e-6)
    np.testing.assert_allclose(points.d2, by_differences.d2, rtol=0, atol=1e-3)
    np.testing.assert_allclose(seen.positions(PLACES), points.matrices[:, :3, 3], rtol=0, atol=ROUNDING)
    assert seen.length == LINE.length
    beside = np.array([[0.3, 0.2, 0.1], [2.0, 0.0, 0.5]])
    there = beside @ X_RP.rotation().T + X_RP.position
    np.testing.assert_allclose(seen.distance(there), LINE.distance(beside), rtol=0, atol=ROUNDING)
