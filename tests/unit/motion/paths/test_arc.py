"""Arcs: through their three points, as far as they are to go, with the tool turning as it is told."""

import math

import numpy as np
import pytest

from ropsim.motion import Arc, ArcFault, ArcOrientation, Curve, Line, OrientationMode, arc, blend_curve, leave
from ropsim.spatial import Pose
from support.paths import brute_distances, inner_places, random_pose, tool_differences

ROUNDING = 1e-12
RNG = np.random.default_rng(30)
START, VIA, END = random_pose(RNG), random_pose(RNG), random_pose(RNG)
TURN = OrientationMode.DRIVE_TRANSFORM


def made(
    start: Pose,
    via: Pose,
    end: Pose,
    *,
    angle: float | None = None,
    orientation: ArcOrientation | None = None,
) -> Arc:
    """Return an arc that there is."""
    found = arc(start, via, end, orientation or ArcOrientation.TO_THE_END, TURN, angle)
    assert isinstance(found, Arc)
    return found


def on_circle(angle: float, radius: float = 0.5) -> Pose:
    """Return a pose on a circle about the origin in the plane z = 0.2 m."""
    return Pose(np.array([radius * math.cos(angle), radius * math.sin(angle), 0.2]))


ARC = made(START, VIA, END)


def test_an_arc_leads_from_its_start_through_the_via_point_to_its_end() -> None:
    ends = ARC.tool(np.array([0.0, ARC.length])).matrices
    assert np.abs(ends - [START.matrix(), END.matrix()]).max() < ROUNDING
    assert ARC.distance(VIA.position[None])[0] < ROUNDING


@pytest.mark.parametrize("orientation", ArcOrientation)
def test_the_derivatives_of_an_arc_are_those_of_its_poses(orientation: ArcOrientation) -> None:
    path = made(START, VIA, END, orientation=orientation)
    s = inner_places(path.length)
    d1, d2 = tool_differences(path, s, 1e-3 * path.length)
    assert np.abs(path.tool(s).d1 - d1).max() < 1e-9
    assert np.abs(path.tool(s).d2 - d2).max() < 1e-9
    assert np.abs(np.linalg.norm(path.tool(s).d1[:, :3], axis=1) - 1.0).max() < ROUNDING


@pytest.mark.parametrize("end", [0.3, 1.5, math.pi, 4.0, 6.2, -0.3, -math.pi + 0.1, -5.0])
def test_arcs_go_round_the_side_of_the_via_point(end: float) -> None:
    # the via point lies between start and end in the sense of the arc, near its start or near its end
    for share in (0.01, 0.5, 0.99):
        path = made(on_circle(0.0), on_circle(share * end), on_circle(end))
        assert path.radius == pytest.approx(0.5, rel=1e-9)
        assert path.angle == pytest.approx(abs(end), rel=1e-9)
        assert path.length == pytest.approx(0.5 * abs(end), rel=1e-9)
        way = np.linspace(0.0, 1.0, 9)
        wanted = np.array([on_circle(end * r).position for r in way])
        assert np.abs(path.positions(way * path.length) - wanted).max() < 1e-10


@pytest.mark.parametrize("angle", [0.1, 1.0, math.pi, 2.0 * math.pi, 9.0])
def test_an_angle_says_how_far_the_arc_goes(angle: float) -> None:
    path = made(on_circle(0.0), on_circle(0.7), on_circle(2.0), angle=angle)
    assert path.length == pytest.approx(0.5 * angle, rel=ROUNDING)
    assert path.positions(np.array([path.length]))[0] == pytest.approx(
        on_circle(angle).position, abs=ROUNDING
    )


def test_with_an_angle_the_tool_has_the_orientation_of_the_end_where_the_way_ends() -> None:
    path = made(START, VIA, END, angle=0.4)
    assert path.tool(np.array([path.length])).matrices[0, :3, :3] == pytest.approx(
        END.rotation(), abs=ROUNDING
    )


def test_with_the_arc_the_tool_stays_as_it_is_to_tangent_and_plane() -> None:
    path = made(START, VIA, END, angle=8.0, orientation=ArcOrientation.WITH_THE_ARC)
    points = path.tool(np.linspace(0.0, path.length, 50))
    tangents, inward = points.d1[:, :3], points.d2[:, :3] * path.radius
    frames = np.stack((tangents, inward, np.cross(tangents, inward)), axis=2)
    relative = np.swapaxes(frames, 1, 2) @ points.matrices[:, :3, :3]
    assert np.abs(relative - relative[0]).max() < ROUNDING
    assert np.linalg.norm(points.d1[:, 3:], axis=1) == pytest.approx(np.full(50, 1.0 / path.radius), rel=1e-9)


def test_the_orientation_at_the_via_point_does_not_count() -> None:
    assert made(START, Pose(VIA.position), END) == ARC


@pytest.mark.parametrize("angle", [None, 0.5, 4.0, 2.0 * math.pi, 20.0])
def test_the_distance_from_an_arc_agrees_with_a_search(angle: float | None) -> None:
    path = made(START, VIA, END, angle=angle)
    points = np.random.default_rng(31).normal(size=(100, 3)) * 2.0
    brute, found = brute_distances(path, points), path.distance(points)
    assert (found <= brute + ROUNDING).all()
    assert found == pytest.approx(brute, abs=1e-5)
    assert path.distance(path.positions(inner_places(path.length))).max() < ROUNDING


def test_the_distance_of_the_centre_is_the_radius() -> None:
    path = made(on_circle(0.0), on_circle(0.7), on_circle(2.0))
    assert path.distance(np.array([[0.0, 0.0, 0.2]]))[0] == pytest.approx(0.5, rel=ROUNDING)


def test_a_moved_arc_is_the_arc_of_moved_points() -> None:
    X = random_pose(np.random.default_rng(32))
    s = np.linspace(0.0, ARC.length, 21)
    moved = made(X @ START, X @ VIA, X @ END)
    assert np.abs(moved.tool(s).matrices - X.matrix() @ ARC.tool(s).matrices).max() < ROUNDING


def test_an_arc_flown_backwards_is_the_arc_of_the_points_backwards() -> None:
    back, s = made(END, VIA, START), np.linspace(0.0, ARC.length, 21)
    assert back.length == pytest.approx(ARC.length, rel=ROUNDING)
    assert np.abs(back.positions(ARC.length - s) - ARC.positions(s)).max() < ROUNDING


def test_flat_arcs_keep_their_accuracy() -> None:
    via = Pose(np.array([0.5, 2e-5, 0.0]))  # a radius of 6 km
    path = made(Pose(), via, Pose(np.array([1.0, 0.0, 0.0])))
    assert path.positions(np.array([path.length]))[0] == pytest.approx([1.0, 0.0, 0.0], abs=ROUNDING)
    assert path.distance(via.position[None])[0] < ROUNDING


def point(x: float, y: float = 0.0) -> Pose:
    return Pose(np.array([x, y, 0.0]))


@pytest.mark.parametrize(
    ("poses", "fault"),
    [
        ((point(0), point(1), point(0)), ArcFault.END_AT_START),
        ((point(0), point(0), point(1)), ArcFault.VIA_AT_START),
        ((point(0), point(1), point(1, 1e-10)), ArcFault.VIA_AT_END),
        ((point(0), point(1), point(2)), ArcFault.COLLINEAR),
        ((point(0), point(2), point(1)), ArcFault.COLLINEAR),
        ((point(0), point(1, 1e-6), point(2)), ArcFault.COLLINEAR),
        ((point(0), point(math.nan), point(2)), ArcFault.NOT_FINITE),
        ((point(0), point(1, 1), point(math.inf)), ArcFault.NOT_FINITE),
    ],
)
def test_points_that_give_no_circle_are_told(poses: tuple[Pose, Pose, Pose], fault: ArcFault) -> None:
    assert arc(*poses) is fault


@pytest.mark.parametrize(
    ("angle", "fault"), [(0.0, ArcFault.NO_ANGLE), (-1.0, ArcFault.NO_ANGLE), (math.nan, ArcFault.NOT_FINITE)]
)
def test_angles_that_are_no_way_are_told(angle: float, fault: ArcFault) -> None:
    assert arc(START, VIA, END, angle=angle) is fault


def test_a_corner_between_line_and_arc_takes_on_the_bend_of_the_arc() -> None:
    line = Line(random_pose(RNG), START)
    zone = leave(line.positions, line.length, 0.2, line.length / 2.0)
    curve = blend_curve(line, zone, ARC, 0.15)
    assert isinstance(curve, Curve)
    for path, place, end in ((line, zone, 0.0), (ARC, 0.15, curve.length)):
        there, here = path.tool(np.array([place])), curve.tool(np.array([end]))
        assert np.abs(here.matrices - there.matrices).max() < ROUNDING
        assert np.abs(here.d1 - there.d1).max() < 1e-11
        assert np.abs(here.d2 - there.d2).max() < 1e-9
