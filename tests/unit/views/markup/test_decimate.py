import numpy as np
import numpy.typing as npt
import pytest

from ropsim.views.testing import along_curve, decimate, min_max

NONE = np.empty(0, dtype=np.intp)


def test_short_traces_keep_every_sample() -> None:
    (piece,) = min_max(np.arange(10.0), 100)
    assert piece.tolist() == list(range(10))


def test_extremes_and_ends_are_kept() -> None:
    values = np.zeros(10_007)
    values[1234], values[8765] = 5.0, -7.0
    (piece,) = min_max(values, 100)
    assert {0, 1234, 8765, 10_006} <= set(piece.tolist())
    assert piece.size <= 104


@pytest.mark.parametrize("n", [1000, 1001, 1499, 1999, 2001, 9_999])
def test_a_trace_keeps_to_its_number_of_points_and_two_ends(n: int) -> None:
    zigzag = np.arange(float(n)) * np.where(np.arange(n) % 2, -1.0, 1.0)
    (piece,) = min_max(zigzag, 1000)
    assert piece.size <= 1002


def test_gaps_split_the_trace() -> None:
    pieces = min_max(np.array([1.0, np.nan, 2.0, 3.0, np.nan]), 100)
    assert [piece.tolist() for piece in pieces] == [[0], [2, 3]]


def test_trace_without_samples_has_no_piece() -> None:
    assert min_max(np.full(5, np.nan), 100) == []
    assert min_max(np.empty(0), 100) == []


def test_trace_with_very_many_gaps_is_drawn_in_one_piece() -> None:
    values = np.where(np.arange(4000) % 2 == 0, 1.0, np.nan)
    assert len(min_max(values, 100)) == 1


def test_curve_drops_samples_that_do_not_move_and_those_on_the_way() -> None:
    x, y = np.repeat(np.arange(5.0), 100), np.repeat([0.0, 1.0, 0.0, 1.0, 0.0], 100)
    assert along_curve(x, y, 0.1, 1000, NONE).tolist() == [0, 100, 200, 300, 499]
    assert along_curve(x, np.zeros(500), 0.1, 1000, NONE).tolist() == [0, 499]


def test_curve_keeps_to_its_number_of_points() -> None:
    angle = np.linspace(0.0, 40.0, 5000)
    assert along_curve(np.cos(angle), np.sin(angle), 1e-6, 300, NONE).size <= 302


def test_a_curve_has_as_many_corners_as_it_may_but_not_one_more() -> None:
    x = np.arange(22.0)
    y = x % 2
    assert along_curve(x, y, 0.1, 20, NONE).tolist() == list(range(22))
    assert along_curve(x, y, 0.1, 19, NONE).size < 21


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_curve_beyond_its_end_or_before_its_begin_is_drawn_to_its_farthest_place(sign: float) -> None:
    x = np.concatenate([np.linspace(0.0, 12.0, 50), np.linspace(12.0, 10.0, 21)[1:]])[:: int(sign)]
    assert 12.0 in x[along_curve(x, 0.0 * x, 0.1, 1000, NONE)]


def test_a_drawn_curve_is_nowhere_off_by_more_than_the_tolerance_and_keeps_its_corners() -> None:
    angle = np.linspace(0.0, 0.5 * np.pi, 800)
    side = np.linspace(0.0, 100.0, 701)
    x = np.concatenate((100.0 * np.cos(angle), np.zeros(701), side))
    y = np.concatenate((100.0 * np.sin(angle), 100.0 - side, np.zeros(701)))
    kept = along_curve(x, y, 0.25, 2500, np.array([1100]))
    assert {0, 1100, len(x) - 1} < set(kept.tolist())
    for corner in ((0.0, 100.0), (0.0, 0.0)):
        assert np.hypot(x[kept] - corner[0], y[kept] - corner[1]).min() < 0.05
    a, b = np.stack((x, y), axis=1)[kept[:-1]], np.stack((x, y), axis=1)[kept[1:]]
    ways = b - a
    away = np.stack((x, y), axis=1)[:, None] - a
    share = np.clip(np.sum(away * ways, axis=2) / np.sum(ways * ways, axis=1), 0.0, 1.0)
    assert np.linalg.norm(away - share[..., None] * ways, axis=2).min(axis=1).max() < 0.25
    assert kept.size < 40


def test_a_curve_of_very_many_places_is_drawn_as_closely_with_work_that_grows_with_its_length() -> None:
    def figure(laps: int) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        angle = np.linspace(0.0, laps * 2.0 * np.pi, laps * 4000)
        return 200.0 * np.cos(angle), 150.0 * np.sin(2.0 * angle)

    x, y = figure(12)  # 48,000 places, each in a cell of its own
    tolerance = 0.05
    kept = along_curve(x, y, tolerance, 10_000, NONE)
    assert kept.size < 8000
    begin = np.searchsorted(kept, np.arange(x.size), side="right") - 1
    begin = np.minimum(begin, kept.size - 2)
    places, at = np.stack((x, y), axis=1), np.stack((x[kept], y[kept]), axis=1)
    ways, away = at[begin + 1] - at[begin], places - at[begin]
    share = np.clip(np.sum(away * ways, axis=1) / np.sum(ways * ways, axis=1), 0.0, 1.0)
    assert np.linalg.norm(away - share[:, None] * ways, axis=1).max() < tolerance
    assert looks(figure(24), tolerance) < 2.5 * looks(figure(12), tolerance)
    assert looks(figure(12), tolerance) > x.size


def looks(curve: tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]], tolerance: float) -> int:
    """Return how many distances from straight lines were taken to thin a curve."""
    taken = 0
    kept = decimate._away

    def counted(places: npt.NDArray[np.float64], ways: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        nonlocal taken
        taken += len(places)
        return kept(places, ways)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(decimate, "_away", counted)
        along_curve(*curve, tolerance, 100_000, NONE)
    return taken
