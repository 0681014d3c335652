"""The grid of a path: places from start to end, all at which a third derivative jumps among them."""

import numpy as np

from ropsim.motion import Curve, Line, Seen, SplineFault, ToolSection, grid, spline
from ropsim.spatial import Array, Pose

SAME_PLACE = 1e-12
POINTS = np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.15, 0.05, 0.0], [0.15, 0.05, 0.002], [0.2, 0.1, 0.1]])


def way() -> Curve:
    found = spline([Pose(point) for point in POINTS])
    assert not isinstance(found, SplineFault)
    return found


def nearest(places: Array, path: Curve, point: Array) -> float:
    return float(np.linalg.norm(path.positions(places) - point, axis=1).min())


def test_it_goes_from_start_to_end_in_rising_order() -> None:
    path = way()
    for one in (
        path,
        Line(Pose(), Pose(POINTS[1])),
        ToolSection(path, 0.01, 0.2),
        Seen(path, Pose(POINTS[2])),
    ):
        places = grid(one)
        assert (places[0], places[-1]) == (0.0, one.length)
        assert (np.diff(places) > 0.0).all()


def test_the_points_of_a_spline_are_in_it() -> None:
    path = way()
    places = grid(path)
    assert all(nearest(places, path, point) <= SAME_PLACE for point in POINTS)
    section = ToolSection(path, 0.01, path.length - 0.01)
    inner = grid(section) + section.begin
    assert all(nearest(inner, path, point) <= SAME_PLACE for point in POINTS[1:-1])
    assert grid(Seen(path, Pose(POINTS[2]))).tolist() == places.tolist()


def test_a_short_part_of_a_spline_has_as_many_places_as_a_long_one() -> None:
    path = way()
    places = grid(path)
    knots = [int(np.linalg.norm(path.positions(places) - point, axis=1).argmin()) for point in POINTS]
    assert len(set(np.diff(knots).tolist())) == 1
