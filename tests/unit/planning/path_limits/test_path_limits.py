"""Bounds of the pieces of a stretch: exact on straight ways, kept together on bent ones."""

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from ropsim import robots
from ropsim.motion import (
    ArcFault,
    BlendFault,
    Interval,
    JointLine,
    JointMotionLimits,
    JointPath,
    JointPoints,
    JointSection,
    Line,
    OrientationMode,
    PathLimits,
    SplineFault,
    ToolLimits,
    ToolPath,
    ToolPoints,
    ToolSection,
    arc,
    blend_curve,
    durations,
    jerk_limited,
    plan_time_law,
    smoothly,
    spline,
)
from ropsim.planning import Coordination
from ropsim.planning.testing import along_with, fastest_bounds, joint_path_limits, tool_path_limits
from ropsim.spatial import Array, Pose

ROUNDING = 1e-12
BETWEEN_PLACES = 5e-3  # relative; of differences over 2,000 steps of the time
LIMITS = ToolLimits(0.25, 2.0, 20.0, 1.0, 8.0, 80.0)
JOINTS = JointMotionLimits(np.array([1.0, 2.0]), np.array([4.0, 8.0]), np.array([40.0, 80.0]))


def turned(angle: float, *, x: float = 0.0) -> Pose:
    """Return a pose at x [m], turned about z by an angle [rad]."""
    return Pose(np.array([x, 0.0, 0.0]), np.array([math.cos(angle / 2.0), 0.0, 0.0, math.sin(angle / 2.0)]))


def line_time(end: Pose, mode: OrientationMode = OrientationMode.FIXED_AXIS) -> float:
    return plan_time_law(tool_path_limits(Line(Pose(), end, mode), LIMITS)).duration


def test_a_pure_translation_takes_the_time_of_its_speed_and_ramp() -> None:
    # 1 m at 0.25 m/s, and the ramp of 2/20 + 0.25/2 s
    assert line_time(turned(0.0, x=1.0)) == pytest.approx(4.225, rel=ROUNDING)


def test_a_pure_turn_takes_the_time_of_its_angular_speed_and_ramp() -> None:
    # 2 rad at 1 rad/s, and the ramp of 8/80 + 1/8 s
    assert line_time(turned(2.0)) == pytest.approx(2.225, rel=ROUNDING)


def test_the_slower_of_way_and_turn_leads() -> None:
    assert line_time(turned(0.1, x=1.0)) == pytest.approx(line_time(turned(0.0, x=1.0)), rel=ROUNDING)
    assert line_time(turned(2.0, x=0.01)) == pytest.approx(line_time(turned(2.0)), rel=ROUNDING)


def test_rounding_of_an_orientation_that_is_kept_does_not_limit_the_speed() -> None:
    assert line_time(turned(1e-12, x=1.0)) == pytest.approx(4.225, rel=ROUNDING)


class _Nodding:
    """A straight way of 1 m on which the tool turns to and fro about x by a small angle: A·(1 - cos w·s)."""

    length, turned, often = 1.0, 0.02, 2.0 * math.pi

    def tool(self, s: Array) -> ToolPoints:
        d1, d2, matrices = np.zeros((len(s), 6)), np.zeros((len(s), 6)), np.tile(np.eye(4), (len(s), 1, 1))
        d1[:, 1] = 1.0
        d1[:, 3] = self.turned * self.often * np.sin(self.often * s)
        d2[:, 3] = self.turned * self.often**2 * np.cos(self.often * s)
        return ToolPoints(matrices, d1, d2)

    def positions(self, s: Array) -> Array:
        return np.outer(s, [0.0, 1.0, 0.0])

    def distance(self, points: Array) -> Array:
        nearest = np.outer(np.clip(points[:, 1], 0.0, self.length), [0.0, 1.0, 0.0])
        return np.asarray(np.linalg.norm(points - nearest, axis=1))


def test_a_way_that_is_straight_is_not_slowed_where_the_tool_nods_a_little() -> None:
    slow = plan_time_law(tool_path_limits(_Nodding(), LIMITS)).duration
    assert slow == pytest.approx(line_time(turned(0.0, x=1.0)), rel=ROUNDING)


@pytest.mark.parametrize("mode", OrientationMode)
def test_a_turn_of_the_tool_keeps_to_the_angular_limits(mode: OrientationMode) -> None:
    start = Pose(np.zeros(3), np.array([0.9, 0.1, -0.3, 0.2]))
    path = Line(start, Pose(np.array([0.01, 0.0, 0.0]), np.array([0.2, -0.5, 0.4, 0.7])), mode)
    stages = tool_path_limits(path, LIMITS)
    ones = np.ones(len(stages))
    law = jerk_limited(np.column_stack((stages.rows, ones, -ones)), np.array([float(len(stages))]))
    rows = law.at(np.linspace(0.0, law.duration, 2001))
    points = path.tool(rows.parameters)
    v, a = rows.speeds[:, None], rows.accelerations[:, None]
    angular = (points.d1 * v)[:, 3:]
    accelerated = (points.d2 * v * v + points.d1 * a)[:, 3:]
    assert np.linalg.norm(angular, axis=1).max() <= LIMITS.orientation_speed * (1.0 + ROUNDING)
    assert np.linalg.norm(accelerated, axis=1).max() <= LIMITS.orientation_acceleration * (1.0 + ROUNDING)
    jerks = np.linalg.norm(np.diff(accelerated, axis=0), axis=1) / (law.duration / 2000)
    assert jerks.max() <= LIMITS.orientation_jerk * (1.0 + BETWEEN_PLACES)
    if mode is OrientationMode.FIXED_AXIS:  # on one straight turn the limit is reached
        assert np.linalg.norm(angular, axis=1).max() == pytest.approx(LIMITS.orientation_speed)


def test_the_bounds_of_a_straight_way_of_the_joints_are_those_of_the_slowest_joint() -> None:
    start, end = np.array([0.1, -0.4]), np.array([1.0, 0.2])
    law = plan_time_law(joint_path_limits(JointLine(start, end), JOINTS))
    assert law.duration == pytest.approx(durations(start, end[None], JOINTS)[0], rel=ROUNDING)


class _Unknown:
    """A path of which nothing is known but what it tells."""

    def __init__(self, path: JointPath) -> None:
        self.length, self.joints = path.length, path.joints


class _UnknownTool:
    """The same of a path of the tool."""

    def __init__(self, path: ToolPath) -> None:
        self.length, self.tool, self.positions, self.distance = (
            path.length,
            path.tool,
            path.positions,
            path.distance,
        )


@pytest.mark.parametrize("seed", range(8))
def test_lines_have_the_stage_that_is_found_by_looking_at_them(seed: int) -> None:
    random = np.random.default_rng(seed)
    ends = random.uniform(-2.0, 2.0, (2, 2))
    line = JointLine(*ends)
    for path in (line, JointSection(line, 0.2, 0.7)):
        assert joint_path_limits(path, JOINTS) == joint_path_limits(_Unknown(path), JOINTS)
    start, end = (Pose(random.normal(size=3), random.normal(size=4)) for _ in range(2))
    for mode in OrientationMode:
        way = Line(start, end, mode)
        for tool in (way, ToolSection(way, 0.2 * way.length, 0.7 * way.length)):
            np.testing.assert_allclose(
                tool_path_limits(tool, LIMITS).rows,
                tool_path_limits(_UnknownTool(tool), LIMITS).rows,
                rtol=ROUNDING,
            )


def test_a_limit_that_is_no_number_stays_none() -> None:
    limits = JointMotionLimits(np.array([1.0, np.nan]), JOINTS.acceleration, JOINTS.jerk)
    row = joint_path_limits(JointLine(np.zeros(2), np.ones(2)), limits).rows[0]
    assert np.isnan(row).tolist() == [False, True, False, False]


def bounds_at(stages: PathLimits, s: Array) -> tuple[Array, Array, Array]:
    """Return the bounds of speed, acceleration and jerk at places, each of shape (k, 1)."""
    here = np.minimum(np.searchsorted(stages.ends, s), len(stages) - 1)
    rows = stages.bounds[here]
    return rows[:, :1], rows[:, 1:2], rows[:, 2:]


def shares_of(path: JointPath, limits: JointMotionLimits) -> list[float]:
    """Return the greatest shares of the speed, acceleration and jerk limits that the bounds of a way allow.

    Speed, acceleration and jerk along the way are all at their bounds at once, to the worse at every place.
    """
    s = np.linspace(0.0, path.length, 4001)
    points = path.joints(s)
    d1, d2 = np.abs(points.d1), np.abs(points.d2)
    d3 = np.abs(np.gradient(points.d2, s, axis=0))
    v, a, j = bounds_at(joint_path_limits(path, limits), s)
    sizes = d1 * v, d2 * v**2 + d1 * a, d3 * v**3 + 3.0 * d2 * v * a + d1 * j
    bounds = limits.speed, limits.acceleration, limits.jerk
    return [float((size / bound).max()) for size, bound in zip(sizes, bounds, strict=True)]


class _Overlap:
    """The way on which the end of a line goes over smoothly into the start of the next one: a polynomial."""

    def __init__(self, before: JointLine, behind: JointLine, share: float) -> None:
        self.length = 1.0
        ends = np.array([1.0 - share, 1.0]), np.array([0.0, share])
        leaving, arriving = before.joints(ends[0]).q, behind.joints(ends[1]).q
        over = Polynomial([0.0, 0.0, 0.0, 10.0, -15.0, 6.0])
        self._ways = [
            Polynomial([a, b - a]) * (1.0 - over) + Polynomial([c, d - c]) * over
            for a, b, c, d in np.vstack((leaving, arriving)).T
        ]

    def joints(self, s: Array) -> JointPoints:
        return JointPoints(*(np.stack([way.deriv(k)(s) for way in self._ways], axis=1) for k in range(3)))


@pytest.mark.slow
def test_the_bounds_hold_on_random_blends() -> None:
    random = np.random.default_rng(9)
    for _ in range(200):
        corner = random.uniform(-1.0, 1.0, 6)
        before = JointLine(corner + random.uniform(-1.5, 1.5, 6), corner)
        behind = JointLine(corner, corner + random.uniform(-1.5, 1.5, 6) * 10.0 ** random.uniform(-2.0, 0.0))
        blend = _Overlap(before, behind, random.uniform(0.02, 0.5))
        speed = random.uniform(0.5, 6.0, 6)
        limits = JointMotionLimits(
            speed, speed * random.uniform(2.0, 8.0, 6), speed * random.uniform(20.0, 90.0, 6)
        )
        shares = shares_of(blend, limits)
        assert max(shares) <= 1.0 + ROUNDING, shares
        assert max(shares) > 0.5, shares  # and they are not far too low


def bow(random: np.random.Generator) -> ToolPath:
    """Return the way round a random corner of two lines of 0.2 m, from 0.1 m before it to 0.1 m behind it."""
    edge = random.uniform(-1.0, 1.0, 3)
    ways = [way / np.linalg.norm(way) for way in random.normal(size=(2, 3))]
    turns = random.normal(size=(3, 4)) * 0.2 + np.array([1.0, 0.0, 0.0, 0.0])
    poses = [Pose(edge - 0.2 * ways[0], turns[0]), Pose(edge, turns[1]), Pose(edge + 0.2 * ways[1], turns[2])]
    found = blend_curve(Line(poses[0], poses[1]), 0.1, Line(poses[1], poses[2]), 0.1)
    assert not isinstance(found, BlendFault)
    return found


def way_through(random: np.random.Generator) -> ToolPath:
    """Return the spline through random poses, up to eight, that turn by no more than about a right angle."""
    ahead, place, poses = random.normal(size=3), random.uniform(-0.3, 0.3, 3), []
    for _ in range(random.integers(3, 9)):
        poses.append(Pose(place, random.normal(size=4) * 0.2 + np.array([1.0, 0.0, 0.0, 0.0])))
        ahead = ahead / np.linalg.norm(ahead) + random.normal(size=3) * 0.5
        place = place + ahead / np.linalg.norm(ahead) * 0.1 * 4.0 ** random.uniform(-1.0, 1.0)
    found = spline(poses)
    assert not isinstance(found, SplineFault)
    return found


def round_arc(random: np.random.Generator) -> ToolPath:
    """Return an arc on which the tool turns."""
    found = arc(turned(0.0), Pose(random.uniform(-0.1, 0.1, 3)), turned(random.uniform(-1.0, 1.0), x=0.2))
    assert not isinstance(found, ArcFault)
    return found


def fastest(path: ToolPath, limits: ToolLimits, random: np.random.Generator) -> PathLimits:
    return tool_path_limits(path, limits)


def at_some_speeds(path: ToolPath, limits: ToolLimits, random: np.random.Generator) -> PathLimits:
    """Return the bounds of a path that is passed at random speeds in its cells."""
    (bounds,), bend = fastest_bounds(path, limits)
    if bend is None:
        return bounds
    speeds = random.uniform(0.2, 1.0, len(bend.borders) - 1) * float(bounds.bounds[:, 0].max())
    slower = bend.within(speeds)
    here = np.searchsorted(slower.ends[:-1], 0.5 * (bend.borders[1:] + bend.borders[:-1]))
    assert (slower.bounds[here, 0] <= speeds).all()
    return slower


@pytest.mark.parametrize("make", [bow, way_through, round_arc])
@pytest.mark.parametrize("bound", [fastest, at_some_speeds])
def test_the_bounds_of_the_tool_hold_at_every_place(
    make: Callable[[np.random.Generator], ToolPath],
    bound: Callable[[ToolPath, ToolLimits, np.random.Generator], PathLimits],
) -> None:
    """Speed, acceleration and jerk of TCP and orientation, with those along the way at their bounds at once.

    The vectors are added for each pair of signs of acceleration and jerk along the way.
    """
    random = np.random.default_rng(3)
    for _ in range(60):
        path = make(random)
        of_tcp = 10.0 ** random.uniform(-1.5, 0.3), random.uniform(0.5, 9.0), 10.0 ** random.uniform(1.0, 3.0)
        of_turn = random.uniform(0.3, 5.0), random.uniform(2.0, 20.0), 10.0 ** random.uniform(1.0, 3.0)
        s = np.linspace(0.0, path.length, 4001)
        points, bounds = path.tool(s), bounds_at(bound(path, ToolLimits(*of_tcp, *of_turn), random), s)
        same = (np.diff(np.hstack(bounds), axis=0) == 0.0).all(
            axis=1
        )  # elsewhere one stage ends and one begins
        for limits, part in ((of_tcp, slice(0, 3)), (of_turn, slice(3, 6))):
            d1, d2 = points.d1[:, part], points.d2[:, part]
            v, a, j = bounds
            sizes = [d1 * v, d2 * v**2 + d1 * a, d2 * v**2 - d1 * a]
            within = [float(np.linalg.norm(size, axis=1).max()) for size in sizes]
            d3 = np.diff(d2, axis=0)[same] / s[1]
            d1, d2, v, a, j = (rows[:-1][same] for rows in (d1, d2, v, a, j))
            jerks = [
                d3 * v**3 + 3.0 * sign * d2 * v * a + other * d1 * j
                for sign in (1.0, -1.0)
                for other in (1.0, -1.0)
            ]
            assert within[0] <= limits[0] * (1.0 + ROUNDING)
            assert max(within[1:]) <= limits[1] * (1.0 + ROUNDING)
            assert max(np.linalg.norm(jerk, axis=1).max() for jerk in jerks) <= limits[2] * (1.0 + ROUNDING)


def test_a_line_in_short_parts_with_zones_takes_the_time_of_the_line() -> None:
    points = [turned(0.0, x=x) for x in np.linspace(0.0, 0.5, 11).tolist()]
    lines, zone, start = [Line(*ends) for ends in pairwise(points)], 5e-3, 0.0
    stages: list[Interval] = []
    for before, behind in pairwise(lines):
        leaves = before.length - zone
        round_it = blend_curve(before, leaves, behind, zone)
        assert not isinstance(round_it, BlendFault)
        stages += [
            *tool_path_limits(ToolSection(before, start, leaves), LIMITS),
            *tool_path_limits(round_it, LIMITS),
        ]
        start = zone
    stages += tool_path_limits(ToolSection(lines[-1], start, lines[-1].length), LIMITS)
    assert plan_time_law(stages).duration == pytest.approx(line_time(points[-1]), rel=1e-9)


def test_an_arc_is_one_stage() -> None:
    random = np.random.default_rng(5)
    assert [len(tool_path_limits(round_arc(random), LIMITS)) for _ in range(20)] == [1] * 20


def test_a_spline_slows_down_only_where_it_bends() -> None:
    """Two straight parts of 0.4 m with a bend of a centimetre between: no more time than each part alone."""
    xs = [0.0, 0.2, 0.4, 0.41, 0.41, 0.41, 0.41]
    ys = [0.0, 0.0, 0.0, 0.01, 0.1, 0.21, 0.41]
    path = spline([Pose(np.array([x, y, 0.0])) for x, y in zip(xs, ys, strict=True)])
    assert not isinstance(path, SplineFault)
    places = [0.0, 0.38, path.length - 0.38, path.length]
    parts = [ToolSection(path, *ends) for ends in pairwise(places)]
    alone = [plan_time_law(tool_path_limits(part, LIMITS)).duration for part in parts]
    whole = plan_time_law(tool_path_limits(path, LIMITS)).duration
    assert whole < sum(alone)
    assert whole < 2.2 * line_time(turned(0.0, x=0.4))


def test_where_axes_go_along_the_lower_bounds_of_both_hold_at_every_place() -> None:
    path = bow(np.random.default_rng(4))
    rest = np.zeros((1, 2))
    start, end = (
        JointPoints(rest, rest, rest),
        JointPoints(np.array([[0.2, 0.1]]), np.array([[4.0, 1.0]]), rest),
    )
    axes = smoothly(path.length, start, end)
    coordination = Coordination(robots.load("two_link"), axes, None, JOINTS)
    of_tool, of_axes = tool_path_limits(path, LIMITS), joint_path_limits(axes, JOINTS)
    both = along_with(of_tool, coordination)
    assert sum(stage.length for stage in both) == pytest.approx(path.length, rel=ROUNDING)
    s = np.linspace(0.0, path.length, 1235)[1:-1]
    for mine, one, other in zip(*(bounds_at(each, s) for each in (both, of_tool, of_axes)), strict=True):
        assert (mine == np.minimum(one, other)).all()
        assert (one < other).any()
    assert along_with(of_tool, None) == of_tool


@pytest.mark.parametrize("part", [1e-9, 1e-6, 1e-3, 0.03, 0.5])
def test_short_sections_of_a_curve_have_the_bounds_of_the_place(part: float) -> None:
    path = bow(np.random.default_rng(2))
    begin = 0.3 * path.length
    stages = tool_path_limits(ToolSection(path, begin, begin + part * path.length), LIMITS)
    points = path.tool(np.array([begin, begin + 1e-6 * path.length]))
    third = np.linalg.norm(np.diff(points.d2[:, :3], axis=0)) / (1e-6 * path.length)
    most = min(LIMITS.speed, float(np.cbrt(LIMITS.jerk / third)))
    assert sum(stage.length for stage in stages) == pytest.approx(part * path.length, rel=1e-6)
    assert 0.5 * most <= stages[0].speed <= most


SPEEDS, ANGLES, ZONES = (
    (0.05, 0.25, 1.0),
    (30.0, 90.0, 150.0),
    (0.5e-3, 1e-3, 2e-3, 5e-3, 10e-3, 20e-3, 50e-3),
)


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize(("acceleration", "jerk"), [(2.0, 20.0), (5.0, 500.0)])
def test_rounding_a_corner_by_as_much_as_the_arm_brakes_in_is_no_slower_than_a_stop(
    speed: float, angle: float, acceleration: float, jerk: float
) -> None:
    """Two lines of 0.3 m, with a zone and with a stop.

    In a smaller zone, the arm has no room to brake and to bend: jerk is bounded as a whole, along and across
    the path, while a stop has all of it for braking. It then costs up to a tenth of the whole time.
    """
    limits = ToolLimits(speed, acceleration, jerk, 1.0, 8.0, 80.0)
    way, turn = 0.3, math.radians(angle)
    points = np.array([[-way, 0.0, 0.0], [0.0, 0.0, 0.0], [way * math.cos(turn), way * math.sin(turn), 0.0]])
    before, behind = (Line(Pose(one), Pose(other)) for one, other in pairwise(points))
    stop = 2.0 * plan_time_law(tool_path_limits(before, limits)).duration
    ramp = max(speed / acceleration + acceleration / jerk, 2.0 * math.sqrt(speed / jerk))
    for zone in ZONES:
        round_it = blend_curve(before, way - zone, behind, zone)
        assert not isinstance(round_it, BlendFault)
        parts = ToolSection(before, 0.0, way - zone), round_it, ToolSection(behind, zone, way)
        time = plan_time_law([stage for part in parts for stage in tool_path_limits(part, limits)]).duration
        assert time <= stop * (1.001 if zone >= 0.5 * speed * ramp else 1.1)
