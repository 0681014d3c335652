"""Compression: short straight moves become smooth curves, alike in every frame, and the rest stays."""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from ropsim.motion import (
    SHORTEST_MOVE,
    BreakCause,
    Compression,
    Curve,
    CurvePart,
    Line,
    ProfileError,
    StraightPart,
    blend_curve,
    compressed,
    spline,
)
from ropsim.spatial import Array, Pose
from support.straight_chains import (
    StraightChain,
    bent_of,
    chain,
    contour,
    curves,
    distances_from,
    drawn,
    drawn_parts,
    helix,
    lines,
    rounded_arc,
    samples_of,
    uneven,
    wave,
)

ROUNDING = 1e-12
SAME = 1e-9
"""Of positions and orientations [m, rad] of the same chain in another frame."""
JUMP = 2e-5
"""Of curvatures [1/m] on both sides of a knot: the arc length is interpolated."""


def only_curve(found: Compression) -> CurvePart:
    """Return the curve of a chain that is one."""
    (part,) = found.parts
    assert isinstance(part, CurvePart)
    assert found.breaks == ()
    return part


@pytest.mark.parametrize(
    ("given", "deviation", "curvature", "spans"),
    [
        (wave(240, 2.5e-3, 1e-3), 1e-5, 8.9, 60),
        (wave(60, 1e-2, 5e-3), 6e-5, 8.9, 30),
        (rounded_arc(), 8e-6, 27.0, 30),
        (helix(), 1.6e-5, 21.0, 100),
    ],
    ids=["gentle", "coarse", "rounded arc", "helix"],
)
def test_a_gentle_chain_is_one_curve(
    given: StraightChain, deviation: float, curvature: float, spans: int
) -> None:
    """The radii of the shapes are 115, 115, 40 and 50 mm."""
    part = only_curve(compressed(*given))
    assert (part.first, part.last) == (0, len(given.points) - 1)
    assert part.deviation <= deviation
    assert bent_of(part) <= curvature
    assert len(part.curve.middles) <= spans


def test_a_spline_through_rounded_points_bends_twice_as_much() -> None:
    """So that the bound above distinguishes a fit from an interpolation."""
    given = rounded_arc()
    through = spline([Pose(point) for point in given.points])
    assert isinstance(through, Curve)
    s = np.linspace(0.0, through.length, 20_000)
    assert np.linalg.norm(through.tool(s).d2[:, :3], axis=1).max() > 50.0


def test_sharp_turns_keep_their_blend_and_the_rest_is_curves() -> None:
    given = drawn_parts()
    found = compressed(*given)
    assert [cause for _, cause in found.breaks] == [BreakCause.TURN] * 4
    corners = [point for point, _ in found.breaks]
    assert [(part.first, part.last) for part in curves(found)] == list(
        zip([0, *corners], [*corners, len(given.points) - 1], strict=True)
    )
    assert max(bent_of(part) for part in curves(found)) <= 27.0  # the least radius is 40 mm


def test_a_contour_with_zones_below_half_of_its_moves_flows_between_its_sharp_turns() -> None:
    given = contour(2000)
    found = compressed(*given)
    assert [cause for _, cause in found.breaks] == [BreakCause.TURN] * 41
    assert lines(found) == []
    assert max(part.deviation for part in curves(found)) <= 2e-5


def test_uneven_moves_are_curves_where_they_are_short_and_lines_where_they_are_long() -> None:
    given = uneven()
    found = compressed(*given)
    assert len(lines(found)) <= 28
    assert len(curves(found)) <= 25
    assert max(part.deviation for part in curves(found)) <= 1.3e-4


@pytest.mark.parametrize("zone", [1e-3, 5e-3, 5e-2])
def test_zones_far_beyond_the_moves_leave_a_smooth_polyline_its_shape(zone: float) -> None:
    """Points 1 mm apart on an arc of 40 mm have zones of 1 to 50 mm."""
    angle = np.arange(200) / 40.0
    given = chain(0.04 * np.stack((np.cos(angle), np.sin(angle), 0.0 * angle), axis=1), zone)
    part = only_curve(compressed(given.points, given.rotations, given.zones, 0.1))
    assert part.deviation < 5e-6


def test_a_curve_follows_the_shape_and_not_the_noise_of_its_points() -> None:
    """Noise of 10 µm is more than the narrow tolerance of zones of 1 mm leaves and less than the wide one."""
    given = wave(300, 1e-3, 1e-3)
    noise = np.random.default_rng(9).normal(size=(300, 3)) * 1e-5
    part = only_curve(compressed(given.points + noise, given.rotations, given.zones, given.longest))
    assert len(part.curve.middles) < 150
    assert np.abs(distances_from(given.points, part.curve.positions(samples_of(part)[0]))).max() < 4e-5


def test_a_turn_that_stands_out_keeps_its_blend() -> None:
    given = chain(drawn([(40.0, 0.0), (0.0, 20.0), (40.0, 0.0)], 2e-3), 1e-3)
    found = compressed(*given)
    assert found.breaks == ((20, BreakCause.ODD),)


@pytest.mark.parametrize("given", [drawn_parts(), helix(), uneven()], ids=["parts", "helix", "uneven"])
def test_position_tangent_curvature_and_turning_have_no_jumps(given: StraightChain) -> None:
    for part in curves(compressed(*given)):
        knots, least = part.curve.knots[1:-1], 1e-9 * part.curve.length
        before, behind = part.curve.tool(knots - least), part.curve.tool(knots + least)
        assert np.abs(behind.matrices - before.matrices).max(initial=0.0) < 1e-6 * part.curve.length
        assert np.abs(behind.d1 - before.d1).max(initial=0.0) < 1e-5
        size = np.abs(before.d2).max(initial=1.0)
        assert np.abs(behind.d2 - before.d2).max(initial=0.0) < JUMP * size


def test_curves_end_at_points_with_their_own_blend() -> None:
    given = drawn_parts()
    for part in curves(compressed(*given)):
        ends = part.curve.tool(np.array([0.0, part.curve.length])).matrices
        assert np.abs(ends[:, :3, 3] - given.points[[part.first, part.last]]).max() < ROUNDING
        assert (part.parameters[0], part.parameters[-1]) == (0.0, part.curve.length)


def between_lines() -> StraightChain:
    """Return a long move, an arc of short ones and another long move, all tangent, with a tool that turns."""
    points = drawn([(30.0, 40.0)], 1.5e-3) * [1.0, 1.0, 0.0]
    first = points[:1] - [[0.3, 0.0, 0.0]]
    heading = np.array([math.cos(math.radians(40.0)), math.sin(math.radians(40.0)), 0.0])
    points = np.vstack((first, points, points[-1] + 0.3 * heading))
    along = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))))
    turned = Rotation.from_rotvec(along[:, None] * [0.1, 0.2, 1.0])
    return StraightChain(points, turned.as_matrix(), np.full(len(points) - 2, 1e-3), 0.1)


def test_curves_between_lines_begin_and_end_on_them_straight() -> None:
    given = between_lines()
    found = compressed(*given)
    before, part, behind = found.parts
    assert isinstance(before, StraightPart)
    assert isinstance(part, CurvePart)
    assert isinstance(behind, StraightPart)
    assert (before.begin, behind.end) == (0.0, 0.0)
    assert min(before.end, behind.begin) > 0.0
    last = len(given.points) - 1
    ends = part.curve.tool(np.array([0.0, part.curve.length]))
    for row, corner, far, length in ((0, 1, 0, before.end), (1, last - 1, last, behind.begin)):
        there = given.points[far] - given.points[corner]
        direction = there / np.linalg.norm(there)
        assert np.abs(ends.matrices[row, :3, 3] - given.points[corner] - length * direction).max() < ROUNDING
        assert np.abs(np.cross(ends.d1[row, :3], direction)).max() < 1e-9
        assert np.abs(ends.d2[row]).max() < 1e-4
    assert part.parameters[0] == pytest.approx(before.end, rel=1e-3)
    assert part.curve.length - part.parameters[-1] == pytest.approx(behind.begin, rel=1e-3)


def test_the_tool_turns_evenly_from_a_line_to_a_curve() -> None:
    given = between_lines()
    found = compressed(*given)
    before, part, _ = found.parts
    assert isinstance(before, StraightPart)
    assert isinstance(part, CurvePart)
    turn = Rotation.from_matrix(given.rotations[0]).inv() * Rotation.from_matrix(given.rotations[1])
    line = np.linalg.norm(given.points[1] - given.points[0])
    share = 1.0 - before.end / line
    on_line = Rotation.from_matrix(given.rotations[0]) * Rotation.from_rotvec(share * turn.as_rotvec())
    begin = part.curve.tool(np.array([0.0]))
    assert np.abs(begin.matrices[0, :3, :3] - on_line.as_matrix()).max() < SAME
    in_world = Rotation.from_matrix(given.rotations[0]).apply(turn.as_rotvec()) / line
    assert np.abs(begin.d1[0, 3:] - in_world).max() < 1e-6


@pytest.mark.parametrize(
    "given", [wave(60, 1e-2, 5e-3), helix(), drawn_parts()], ids=["wave", "helix", "parts"]
)
def test_points_are_passed_near_their_parameters(given: StraightChain) -> None:
    for part in curves(compressed(*given)):
        passed = part.curve.tool(part.parameters).matrices
        wanted = given.points[part.first : part.last + 1]
        assert np.abs(passed[:, :3, 3] - wanted).max() < 2e-4
        assert distances_from(given.points, passed[:, :3, 3]).max() <= part.deviation + ROUNDING
        turned = Rotation.from_matrix(passed[:, :3, :3]).inv() * Rotation.from_matrix(
            given.rotations[part.first : part.last + 1]
        )
        assert turned.magnitude().max() <= part.turn + SAME


MOVED = Rotation.from_rotvec([0.3, -1.1, 0.7])
SHIFT = np.array([1.2, -0.4, 0.9])


@pytest.mark.parametrize(
    "given", [wave(60, 1e-2, 5e-3), helix(), drawn_parts()], ids=["wave", "helix", "parts"]
)
def test_a_chain_in_another_frame_has_the_same_curves_there(given: StraightChain) -> None:
    one = compressed(*given)
    turned = MOVED.as_matrix() @ given.rotations
    other = compressed(MOVED.apply(given.points) + SHIFT, turned, given.zones, given.longest)
    assert one.breaks == other.breaks
    assert len(one.parts) == len(other.parts)
    for here, there in zip(curves(one), curves(other), strict=True):
        assert np.abs(here.parameters - there.parameters).max() < SAME
        assert abs(here.deviation - there.deviation) < SAME
        s = np.minimum(samples_of(here)[0], there.curve.length)
        a, b = here.curve.tool(s).matrices, there.curve.tool(s).matrices
        assert np.abs(MOVED.apply(a[:, :3, 3]) + SHIFT - b[:, :3, 3]).max() < SAME
        assert np.abs(MOVED.as_matrix() @ a[:, :3, :3] - b[:, :3, :3]).max() < SAME


@pytest.mark.parametrize(
    "given", [wave(60, 1e-2, 5e-3), rounded_arc(), drawn_parts()], ids=["wave", "arc", "parts"]
)
def test_a_chain_backwards_has_about_the_same_curves(given: StraightChain) -> None:
    one = compressed(*given)
    other = compressed(given.points[::-1], given.rotations[::-1], given.zones[::-1], given.longest)
    last = len(given.points) - 1
    assert sorted((last - point, cause.name) for point, cause in other.breaks) == [
        (point, cause.name) for point, cause in one.breaks
    ]
    for here, there in zip(curves(one), reversed(curves(other)), strict=True):
        assert (here.first, here.last) == (last - there.last, last - there.first)
        assert here.deviation == pytest.approx(there.deviation, rel=0.01)
        s = samples_of(here)[0] * (there.curve.length / here.curve.length)
        back = there.curve.positions(there.curve.length - s)
        ahead = here.curve.positions(samples_of(here)[0])
        assert np.abs(back - ahead).max() < here.deviation + ROUNDING


@pytest.mark.parametrize("factor", [0.1, 10.0])
def test_a_larger_chain_has_larger_curves(factor: float) -> None:
    given = drawn_parts()
    one = compressed(*given)
    other = compressed(factor * given.points, given.rotations, factor * given.zones, factor * given.longest)
    assert one.breaks == other.breaks
    for here, there in zip(curves(one), curves(other), strict=True):
        assert there.deviation == pytest.approx(factor * here.deviation, rel=1e-6)
        assert np.abs(there.parameters - factor * here.parameters).max() < SAME * factor


def test_two_runs_give_the_same_bits() -> None:
    given = uneven()
    assert compressed(*given) == compressed(*given)


@pytest.mark.parametrize("degrees", [5.0, 8.0, 11.0])
def test_two_moves_are_one_curve_as_near_to_their_point_as_its_blend(degrees: float) -> None:
    given = chain(drawn([(5.0, 0.0), (0.0, degrees), (5.0, 0.0)], 5e-3), 2.5e-3)
    part = only_curve(compressed(*given))
    pose = [Pose(point) for point in given.points]
    blend = blend_curve(Line(pose[0], pose[1]), 2.5e-3, Line(pose[1], pose[2]), 2.5e-3)
    assert isinstance(blend, Curve)
    middle = given.points[1:2]
    assert part.curve.distance(middle)[0] <= blend.distance(middle)[0]


def test_one_move_is_a_line() -> None:
    given = chain(np.array([[0.1, 0.0, 0.0], [0.1, 0.2, 0.0]]), 1e-3)
    assert compressed(*given) == Compression((StraightPart(0, 0.0, 0.0),), ())


def test_long_moves_stay_lines_without_a_break() -> None:
    points = drawn([(100.0, 0.0), (0.0, 10.0), (100.0, 0.0), (0.0, 10.0), (100.0, 0.0)], 0.1)
    found = compressed(*chain(points, 2e-3))
    assert [part.number for part in lines(found)] == [0, 1, 2]
    assert curves(found) == []
    assert found.breaks == ()


def test_a_move_that_would_bow_too_far_stays_a_line_for_the_tolerance() -> None:
    points = drawn([(30.0, 0.0), (0.0, 8.0), (30.0, 0.0), (0.0, 8.0), (30.0, 0.0)], 0.03)
    found = compressed(*chain(points, 2e-3))
    assert curves(found) == []
    assert found.breaks == ((1, BreakCause.TOLERANCE), (2, BreakCause.TOLERANCE))


@pytest.mark.parametrize("rotations", [None, Rotation.from_rotvec([0.2, 0.4, -2.0]).as_matrix()])
def test_a_chain_of_points_on_a_line_is_a_straight_curve(rotations: Array | None) -> None:
    shares = np.concatenate(([0.0], np.cumsum(np.random.default_rng(5).uniform(1e-3, 4e-3, 50))))
    points = [0.2, 0.3, -0.1] + shares[:, None] * [0.6, 0.0, 0.8]
    turned = None if rotations is None else np.tile(rotations, (len(points), 1, 1))
    part = only_curve(compressed(*chain(points, 1e-3, turned)))
    assert part.deviation < ROUNDING
    assert part.curve.length == pytest.approx(shares[-1], rel=1e-12)
    assert bent_of(part) < 1e-6


def test_points_a_micrometre_apart_between_centimetres_are_passed() -> None:
    lengths = np.array([0.05, 1e-6, 1e-6, 1e-6, 0.05])
    points = np.concatenate(([0.0], np.cumsum(lengths)))[:, None] * [1.0, 0.0, 0.0]
    points[3:, 1] += 0.02e-6
    given = StraightChain(points, np.tile(np.eye(3), (6, 1, 1)), np.full(4, 5e-3), 0.1)
    found = compressed(*given)
    for part in curves(found):
        s, _ = samples_of(part)
        assert distances_from(points, part.curve.positions(s)).max() <= part.deviation + ROUNDING


def test_an_orientation_that_stays_stays_exactly() -> None:
    given = wave(60, 1e-2, 5e-3)
    part = only_curve(compressed(*given))
    s, _ = samples_of(part)
    points = part.curve.tool(s)
    assert (points.matrices[:, :3, :3] == given.rotations[0]).all()
    assert not points.d1[:, 3:].any()
    assert part.turn == 0.0


@pytest.mark.parametrize("turns", [-1.0, 1.0, 2.5])
def test_the_wrist_turns_full_circles_along_a_chain(turns: float) -> None:
    given = wave(120, 5e-3, 3e-3)
    angles = np.linspace(0.0, turns * 2.0 * math.pi, 120)
    turned = Rotation.from_euler("Z", angles[:, None]) * Rotation.from_euler("Y", 0.5)
    part = only_curve(compressed(given.points, turned.as_matrix(), given.zones, given.longest))
    s = np.linspace(0.0, part.curve.length, 20_000)
    speed = part.curve.tool(s).d1[:, 5]
    assert np.sum(0.5 * (speed[1:] + speed[:-1]) * np.diff(s)) == pytest.approx(angles[-1], abs=1e-4)
    assert np.abs(speed - speed.mean()).max() < 0.1 * abs(speed.mean())


def test_a_turn_of_the_tool_without_a_smooth_course_breaks_the_chain() -> None:
    points = np.arange(41)[:, None] * [2e-3, 0.0, 0.0]
    angles = np.where(np.arange(41) <= 20, 0.0, 0.2 * (np.arange(41) - 20))
    turned = Rotation.from_euler("X", angles[:, None]).as_matrix()
    found = compressed(*chain(points, 1e-3, turned))
    assert (20, BreakCause.TOLERANCE) in found.breaks


def refused(given: StraightChain, words: str) -> None:
    with pytest.raises(ProfileError, match=words) as caught:
        compressed(*given)
    assert caught.value.diagnostic.code == "M540"


@pytest.mark.parametrize("number", [math.nan, math.inf])
def test_numbers_that_are_not_finite_are_refused(number: float) -> None:
    given = wave(10, 2.5e-3, 1e-3)
    points, rotations, zones = (one.copy() for one in given[:3])
    points[3, 1] = rotations[3, 0, 0] = zones[3] = number
    refused(given._replace(points=points), "a coordinate is not finite")
    refused(given._replace(rotations=rotations), "a matrix is no rotation")
    refused(given._replace(zones=zones), "a zone is")
    refused(given._replace(longest=math.nan), "the longest move is nan m")


def test_arguments_that_are_no_chain_are_refused() -> None:
    given = wave(10, 2.5e-3, 1e-3)
    refused(given._replace(zones=given.zones[1:]), "shapes")
    refused(given._replace(points=given.points[:1]), "shapes")
    refused(given._replace(zones=0.0 * given.zones), "a zone is 0 m")
    refused(given._replace(longest=0.0), "the longest move is 0 m")
    refused(given._replace(rotations=-given.rotations), "a matrix is no rotation")
    points = given.points.copy()
    points[4] = points[3] + [0.5 * SHORTEST_MOVE, 0.0, 0.0]
    refused(given._replace(points=points), "a move is 5e-07 m long, allowed are 1e-06 m or more")


def test_arguments_are_not_changed() -> None:
    given = helix()
    before = [one.copy() for one in given[:3]]
    compressed(*given)
    assert all((one == other).all() for one, other in zip(given[:3], before, strict=True))
