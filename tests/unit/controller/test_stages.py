"""Bounds of the pieces of a stretch: exact on straight ways, kept together on bent ones."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from ropsim.controller.stages import joint_stage, tool_stage
from ropsim.motion import (
    CornerFault,
    JointLine,
    JointMotionLimits,
    JointPath,
    JointPoints,
    Line,
    OrientationMode,
    ToolLimits,
    ToolPath,
    ToolPoints,
    ToolSection,
    corner,
    durations,
    plan_time_law,
)
from ropsim.spatial import Array, Pose

ROUNDING = 1e-12
BETWEEN_PLACES = 5e-3  # relative; derivatives are looked at on 33 places, the largest may lie between two
LIMITS = ToolLimits(0.25, 2.0, 20.0, 1.0, 8.0, 80.0)
JOINTS = JointMotionLimits(np.array([1.0, 2.0]), np.array([4.0, 8.0]), np.array([40.0, 80.0]))


def turned(angle: float, *, x: float = 0.0) -> Pose:
    """Return a pose at x [m], turned about z by an angle [rad]."""
    return Pose(np.array([x, 0.0, 0.0]), np.array([math.cos(angle / 2.0), 0.0, 0.0, math.sin(angle / 2.0)]))


def line_time(end: Pose, mode: OrientationMode = OrientationMode.FIXED_AXIS) -> float:
    return plan_time_law([tool_stage(Line(Pose(), end, mode), LIMITS)]).duration


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
        raise NotImplementedError


def test_a_way_that_is_straight_is_not_slowed_where_the_tool_nods_a_little() -> None:
    slow = plan_time_law([tool_stage(_Nodding(), LIMITS)]).duration
    assert slow == pytest.approx(line_time(turned(0.0, x=1.0)), rel=ROUNDING)


def test_the_more_a_bend_takes_the_less_is_left_for_changes_of_speed() -> None:
    stages = [tool_stage(_Nodding(), replace(LIMITS, orientation_jerk=jerk)) for jerk in (1.0, 0.3, 0.1)]
    assert stages[0].acceleration > stages[1].acceleration > stages[2].acceleration
    d1, d2, d3 = (_Nodding.turned * _Nodding.often**k for k in (1, 2, 3))
    for stage, jerk in zip(stages, (1.0, 0.3, 0.1), strict=True):
        v, a, j = stage.speed, stage.acceleration, stage.jerk
        assert d3 * v**3 + 3.0 * d2 * v * a + d1 * j == pytest.approx(jerk, rel=BETWEEN_PLACES)


@pytest.mark.parametrize("mode", OrientationMode)
def test_a_turn_of_the_tool_keeps_to_the_angular_limits(mode: OrientationMode) -> None:
    start = Pose(np.zeros(3), np.array([0.9, 0.1, -0.3, 0.2]))
    path = Line(start, Pose(np.array([0.01, 0.0, 0.0]), np.array([0.2, -0.5, 0.4, 0.7])), mode)
    law = plan_time_law([tool_stage(path, LIMITS)])
    rows = law.at(np.linspace(0.0, law.duration, 2001))
    points = path.tool(rows.places)
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
    law = plan_time_law([joint_stage(JointLine(start, end), JOINTS)])
    assert law.duration == pytest.approx(durations(start, end[None], JOINTS)[0], rel=ROUNDING)


def shares_of(path: JointPath, limits: JointMotionLimits) -> list[float]:
    """Return the greatest shares of the speed, acceleration and jerk limits that the bounds of a way allow.

    Speed, acceleration and jerk along the way are all at their bounds at once, to the worse at every place.
    """
    stage = joint_stage(path, limits)
    s = np.linspace(0.0, path.length, 4001)
    points = path.joints(s)
    d1, d2 = np.abs(points.d1), np.abs(points.d2)
    d3 = np.abs(np.gradient(points.d2, s, axis=0))
    v, a, j = stage.speed, stage.acceleration, stage.jerk
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
        assert max(shares) <= 1.0 + BETWEEN_PLACES, shares
        assert max(shares) > 0.5, shares  # and they are not far too low


def bow(random: np.random.Generator) -> ToolPath:
    """Return the way round a random corner of two lines of 0.2 m, from 0.1 m before it to 0.1 m behind it."""
    edge = random.uniform(-1.0, 1.0, 3)
    ways = [way / np.linalg.norm(way) for way in random.normal(size=(2, 3))]
    turns = random.normal(size=(3, 4)) * 0.2 + np.array([1.0, 0.0, 0.0, 0.0])
    poses = [Pose(edge - 0.2 * ways[0], turns[0]), Pose(edge, turns[1]), Pose(edge + 0.2 * ways[1], turns[2])]
    found = corner(Line(poses[0], poses[1]), 0.1, Line(poses[1], poses[2]), 0.1)
    assert not isinstance(found, CornerFault)
    return found


def test_the_bounds_of_the_tool_hold_on_random_corners() -> None:
    random = np.random.default_rng(3)
    for _ in range(100):
        path = bow(random)
        speed = random.uniform(0.1, 3.0)
        limits = ToolLimits(speed, random.uniform(0.5, 9.0), random.uniform(10.0, 900.0), 9.0, 90.0, 900.0)
        stage = tool_stage(path, limits)
        s = np.linspace(0.0, path.length, 4001)
        points = path.tool(s)
        d3 = np.gradient(points.d2, s, axis=0)
        v, a, j = stage.speed, stage.acceleration, stage.jerk
        accelerated = points.d2 * v**2 + np.array([[[1.0]], [[-1.0]]]) * points.d1 * a
        most = np.linalg.norm(accelerated[:, :, :3], axis=2).max() / limits.acceleration
        sizes = [np.linalg.norm(one[:, :3], axis=1) for one in (points.d1, points.d2, d3)]
        jerks = (sizes[2] * v**3 + 3.0 * sizes[1] * v * a + sizes[0] * j).max() / limits.jerk
        assert v <= limits.speed
        assert most <= 1.0 + BETWEEN_PLACES
        assert jerks <= 1.0 + 5.0 * BETWEEN_PLACES


def test_a_line_in_short_parts_with_zones_takes_the_time_of_the_line() -> None:
    points = [turned(0.0, x=x) for x in np.linspace(0.0, 0.5, 11).tolist()]
    lines, zone, stages, start = [Line(*ends) for ends in pairwise(points)], 5e-3, [], 0.0
    for before, behind in pairwise(lines):
        leaves = before.length - zone
        round_it = corner(before, leaves, behind, zone)
        assert not isinstance(round_it, CornerFault)
        stages += [tool_stage(ToolSection(before, start, leaves), LIMITS), tool_stage(round_it, LIMITS)]
        start = zone
    stages.append(tool_stage(ToolSection(lines[-1], start, lines[-1].length), LIMITS))
    assert plan_time_law(stages).duration == pytest.approx(line_time(points[-1]), rel=1e-9)
