"""Stations whose programs serve others: a gate in a loop is over when the arm that it opens for is done."""

from functools import cache

import numpy as np
import pytest

from ropsim import language
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import MoveEvent, OutputEvent, Recording
from ropsim.model import Cell
from ropsim.simulation import Fidelity, RunOptions, RunView, run
from ropsim.workbench import environment_of

AXIS = """
[stations.{name}]
base = {{ position = [{x}, 0, 500] }}
{serves}
[stations.{name}.mechanism]
kind = "slide"
low = 0
high = 900
size = [300, 200, 20]
mass = 15
speed = 800
acceleration = 2000
"""
SIGNALS = "".join(
    f"[signals.{name}]\noutput = {number}\n" for number, name in enumerate(("open_gate", "is_open", "c"), 1)
)
HEAD = "program p\nunits mm, deg, s\n"
LOOP = (
    "repeat\nwait until open_gate\nmov joints(500)\nset is_open on\n"
    "wait until not open_gate\nset is_open off\nmov joints(0)\nendr\n"
)
PASS = "set open_gate on\nwait until is_open\nmov joints(300)\nset open_gate off\nwait until not is_open\n"
PATIENCE = 30.0  # [s] of simulated time: whoever is not ended before has not been ended
LOOK = 0.05  # [s]: a program that stands and looks has looked twice


@cache
def cell(*serving: str) -> Cell:
    names = ("arm", "gate", "lamp")
    text = SIGNALS + "".join(
        AXIS.format(name=name, x=1000 * k, serves="serves = true" if name in serving else "")
        for k, name in enumerate(names)
    )
    read, findings = read_cell(SourceText("cell.toml", text), "c")
    assert [str(one) for one in findings] == []
    assert read is not None
    return read


def ran(where: Cell, options: RunOptions | None = None, **texts: str) -> Recording:
    codes = {}
    for name, text in texts.items():
        compiled = language.compile(HEAD + text, environment_of(where, where.stations[name]), name)
        assert compiled.icr is not None, [str(one) for one in compiled.diagnostics]
        codes[name] = compiled.icr
    return run(where, codes, options or RunOptions(Fidelity.KINEMATIC, longest=PATIENCE))


def codes_of(recording: Recording) -> list[str]:
    return [one.code for one in recording.findings]


def moves_of(recording: Recording, name: str) -> int:
    return sum(one.station == name for one in recording.events_of(MoveEvent))


def end_of(recording: Recording, name: str) -> float:
    return max(one.end for one in recording.events if one.station == name)


def test_a_gate_that_serves_in_a_loop_ends_green_when_the_arm_is_done() -> None:
    recording = ran(cell("gate"), arm=PASS * 3, gate=LOOP)
    assert recording.findings == ()
    assert recording.ok
    assert (moves_of(recording, "arm"), moves_of(recording, "gate")) == (3, 6)


def test_one_that_does_not_serve_waits_in_vain() -> None:
    recording = ran(cell(), arm=PASS, gate=LOOP)
    assert codes_of(recording) == ["S742"]
    assert recording.findings[0].data["station"] == "gate"


def test_it_goes_on_to_its_next_wait_for_what_is_not_there() -> None:
    """The arm is done when it asks the gate to close: the gate closes, the run is as long as that takes."""
    asked = ran(cell("gate"), arm="set open_gate on\nwait until is_open\nset open_gate off\n", gate=LOOP)
    assert codes_of(asked) == []
    assert moves_of(asked, "gate") == 2
    assert asked.rows("gate/q")[-1] == pytest.approx(0.0, abs=1e-6)
    assert asked.duration == pytest.approx(end_of(asked, "gate"), abs=LOOK)
    assert asked.duration > end_of(asked, "arm") + 0.5


def test_the_run_is_as_long_as_the_programs_that_it_served() -> None:
    late = ran(cell("gate"), arm="wait 5 s\n", gate=LOOP)
    assert codes_of(late) == []
    assert late.duration == pytest.approx(5.0, abs=LOOK)


@pytest.mark.parametrize(
    "loop",
    [
        "repeat\nwait until open_gate and not c\nmov joints(500)\nendr\n",
        "repeat\nwait 0.02 s\nif open_gate then mov joints(500)\nendr\n",
        "n = 0\nrepeat\nwait 0.02 s\nif open_gate then mov joints(500)\nn = n + 1\nendr\n",
        "repeat\nif open_gate then mov joints(500)\nendr\n",
        "repeat\nwait until open_gate timeout 0.5 s else set c off\nendr\n",
        "repeat\nwait until open_gate and not c timeout 0.5 s else set c off\nendr\n",
    ],
)
def test_whatever_way_it_waits_it_is_ended(loop: str) -> None:
    recording = ran(cell("gate"), arm="wait 2 s\n", gate=loop)
    assert codes_of(recording) == []
    assert recording.duration == pytest.approx(2.0, abs=LOOK)


def test_a_wait_whose_signal_stays_lets_it_pass_once_more_only() -> None:
    loop = "repeat\nwait until not c\nmov joints(500)\nmov joints(0)\nendr\n"
    recording = ran(cell("gate"), arm="wait 1 s\n", gate=loop)
    assert codes_of(recording) == []
    once = ran(cell(), gate="mov joints(500)\nmov joints(0)\n").duration
    assert recording.duration < 1.0 + 2.0 * once + LOOK


def test_one_that_never_waits_is_found_after_the_longest_time() -> None:
    recording = ran(cell("gate"), arm="wait 1 s\n", gate="repeat\nmov joints(500)\nmov joints(0)\nendr\n")
    assert codes_of(recording) == ["S723"]


def test_one_that_ends_by_itself_is_waited_for() -> None:
    recording = ran(cell("gate"), arm="set c on\n", gate="wait 3 s\nset is_open on\n")
    assert codes_of(recording) == []
    assert recording.duration == pytest.approx(3.0, abs=1e-6)
    assert [one.channel for one in recording.events_of(OutputEvent)] == ["c", "is_open"]


def test_two_that_serve_each_other_end_both() -> None:
    chain = "repeat\nwait until is_open\nset c on\nwait until not is_open\nset c off\nendr\n"
    recording = ran(cell("gate", "lamp"), arm=PASS * 2, gate=LOOP, lamp=chain)
    assert codes_of(recording) == []


def test_a_wait_in_vain_is_told_of_the_others_only() -> None:
    recording = ran(cell("gate"), arm="set open_gate off\nwait until is_open\n", gate=LOOP)
    (found,) = recording.findings
    assert (found.code, found.data["station"]) == ("S742", "arm")
    assert "`is_open` is set by the program of `gate`, which waits for `open_gate`" in found.message
    assert recording.duration < 1.0


def test_a_finding_of_another_one_ends_it_too() -> None:
    recording = ran(cell("gate"), arm="n = 0\nx = 1 / n\nwait until c\n", gate=LOOP)
    assert [one.code for one in recording.findings if one.is_error] != []
    assert "S742" not in codes_of(recording)
    assert recording.duration < 1.0


class Onlooker:
    """Somebody who may press keys, and presses none."""

    may_press = True

    def advanced(self, run: RunView) -> None:
        pass

    def reading(self, run: RunView) -> None:
        pass

    def ended(self, run: RunView) -> None:
        pass


def test_a_live_run_ends_it_at_the_same_time() -> None:
    options = RunOptions(Fidelity.KINEMATIC, longest=PATIENCE, watch=Onlooker())
    live = ran(cell("gate"), options, arm=PASS * 2, gate=LOOP)
    alone = ran(cell("gate"), arm=PASS * 2, gate=LOOP)
    assert codes_of(live) == []
    np.testing.assert_array_equal(live.rows("gate/q"), alone.rows("gate/q"))
