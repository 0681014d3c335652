"""The distance of the attained TCP from the path that is followed at that time."""

import numpy as np

from ropsim.motion import Line
from ropsim.simulation.move_span import PathSpan
from ropsim.simulation.record import path_errors
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
