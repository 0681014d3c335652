import numpy as np

from ropsim.views.decimate import along_curve, min_max


def test_short_traces_keep_every_sample() -> None:
    (piece,) = min_max(np.arange(10.0), 100)
    assert piece.tolist() == list(range(10))


def test_extremes_and_ends_are_kept() -> None:
    values = np.zeros(10_007)
    values[1234], values[8765] = 5.0, -7.0
    (piece,) = min_max(values, 100)
    assert {0, 1234, 8765, 10_006} <= set(piece.tolist())
    assert piece.size <= 104


def test_gaps_split_the_trace() -> None:
    pieces = min_max(np.array([1.0, np.nan, 2.0, 3.0, np.nan]), 100)
    assert [piece.tolist() for piece in pieces] == [[0], [2, 3]]


def test_trace_without_samples_has_no_piece() -> None:
    assert min_max(np.full(5, np.nan), 100) == []
    assert min_max(np.empty(0), 100) == []


def test_trace_with_very_many_gaps_is_drawn_in_one_piece() -> None:
    values = np.where(np.arange(4000) % 2 == 0, 1.0, np.nan)
    assert len(min_max(values, 100)) == 1


def test_curve_drops_samples_that_do_not_move() -> None:
    x = np.repeat(np.arange(5.0), 100)
    kept = along_curve(x, np.zeros(500), 0.1, 1000)
    assert kept.tolist() == [0, 100, 200, 300, 400]


def test_curve_keeps_to_its_number_of_points() -> None:
    angle = np.linspace(0.0, 40.0, 5000)
    assert along_curve(np.cos(angle), np.sin(angle), 1e-6, 300).size <= 300
