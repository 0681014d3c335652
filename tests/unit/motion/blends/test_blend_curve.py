"""Corners: position, tangent, curvature and turning go over; past the corner by a known distance."""

import math
from importlib import import_module
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from ropsim.motion import BlendFault, Curve, Line, OrientationMode, ToolPath, ToolPoints, blend_curve
from ropsim.spatial import Array, Pose
from support.paths import brute_distances, inner_places, random_pose, tool_differences

CORNERS = import_module("ropsim.motion.blends.blend_curve")
SWING = CORNERS.SWING
ROUNDING = 1e-12
WAY = 1e-12  # [m]; promise of the arc length, but where zones of 1 to 100 meet at more than 160°
RNG = np.random.default_rng(20)
FIRST, MEET, LAST = random_pose(RNG), random_pose(RNG), random_pose(RNG)
BEFORE, AFTER = Line(FIRST, MEET, OrientationMode.DRIVE_TRANSFORM), Line(MEET, LAST)


def made(before: ToolPath, s_leave: float, after: ToolPath, s_enter: float) -> Curve:
    """Return a corner that there is."""
    found = blend_curve(before, s_leave, after, s_enter)
    assert isinstance(found, Curve)
    return found


def elbow(angle: float, zone_in: float, zone_out: float) -> Curve:
    """Return the corner at the origin of two lines of 1 m that turn by an angle [rad]."""
    start = Pose(np.array([-1.0, 0.0, 0.0]))
    end = Pose(np.array([math.cos(angle), math.sin(angle), 0.0]))
    return made(Line(start, Pose()), 1.0 - zone_in, Line(Pose(), end), zone_out)


CURVE = made(BEFORE, BEFORE.length - 0.3, AFTER, 0.2)


@pytest.mark.parametrize(("line", "place", "end"), [(BEFORE, BEFORE.length - 0.3, 0), (AFTER, 0.2, 1)])
def test_a_corner_goes_over_into_its_neighbours(line: Line, place: float, end: int) -> None:
    there, here = line.tool(np.array([place])), CURVE.tool(np.array([end * CURVE.length]))
    assert np.abs(here.matrices - there.matrices).max() < ROUNDING
    assert np.abs(here.d1 - there.d1).max() < 10.0 * ROUNDING
    assert np.abs(here.d2 - there.d2).max() < 100.0 * ROUNDING


def test_the_derivatives_of_a_corner_are_those_of_its_poses() -> None:
    s = inner_places(CURVE.length)
    d1, d2 = tool_differences(CURVE, s, 1e-4 * CURVE.length)
    assert np.abs(CURVE.tool(s).d1 - d1).max() < 1e-8
    assert np.abs(CURVE.tool(s).d2 - d2).max() < 1e-8


@pytest.mark.parametrize("degrees", [1.0, 60.0, 120.0, 150.0, 169.0])
@pytest.mark.parametrize("ratio", [1.0, 0.2, 0.03])
def test_the_place_is_the_way(degrees: float, ratio: float) -> None:
    curve = elbow(math.radians(degrees), 0.5, 0.5 * ratio)
    t = np.linspace(0.0, 1.0, 41)
    columns = [np.polynomial.Polynomial(curve.coefficients[0, :, k]) for k in range(3)]

    def speed(u: float) -> float:
        return math.hypot(*(column.deriv()(u) for column in columns))

    promised = WAY if degrees < 160.0 else 20.0 * WAY
    ways = [quad(speed, low, high, epsabs=1e-14, epsrel=1e-13)[0] for low, high in pairwise(t)]
    s = np.concatenate(([0.0], np.cumsum(ways)))
    assert s[-1] == pytest.approx(curve.length, abs=promised)
    wanted = np.stack([column(t) for column in columns], axis=1)
    assert np.abs(curve.positions(s) - wanted).max() < promised
    tangents = curve.tool(s).d1[:, :3]
    assert np.abs(np.linalg.norm(tangents, axis=1) - 1.0).max() < ROUNDING


@pytest.mark.parametrize("degrees", [20.0, 90.0, 150.0])
def test_a_corner_passes_where_its_swing_puts_it(degrees: float) -> None:
    # p(1/2) = (p₀ + p₁)/2 + 5/32·(p₀' - p₁') of a polynomial of degree five without curvature at its ends,
    # with derivatives of size k·zone there
    angle, zone = math.radians(degrees), 0.08
    curve = elbow(angle, zone, zone)
    middle = curve.positions(np.array([curve.length / 2.0]))[0]
    k = 2.1 * math.sqrt(math.cos(angle / 2.0))
    passed = (1.0 - 0.3125 * k) * zone * math.sin(angle / 2.0)
    assert np.linalg.norm(middle) == pytest.approx(passed, rel=1e-9)


@pytest.mark.parametrize("degrees", [10.0, 60.0, 90.0, 130.0])
def test_the_swing_takes_the_least_time_under_a_bound_of_the_jerk(degrees: float) -> None:
    # with constant speed v the jerk is v³·|d³p/ds³|, so the time is proportional to length·max|d³p/ds³|^(1/3)
    def time(curve: Curve) -> float:
        s = np.linspace(0.0, curve.length, 801)
        d3 = np.linalg.norm(np.diff(curve.tool(s).d2[:, :3], axis=0), axis=1) / s[1]
        return float(curve.length * float(d3.max()) ** (1.0 / 3.0))

    angle, best = math.radians(degrees), []
    for factor in (0.85, 0.9, 0.95, 1.05, 1.1, 1.15):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(CORNERS, "SWING", factor * SWING)
            best.append(time(elbow(angle, 0.1, 0.1)))
    assert time(elbow(angle, 0.1, 0.1)) < 1.03 * min(best)


def test_a_corner_on_a_straight_way_is_that_way() -> None:
    curve = elbow(0.0, 0.3, 0.1)
    s = np.linspace(0.0, curve.length, 9)
    assert curve.length == pytest.approx(0.4, rel=ROUNDING)
    assert curve.positions(s) == pytest.approx(
        np.stack((s - 0.3, np.zeros(9), np.zeros(9)), axis=1), abs=ROUNDING
    )
    assert np.abs(curve.tool(s).d2).max() < 1e-9


def test_without_a_turn_of_the_tool_its_orientation_stays_to_the_bit() -> None:
    turned = random_pose(np.random.default_rng(21)).orientation
    a, b, c = (Pose(p, turned) for p in (np.zeros(3), np.array([1.0, 0, 0]), np.array([1.0, 1.0, 0])))
    points = made(Line(a, b), 0.7, Line(b, c), 0.3).tool(np.linspace(0.0, 0.4, 5))
    assert (points.matrices[:, :3, :3] == a.rotation()).all()
    assert not points.d1[:, 3:].any()
    assert not points.d2[:, 3:].any()


def test_a_moved_corner_is_the_corner_of_moved_paths() -> None:
    X = random_pose(np.random.default_rng(22))
    moved = made(
        Line(X @ FIRST, X @ MEET, OrientationMode.DRIVE_TRANSFORM),
        BEFORE.length - 0.3,
        Line(X @ MEET, X @ LAST),
        0.2,
    )
    s = np.linspace(0.0, CURVE.length, 21)
    here, there = CURVE.tool(s), moved.tool(s)
    assert moved.length == pytest.approx(CURVE.length, abs=ROUNDING)
    assert np.abs(there.matrices - X.matrix() @ here.matrices).max() < ROUNDING
    for one, other in ((here.d1, there.d1), (here.d2, there.d2)):
        turned = np.hstack((one[:, :3] @ X.rotation().T, one[:, 3:] @ X.rotation().T))
        assert np.abs(other - turned).max() < 1e-9


def test_a_corner_flown_backwards_is_the_corner_of_the_paths_backwards() -> None:
    back = made(Line(LAST, MEET), AFTER.length - 0.2, _Backwards(BEFORE), 0.3)
    s = np.linspace(0.0, CURVE.length, 21)
    here, there = CURVE.tool(s), back.tool(CURVE.length - s)
    assert np.abs(here.matrices - there.matrices).max() < 1e-11
    assert np.abs(here.d1 + there.d1).max() < 1e-9
    assert np.abs(here.d2 - there.d2).max() < 1e-8


def test_a_way_back_is_no_corner() -> None:
    there, back = Line(Pose(), Pose(np.array([1.0, 0, 0]))), Line(Pose(np.array([1.0, 0, 0])), Pose())
    assert blend_curve(there, 0.8, back, 0.2) is BlendFault.TURNS_BACK
    sharp = Line(Pose(np.array([1.0, 0, 0])), Pose(np.array([0.0, 0.16, 0])))  # by 170.9°
    assert blend_curve(there, 0.8, sharp, 0.2) is BlendFault.TURNS_BACK


def test_where_the_tcp_stands_there_is_no_corner() -> None:
    turn = Line(MEET, Pose(MEET.position, np.array([1.0, 2.0, 3.0, 4.0])))
    assert blend_curve(BEFORE, BEFORE.length - 0.1, turn, 0.1) is BlendFault.NO_LENGTH
    assert blend_curve(BEFORE, BEFORE.length, AFTER, 0.1) is BlendFault.NO_LENGTH
    assert blend_curve(BEFORE, BEFORE.length - 0.1, AFTER, 0.0) is BlendFault.NO_LENGTH


def test_a_corner_in_which_the_tool_would_whirl_is_none() -> None:
    assert isinstance(blend_curve(BEFORE, BEFORE.length - 0.3, _Turning(AFTER, 20.0), 0.2), Curve)
    assert blend_curve(BEFORE, BEFORE.length - 0.3, _Turning(AFTER, 400.0), 0.2) is BlendFault.WHIRLS


def test_the_distance_from_a_corner_agrees_with_a_search() -> None:
    points = (
        CURVE.positions(inner_places(CURVE.length)) + np.random.default_rng(23).normal(size=(23, 3)) * 0.05
    )
    brute = brute_distances(CURVE, points)
    assert (CURVE.distance(points) <= brute + ROUNDING).all()
    assert CURVE.distance(points) == pytest.approx(brute, abs=1e-6)


def test_places_on_a_corner_have_no_distance() -> None:
    assert CURVE.distance(CURVE.positions(inner_places(CURVE.length, 200))).max() < ROUNDING


class _Backwards:
    """A line flown from its end to its start."""

    def __init__(self, line: Line) -> None:
        self._line = line
        self.length = line.length

    def tool(self, s: Array) -> ToolPoints:
        points = self._line.tool(self.length - s)
        return ToolPoints(points.matrices, -points.d1, points.d2)

    def positions(self, s: Array) -> Array:
        return self._line.positions(self.length - s)

    def distance(self, points: Array) -> Array:
        return self._line.distance(points)


class _Turning(_Backwards):
    """A line on which the tool is said to turn as quickly as is given [rad/m]."""

    def __init__(self, line: Line, rate: float) -> None:
        super().__init__(line)
        self._rate = rate

    def tool(self, s: Array) -> ToolPoints:
        points, d1 = self._line.tool(s), self._line.tool(s).d1.copy()
        d1[:, 3:] = (self._rate, 0.0, 0.0)
        return ToolPoints(points.matrices, d1, points.d2)
