"""Splines: through every point, smooth to second derivatives over their way, the same in every frame."""

import math

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from ropsim.motion import Curve, SplineFault, spline
from ropsim.spatial import Pose
from support.paths import brute_distances, inner_places, random_pose, tool_differences

ROUNDING = 1e-12
STEPS = 1e-7  # of a way; to see both sides of a point


def poses(count: int, seed: int = 40) -> list[Pose]:
    """Return points of a winding way, each a few decimetres and half a radian from the last."""
    rng = np.random.default_rng(seed)
    along = np.arange(count) * 0.3
    places = (
        np.stack((along, np.sin(along), np.cos(0.7 * along)), axis=1) + rng.normal(size=(count, 3)) * 0.05
    )
    turned = Rotation.identity()
    found = []
    for place in places:
        turned = turned * Rotation.from_rotvec(rng.normal(size=3) * 0.3)
        found.append(Pose(place, np.roll(turned.as_quat(), 1)))
    return found


def made(points: list[Pose]) -> Curve:
    """Return a spline that there is."""
    found = spline(points)
    assert isinstance(found, Curve)
    return found


POINTS = poses(9)
CURVE = made(POINTS)


@pytest.mark.parametrize("count", [2, 3, 4, 50])
def test_every_point_is_passed(count: int) -> None:
    points = poses(count)
    curve = made(points)
    passed = curve.tool(curve.knots).matrices
    assert np.abs(passed - [point.matrix() for point in points]).max() < ROUNDING


def test_the_derivatives_of_a_spline_are_those_of_its_poses() -> None:
    s = inner_places(CURVE.length, 40)
    d1, d2 = tool_differences(CURVE, s, 1e-4)
    assert np.abs(CURVE.tool(s).d1 - d1).max() < 1e-8
    assert np.abs(CURVE.tool(s).d2 - d2).max() < 1e-7
    assert np.abs(np.linalg.norm(CURVE.tool(s).d1[:, :3], axis=1) - 1.0).max() < ROUNDING


@pytest.mark.parametrize("turn", [0.3, 2.0, 3.1])
def test_derivatives_go_over_at_every_point(turn: float) -> None:
    rng = np.random.default_rng(41)
    axes = rng.normal(size=(8, 3))
    turned = [Rotation.identity()]
    for axis in axes:
        turned.append(turned[-1] * Rotation.from_rotvec(axis / np.linalg.norm(axis) * turn))
    points = [Pose(p.position, np.roll(r.as_quat(), 1)) for p, r in zip(POINTS, turned, strict=True)]
    curve = made(points)
    # the last polynomial of one segment and the first of the next one, at the point itself
    inner = curve.knots[1:-1]
    before, after = curve.tool(np.nextafter(inner, 0.0) - 1e-13), curve.tool(inner)
    size = np.abs(after.d2).max()
    assert np.abs(before.matrices - after.matrices).max() < 1e-10
    assert np.abs(before.d1 - after.d1).max() < 1e-10 * size
    assert np.abs(before.d2 - after.d2).max() < 1e-9 * size


def test_the_positions_are_those_of_the_natural_cubic_spline_over_chords() -> None:
    p = np.array([point.position for point in POINTS])
    knots = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1))))
    wanted = CubicSpline(knots, p, bc_type="natural")
    dense = wanted(np.linspace(0.0, knots[-1], 500))
    assert CURVE.distance(dense).max() < 1e-12
    assert CURVE.length == pytest.approx(
        np.linalg.norm(np.diff(wanted(np.linspace(0.0, knots[-1], 40_001)), axis=0), axis=1).sum(), rel=1e-8
    )


def test_turns_about_one_axis_are_a_cubic_spline_of_the_angle() -> None:
    angles = np.array([0.0, 0.4, 0.3, 1.0, 2.9])
    points = [
        Pose(np.array([0.5 * k, 0.0, 0.0]), np.array([math.cos(a / 2.0), 0.0, 0.0, math.sin(a / 2.0)]))
        for k, a in enumerate(angles)
    ]
    s = np.linspace(0.0, 2.0, 101)
    matrices = made(points).tool(s).matrices
    found = np.unwrap(np.arctan2(matrices[:, 1, 0], matrices[:, 0, 0]))
    wanted = CubicSpline(0.5 * np.arange(5), angles, bc_type="natural")(s)
    assert np.abs(found - wanted).max() < ROUNDING


def test_two_points_are_a_straight_line_about_a_fixed_axis() -> None:
    points = poses(2)
    curve = made(points)
    turning = curve.tool(np.linspace(0.0, curve.length, 9)).d1
    assert curve.length == pytest.approx(math.dist(points[0].position, points[1].position), rel=ROUNDING)
    assert np.abs(turning - turning[0]).max() < 1e-10


def test_a_moved_spline_is_the_spline_of_moved_points() -> None:
    X, s = random_pose(np.random.default_rng(42)), np.linspace(0.0, CURVE.length, 60)
    moved = made([X @ point for point in POINTS])
    assert np.abs(moved.tool(s).matrices - X.matrix() @ CURVE.tool(s).matrices).max() < 1e-11


def test_a_spline_flown_backwards_is_the_spline_of_the_points_backwards() -> None:
    back, s = made(POINTS[::-1]), np.linspace(0.0, CURVE.length, 60)
    assert back.length == pytest.approx(CURVE.length, rel=ROUNDING)
    assert np.abs(back.tool(CURVE.length - s).matrices - CURVE.tool(s).matrices).max() < 1e-10


def test_a_turned_tool_flies_the_same_way() -> None:
    Y, s = Pose(np.zeros(3), np.array([0.3, -0.5, 0.2, 0.8])), np.linspace(0.0, CURVE.length, 60)
    turned = made([point @ Y for point in POINTS])
    assert np.abs(turned.tool(s).matrices - CURVE.tool(s).matrices @ Y.matrix()).max() < 1e-11


def test_points_that_are_told_twice_count_once() -> None:
    doubled = [point for point in POINTS for _ in range(2)]
    assert made(doubled) == CURVE


def test_ten_thousand_points_are_one_way() -> None:
    points = poses(10_000)
    curve = made(points)
    assert np.abs(curve.positions(curve.knots) - [point.position for point in points]).max() < 1e-11
    some = curve.knots[1:-1:97]
    assert np.abs(curve.tool(some - STEPS).d1 - curve.tool(some + STEPS).d1).max() < 1e-4
    aside = curve.positions(some) + np.array([0.0, 0.0, 1e-4])
    assert curve.distance(aside).max() <= 1e-4 + ROUNDING


def test_the_distance_from_a_spline_agrees_with_a_search() -> None:
    s = inner_places(CURVE.length, 60)
    aside = CURVE.positions(s) + np.random.default_rng(43).normal(size=(60, 3)) * 0.03
    brute = brute_distances(CURVE, aside)
    assert (CURVE.distance(aside) <= brute + ROUNDING).all()
    assert CURVE.distance(aside) == pytest.approx(brute, abs=1e-5)


def point(x: float, y: float = 0.0, w: float = 1.0) -> Pose:
    return Pose(np.array([x, y, 0.0]), np.array([w, 0.0, 0.0, 1.0 - w]))


@pytest.mark.parametrize(
    ("points", "fault"),
    [
        ([], SplineFault.TOO_FEW),
        ([point(0)], SplineFault.TOO_FEW),
        ([point(0), point(0, 1e-10), point(0)], SplineFault.TOO_FEW),
        ([point(0), point(math.nan)], SplineFault.NOT_FINITE),
        ([point(0), point(1), point(math.inf, 1)], SplineFault.NOT_FINITE),
        ([point(0), point(1e200)], SplineFault.NOT_FINITE),
        ([point(0), point(1), point(1, w=0.5), point(2)], SplineFault.TURNS_IN_PLACE),
        ([point(0), point(0, w=0.5)], SplineFault.TURNS_IN_PLACE),
        ([point(0), point(1), point(0)], SplineFault.TURNS_BACK),
        ([point(0), point(1), point(2), point(1), point(0)], SplineFault.TURNS_BACK),
        ([point(0), point(1), point(1.003, w=0.5)], SplineFault.WHIRLS),
    ],
)
def test_points_that_give_no_way_are_told(points: list[Pose], fault: SplineFault) -> None:
    assert spline(points) is fault


@pytest.mark.parametrize(
    "corners",
    [
        [(0.4, 0.2), (0.5, 0.2), (0.5, 0.1), (0.4, 0.2)],
        [(0.45, -0.25), (0.46, 0.2), (0.5, 0.24), (0.456, 0.2), (0.456, -0.26)],
    ],
    ids=["closed", "out and back"],
)
def test_a_spline_that_comes_back_to_itself_is_nowhere_off_itself(corners: list[tuple[float, float]]) -> None:
    curve = made([Pose(np.array([x, y, 0.3])) for x, y in corners])
    on_it = curve.positions(np.linspace(0.0, curve.length, 5000))
    assert curve.distance(on_it).max() < 1e-9
