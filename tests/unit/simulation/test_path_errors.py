"""The distance of the attained TCP from the path that is followed at that time."""

import numpy as np

from ropsim.motion import Arc, Line, arc
from ropsim.simulation.testing import PathSpan, path_errors
from ropsim.spatial import Pose

ALONG_X = Line(Pose(), Pose(np.array([1.0, 0.0, 0.0])))
ALONG_Y = Line(Pose(np.array([1.0, 0.0, 0.0])), Pose(np.array([1.0, 1.0, 0.0])))
TICKS = np.arange(0.0, 60.0, 10.0)
Q = np.zeros((len(TICKS), 1))  # of no use: the paths lie in the base frame
PLACES = np.array(
    [[0.0, 0.0, 0.5], [0.5, 2.0, 0.0], [1.0, 0.0, 0.3], [1.0, 0.4, 0.0], [1.2, 0.9, 0.0], [9.0, 9.0, 9.0]]
)


def test_errors_are_those_from_the_path_in_force_and_unknown_where_there_is_none() -> None:
    paths = [PathSpan(ALONG_X, 0, 20), PathSpan(ALONG_Y, 20, 40)]
    errors = path_errors(paths, TICKS, Q, PLACES)
    assert np.isnan(errors).tolist() == [True, False, False, False, False, True]
    assert np.abs(errors[1:5] - [2.0, 0.3, 0.0, 0.2]).max() < 1e-15


def test_a_row_at_which_two_paths_meet_belongs_to_the_first() -> None:
    errors = path_errors([PathSpan(ALONG_X, 0, 20), PathSpan(ALONG_Y, 20, 40)], TICKS, Q, PLACES)
    assert errors[2] == 0.3
    assert path_errors([PathSpan(ALONG_Y, 10, 40)], TICKS, Q, PLACES)[2] == 0.3
    assert np.isnan(path_errors([PathSpan(ALONG_Y, 20, 40)], TICKS, Q, PLACES)[2])


def test_a_path_between_two_rows_has_no_error() -> None:
    assert np.isnan(path_errors([PathSpan(ALONG_X, 21, 29)], TICKS, Q, PLACES)).all()


def test_a_circle_flown_with_another_radius_is_off_by_the_difference_and_one_flown_well_by_nothing() -> None:
    start, via, end = (Pose(0.1 * np.array(one)) for one in ([1.0, 0, 0], [0, 1.0, 0], [-1.0, 0, 0]))
    around = arc(start, via, end, angle=2.0 * np.pi)
    assert isinstance(around, Arc)
    turn = np.linspace(0.1, 6.0, 200)
    circle = np.column_stack([np.cos(turn), np.sin(turn), np.zeros_like(turn)])
    q = np.zeros((200, Q.shape[1]))
    ticks, spans = np.arange(1.0, 201.0), [PathSpan(around, 0, 200)]
    assert np.abs(path_errors(spans, ticks, q, 0.102 * circle) - 0.002).max() < 1e-15
    assert path_errors(spans, ticks, q, 0.1 * circle).max() < 1e-15
