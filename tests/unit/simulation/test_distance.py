import numpy as np

from ropsim.simulation.record import distance_from_segment


def test_distances_are_square_to_the_segment_and_round_at_its_ends() -> None:
    points = np.array([[0.5, 2.0, 0.0], [-3.0, 4.0, 0.0], [1.0, 0.0, 1.0]])
    found = distance_from_segment(points, np.zeros(3), np.array([1.0, 0.0, 0.0]))
    assert found.tolist() == [2.0, 5.0, 1.0]


def test_a_segment_without_length_is_a_point() -> None:
    found = distance_from_segment(np.array([[3.0, 4.0, 0.0]]), np.zeros(3), np.zeros(3))
    assert found.tolist() == [5.0]
