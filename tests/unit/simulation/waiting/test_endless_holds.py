"""A hold that nobody ends is found at once, in a motion, between instructions and beside waits."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import SLOWEST, MoveEvent, OverrideChange, Recording, channel_name
from ropsim.model import Cell, Signal, Station
from ropsim.simulation import Fidelity, NobodyWatches, RunOptions, RunView, run
from ropsim.spatial import Pose
from support.compiled import station_code

ARM = robots.load("puma560")
AWAY = Pose(np.array([5.0, 0.0, 0.0]))
MOVES = ("mov (500, -200, 300)", "lin (500, 200, 300) speed 100 mm/s")
BRAKED = 0.5
"""Within which an arm on its way stands when it is held [s]."""


def cell(*names: str, serves: str = "") -> Cell:
    controller = robots.default_controller(ARM)
    stations = {
        name: Station(
            name, ARM, controller, AWAY if k else Pose(), start=ARM.home, program=name, serves=name == serves
        )
        for k, name in enumerate(names)
    }
    signals = {"a": Signal("a", is_input=False), "go": Signal("go", is_input=True, changes=((2.0, 1.0),))}
    return Cell("c", stations, signals=signals)


def ran(cell: Cell, *overrides: tuple[float, float], **programs: tuple[str, ...]) -> Recording:
    codes = {name: station_code(cell, name, *lines) for name, lines in programs.items()}
    changes = tuple(OverrideChange(*one) for one in overrides)
    return run(cell, codes, RunOptions(Fidelity.KINEMATIC, overrides=changes))


def test_a_motion_that_is_held_for_ever_ends_where_it_stands() -> None:
    recording = ran(cell("left"), (1.5, 0.0), left=MOVES)
    (found,) = recording.findings
    assert (found.code, found.data) == ("S762", {"station": "left", "time_s": 1.5, "pass": 1})
    assert found.span is not None
    assert found.span.line == 4
    assert found.message.startswith("`left` is held for ever: the override is 0 from t = 1.50 s on")
    assert 1.5 < recording.duration < 1.5 + BRAKED
    moves = recording.events_of(MoveEvent)
    assert moves[-1].duration > 0.0


def test_a_program_that_is_held_between_two_instructions_ends_there() -> None:
    recording = ran(cell("left"), (0.5, 0.0), left=("wait 1 s", "mov (500, -200, 300)"))
    assert [(one.code, one.span.line if one.span else 0) for one in recording.findings] == [("S762", 3)]
    assert 1.0 <= recording.duration < 1.02


def test_a_run_may_be_held_from_its_start_on() -> None:
    held = ran(cell("left"), (0.0, 0.0), (1.0, 1.0), left=MOVES)
    free = ran(cell("left"), left=MOVES)
    assert held.findings == ()
    assert held.duration == pytest.approx(free.duration + 1.0, abs=0.02)
    assert np.ptp(held.channels[channel_name("q", "left")].values[held.time < 1.0], axis=0).max() == 0.0


def test_a_hold_that_ends_is_none_even_if_another_one_comes() -> None:
    recording = ran(cell("left"), (0.0, 0.0), (1.0, 1.0), (2.0, 0.0), left=MOVES)
    assert [one.data["time_s"] for one in recording.findings] == [2.0]
    assert 2.0 < recording.duration < 2.0 + BRAKED


def test_one_that_is_never_let_go_is_told_without_a_line() -> None:
    recording = ran(cell("left"), (0.0, 0.0), left=MOVES)
    assert [(one.code, one.span) for one in recording.findings] == [("S762", None)]
    assert recording.duration < 0.02
    assert recording.events == ()


@pytest.mark.parametrize("tiny", [1e-300, 0.5 * SLOWEST])
def test_an_override_with_which_no_program_ends_is_a_hold(tiny: float) -> None:
    recording = ran(cell("left"), (1.5, tiny), left=MOVES)
    (found,) = recording.findings
    assert (found.code, found.data["time_s"]) == ("S762", 1.5)
    assert "less than 0.001 counts as 0" in found.hint
    assert recording.facts.overrides == (OverrideChange(1.5, 0.0),)


def test_the_slowest_override_is_none() -> None:
    recording = ran(cell("left"), (0.5, SLOWEST), (1.5, 1.0), left=MOVES)
    assert recording.findings == ()
    assert recording.facts.overrides == (OverrideChange(0.5, SLOWEST), OverrideChange(1.5, 1.0))


def test_who_waits_for_one_that_is_held_is_told_so() -> None:
    recording = ran(cell("left", "right"), (1.0, 0.0), left=("wait until a",), right=(*MOVES, "set a on"))
    left, right = recording.findings
    assert (left.code, right.code) == ("S742", "S762")
    assert "`a` is set by the program of `right`, which is held on line 3" in left.message
    assert recording.duration < 1.0 + BRAKED


def test_a_wait_whose_signal_is_still_to_come_is_waited_out() -> None:
    recording = ran(cell("left", "right"), (0.5, 0.0), left=("wait until go",), right=MOVES)
    assert [one.code for one in recording.findings] == ["S762", "S762"]
    assert 2.0 <= recording.duration < 2.02


def test_one_that_only_serves_is_ended_without_a_word() -> None:
    both = cell("left", "right", serves="right")
    recording = ran(both, (1.0, 0.0), left=MOVES, right=("while true", "wait until a", "set a off", "endw"))
    assert [one.data["station"] for one in recording.findings] == ["left"]


class Onlooker(NobodyWatches):
    """Lets the run go on after a while."""

    is_done = False

    @property
    def may_press(self) -> bool:
        return True

    def advanced(self, run: RunView) -> None:
        if run.time > 3.0 and not self.is_done:
            self.is_done = True
            run.set_override(1.0)


def test_somebody_who_looks_on_may_let_it_go() -> None:
    one = cell("left")
    options = RunOptions(Fidelity.KINEMATIC, overrides=(OverrideChange(1.0, 0.0),), watch=Onlooker())
    recording = run(one, {"left": station_code(one, "left", *MOVES)}, options)
    assert recording.findings == ()
    assert recording.duration > 3.0
