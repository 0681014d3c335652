"""Laws of paths on random poses: smooth, as long as their way, past corners and through zones."""

import math

import numpy as np
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from ropsim.motion import (
    Arc,
    ArcFault,
    ArcOrientation,
    BlendFault,
    Curve,
    Line,
    OrientationMode,
    SplineFault,
    ToolPath,
    ToolPoints,
    ToolSection,
    arc,
    blend_curve,
    enter,
    leave,
    spline,
)
from ropsim.spatial import Array, Pose
from support.examples import examples
from support.paths import inner_places, tool_differences

ROUNDING = 1e-11
DIFFERENCES = 1e-7  # of derivatives times the way over which they change

coordinates = st.tuples(*[st.floats(-1.0, 1.0)] * 3)
turns = st.tuples(*[st.floats(-1.0, 1.0)] * 4).filter(lambda q: math.hypot(*q) > 0.1)
poses = st.builds(lambda p, q: Pose(np.array(p), np.array(q)), coordinates, turns)
modes = st.sampled_from(OrientationMode)
lines = st.builds(Line, poses, poses, modes).filter(lambda line: np.linalg.norm(line.displacement) > 0.05)
arcs = st.builds(
    arc, poses, poses, poses, st.sampled_from(ArcOrientation), modes, st.none() | st.floats(0.1, 10.0)
)
splines = st.builds(spline, st.lists(poses, min_size=2, max_size=8))
BEND = ((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0), (0.0, 0.5, 0.25))
TURNS_BACK = spline([Pose(np.array(point)) for point in BEND])
wild = st.floats(allow_nan=True, allow_infinity=True)
wild_poses = st.builds(lambda *p: Pose(np.array(p)), wild, wild, wild)


def unbent(path: ToolPath, s: Array) -> bool:
    """Return whether differences over 10⁻⁴ of the way see the path as smooth.

    Of 570 random splines such ones are off by 10⁻⁸ in d1 and 10⁻⁷ in d2 at the most, those with 40 to 50 by
    3·10⁻⁶ and 0.08: differences grow with the third and the fourth derivative.
    """
    return bool(np.abs(path.tool(s).d2).max() * path.length < 10.0)


def assert_lawful(path: ToolPath) -> None:
    """Fail unless derivatives, length, positions and distances agree with the poses of a path."""
    s = inner_places(path.length)
    points = path.tool(s)
    rotations = points.matrices[:, :3, :3]
    assert np.abs(rotations @ np.swapaxes(rotations, 1, 2) - np.eye(3)).max() < ROUNDING
    assert np.abs(np.linalg.norm(points.d1[:, :3], axis=1) - 1.0).max() < ROUNDING
    assert np.abs(path.positions(s) - points.matrices[:, :3, 3]).max() < ROUNDING
    assert path.distance(path.positions(s)).max() < ROUNDING
    moved = path.positions(s) + np.array([0.02, -0.01, 0.03])
    away = path.distance(moved)
    assert (away >= 0.0).all()
    assert (away <= np.linalg.norm([0.02, -0.01, 0.03]) + ROUNDING).all()
    d1, d2 = tool_differences(path, s, 1e-4 * path.length)
    assert np.abs(points.d1 - d1).max() * path.length < DIFFERENCES
    assert np.abs(points.d2 - d2).max() * path.length**2 < 100.0 * DIFFERENCES


@settings(max_examples=examples(60), derandomize=True)
@given(lines)
def test_lines_are_lawful(line: Line) -> None:
    assert_lawful(line)


@settings(max_examples=examples(60), derandomize=True)
@given(arcs)
def test_arcs_are_lawful_or_there_is_a_reason(path: Arc | ArcFault) -> None:
    if isinstance(path, Arc):
        assume(path.radius < 10.0 and path.length > 0.01)
        assert_lawful(path)


@settings(max_examples=examples(60), derandomize=True)
@given(splines)
def test_splines_are_lawful_or_there_is_a_reason(path: Curve | SplineFault) -> None:
    if isinstance(path, Curve):
        assume(unbent(path, np.linspace(0.0, path.length, 500)))
        assert_lawful(path)


@settings(max_examples=examples(100), derandomize=True)
@given(poses, lines | arcs, lines | arcs, st.floats(0.01, 0.5), st.floats(0.01, 0.5))
def test_corners_go_over_in_curvature_and_turning_or_there_is_a_reason(
    meet: Pose, before: Line | Arc | ArcFault, after: Line | Arc | ArcFault, share_in: float, share_out: float
) -> None:
    assume(not isinstance(before, ArcFault) and not isinstance(after, ArcFault))
    assert not isinstance(before, ArcFault)
    assert not isinstance(after, ArcFault)
    assume(min(before.length, after.length) > 0.05)
    there, back = _Moved(before, meet, before.length), _Moved(after, meet, 0.0)
    s_leave, s_enter = before.length * (1.0 - share_in), after.length * share_out
    curve = blend_curve(there, s_leave, back, s_enter)
    if isinstance(curve, BlendFault):
        return
    ends = curve.tool(np.array([0.0, curve.length]))
    for row, path, place in ((0, there, s_leave), (1, back, s_enter)):
        wanted = path.tool(np.array([place]))
        size = 1.0 + np.abs(wanted.d1).max()
        assert np.abs(ends.matrices[row] - wanted.matrices[0]).max() < ROUNDING
        assert np.abs(ends.d1[row] - wanted.d1[0]).max() < 1e-9 * size
        assert np.abs(ends.d2[row] - wanted.d2[0]).max() < 1e-6 * size**2
    if unbent(curve, np.linspace(0.0, curve.length, 200)):
        assert_lawful(curve)


@settings(max_examples=examples(100), derandomize=True)
@given(lines | arcs | splines, st.floats(1e-4, 1.0))
@example(TURNS_BACK, 1.0)
def test_zones_end_where_the_distance_is_the_zone(
    path: Line | Arc | ArcFault | Curve | SplineFault, zone: float
) -> None:
    if isinstance(path, ArcFault | SplineFault):
        return
    half = path.length / 2.0
    for place, centre, side in (
        (leave(path.positions, path.length, zone, half), path.length, -1.0),
        (enter(path.positions, path.length, zone, half), 0.0, 1.0),
    ):
        distance = np.linalg.norm(np.diff(path.positions(np.array([place, centre])), axis=0))
        if abs(place - half) > 1e-9 * path.length:
            assert abs(distance - zone) < 1e-8 * zone
        else:
            assert distance <= zone + 1e-9
        nearer = path.positions(place - side * np.linspace(0.01, 1.0, 50) * abs(place - centre))
        from_centre = np.linalg.norm(nearer - path.positions(np.array([centre])), axis=1)
        assert from_centre.max() <= zone + 1e-9


@settings(max_examples=examples(60), derandomize=True)
@given(lines, st.floats(0.0, 0.4), st.floats(0.6, 1.0))
def test_sections_are_lawful(line: Line, begin: float, end: float) -> None:
    assert_lawful(ToolSection(line, begin * line.length, end * line.length))


@settings(max_examples=examples(150), derandomize=True)
@given(st.lists(wild_poses, max_size=5), st.none() | wild)
def test_no_coordinate_raises_an_exception(points: list[Pose], angle: float | None) -> None:
    found = spline(points)
    assert isinstance(found, Curve | SplineFault)
    if len(points) >= 3:
        assert isinstance(arc(points[0], points[1], points[2], angle=angle), Arc | ArcFault)


class _Moved:
    """A path moved as a whole, so that at a place it is at a pose."""

    def __init__(self, path: ToolPath, pose: Pose, place: float) -> None:
        self._path = path
        self._X = pose @ Pose.from_matrix(path.tool(np.array([place])).matrices[0]).inverse()
        self.length = path.length

    def tool(self, s: Array) -> ToolPoints:
        points, R = self._path.tool(s), self._X.rotation().T
        d1, d2 = (np.hstack((rows[:, :3] @ R, rows[:, 3:] @ R)) for rows in (points.d1, points.d2))
        return ToolPoints(self._X.matrix() @ points.matrices, d1, d2)

    def positions(self, s: Array) -> Array:
        return self.tool(s).matrices[:, :3, 3]

    def distance(self, points: Array) -> Array:
        return self._path.distance((points - self._X.position) @ self._X.rotation())
