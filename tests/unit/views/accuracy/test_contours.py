"""Contours whose attained path is known exactly: distance from the whole, error in time, what is drawn."""

import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from ropsim.flow import Channel, Fidelity, MotionKind, MoveEvent, Origin, Recording, TaskEvent
from ropsim.spatial import Array
from ropsim.views import summarize
from ropsim.views.testing import ContourFigures, contour_section, contours, station_views, stop_figures
from support.recordings import SOURCE, facts

HZ = 100
SIDE = 0.1
CORNERS = SIDE * np.array([[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1], [0, 0, 0]])
ROUNDING = 1e-12


def square(attained: Array | None = None, kinds: str = "LLLL") -> Recording:
    """Return a run of the sides of a square, each in a second, with half a second of rest at its end."""
    time = np.arange(4 * HZ + 1) / HZ
    ends = np.sort(np.concatenate((np.arange(5.0), np.arange(4) + 0.5)))
    at_ends = CORNERS[[0, 1, 1, 2, 2, 3, 3, 4, 4]]
    command = np.column_stack([np.interp(time, ends, column) for column in at_ends.T])
    names = ("x", "y", "z")
    channels = {
        "command_position": Channel(command, "m", names),
        "attained_position": Channel(command if attained is None else attained, "m", names),
        "tau": Channel(np.zeros((len(time), 1)), "N·m", ("1",)),
    }
    motions = {"L": MotionKind.LIN, "P": MotionKind.PTP}
    moves = [
        MoveEvent(float(k), 1.0, "robot", Origin(SOURCE.span(k + 1)), motion=motions[kind], ordinal=k)
        for k, kind in enumerate(kinds)
    ]
    return Recording(time, channels, tuple(moves), (), 4.0, facts())


def found(recording: Recording) -> list[ContourFigures]:
    (station,) = station_views(recording)
    return [one for one, _ in contours(station, stop_figures(station))]


def test_an_arm_that_is_late_by_a_time_errs_in_time_and_not_from_the_contour() -> None:
    late = 7  # rows
    command = square().channels["command_position"].values
    attained = np.concatenate((np.repeat(command[:1], late, axis=0), command[:-late]))
    (one,) = found(square(attained))
    assert one.path_max == pytest.approx(0.0, abs=ROUNDING)
    assert one.tracking_max == pytest.approx(late / HZ * 2.0 * SIDE, abs=ROUNDING)
    assert one.tracking_end == pytest.approx(late / HZ * 2.0 * SIDE, abs=ROUNDING)
    assert (one.lines, one.moves, one.start) == ((1, 4), 4, 0.0)
    assert one.planned_end == pytest.approx(3.5)


def test_a_shift_inwards_errs_by_its_amount_and_one_out_of_the_plane_too() -> None:
    command = square().channels["command_position"].values
    middle = 0.5 * SIDE * np.array([1.0, 0.0, 1.0])
    (one,) = found(square(middle + 0.9 * (command - middle)))
    assert one.path_max == pytest.approx(0.05 * SIDE, abs=ROUNDING)
    assert one.path_mean == pytest.approx(0.05 * SIDE, abs=ROUNDING)  # a smaller square: everywhere alike
    (one,) = found(square(command + np.array([0.0, 0.003, 0.0])))
    assert one.path_max == pytest.approx(0.003, abs=ROUNDING)


@pytest.mark.parametrize("seed", range(5))
def test_the_path_error_is_the_distance_to_the_nearest_side(seed: int) -> None:
    rng = np.random.default_rng(seed)
    command = square().channels["command_position"].values
    attained = command + 0.02 * rng.uniform(-1.0, 1.0, command.shape)
    least = np.full(len(attained), np.inf)
    for begin, end in pairwise(CORNERS):
        share = np.clip((attained - begin) @ (end - begin) / SIDE**2, 0.0, 1.0)
        least = np.minimum(least, np.linalg.norm(attained - begin - share[:, None] * (end - begin), axis=1))
    (one,) = found(square(attained))
    assert one.path_max == pytest.approx(least.max(), abs=ROUNDING)
    assert one.path_mean == pytest.approx(least.mean(), abs=ROUNDING)
    assert one.time == pytest.approx(float(least.argmax()) / HZ)


@pytest.mark.parametrize(
    ("kinds", "moves"),
    [("LLLL", [4]), ("LLLP", [3]), ("PLLL", [3]), ("LLPL", [2]), ("LPLL", [2]), ("LPLP", []), ("PPPP", [])],
)
def test_moves_in_a_row_that_turn_aside_make_a_contour(kinds: str, moves: list[int]) -> None:
    assert [one.moves for one in found(square(kinds=kinds))] == moves


def test_down_to_a_part_and_up_again_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(globals(), "CORNERS", CORNERS[[0, 1, 0, 1, 0]])
    assert found(square()) == []


def test_an_arm_without_drives_has_no_contours() -> None:
    run = square()
    assert found(replace(run, facts=replace(run.facts, fidelity=Fidelity.KINEMATIC))) == []


def test_the_innermost_task_gives_its_name() -> None:
    run = square()
    main = TaskEvent(0.0, 4.0, "robot", name="main", serial=0, depth=0)
    too_short = TaskEvent(0.0, 3.9, "robot", name="Side", serial=1, depth=2)
    whole = TaskEvent(0.0, 4.0, "robot", name="Square", serial=2, depth=1)
    for tasks, name in (((main, too_short), "main"), ((main, too_short, whole), "Square"), ((), "")):
        (one,) = found(replace(run, events=(*run.events, *tasks)))
        assert one.task == name


def test_the_drawing_enlarges_each_distance_by_the_factor_it_states() -> None:
    command = square().channels["command_position"].values
    off = 0.0007
    attained = command + np.array([0.0, 0.0, off])
    run = square(attained)
    (station,) = summarize(run).stations
    page = contour_section(station, run, "")
    assert "error × 10" in page  # 0.08 · 100 mm / 0.7 mm = 11.4
    lines = re.findall(r'<polyline points="([^"]+)"', page)
    wanted, drawn = (
        np.array([[float(n) for n in place.split(",")] for place in line.split()]) for line in lines
    )
    scale = np.ptp(wanted[:, 0]) / (1e3 * SIDE)
    lowest = wanted[:, 1].min() - drawn[:, 1].min()  # upwards counts down
    assert lowest / scale == pytest.approx(10 * 1e3 * off, abs=0.2)
