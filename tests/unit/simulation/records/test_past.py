"""What one arm does to a part that another one carries does not depend on how densely is recorded."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim import icr
from ropsim.controller import LawInput, LawTraits
from ropsim.flow import GripEvent, JointReference, Recording, ReleaseEvent
from ropsim.kinematics import forward
from ropsim.model import Cell, Rates
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.simulation.testing import Past, start_run
from ropsim.spatial import Array
from ropsim.workbench import environment_of

TWO_ARMS = Path(__file__).parents[4] / "examples" / "two_arms"
KINEMATIC = RunOptions(Fidelity.KINEMATIC)
ROUNDING = 1e-12  # [m | -], of some products of poses
RATES = (1, 10, 100, 1000)  # [Hz]


def runnable() -> tuple[Cell, dict[str, icr.Program]]:
    project = ropsim.open(TWO_ARMS)
    return project.runnable(project.programs())


def compiled(cell: Cell, *lines: str) -> icr.Program:
    text = "\n".join(("program p", "units mm, deg, s", *lines, ""))
    found = ropsim.language.compile(text, environment_of(cell, cell.first))
    assert found.icr is not None
    return found.icr


def told(recording: Recording) -> object:
    """Return what must not depend on the rows, with numbers that are compared exactly."""
    grips = [
        (one.time, one.duration, one.station, one.part)
        for one in recording.events
        if isinstance(one, GripEvent | ReleaseEvent)
    ]
    return recording.placements, recording.facts.destinations, recording.findings, grips, recording.duration


@pytest.mark.slow
@pytest.mark.parametrize("fidelity", list(Fidelity))
def test_placements_destinations_and_findings_do_not_depend_on_the_rate_of_recording(
    fidelity: Fidelity,
) -> None:
    """One arm waits where it holds the post out, with drives it gives way a little all the time."""
    cell, codes = runnable()
    dense = run(cell, codes, RunOptions(fidelity, record_hz=RATES[-1]))
    assert dense.findings == ()
    for rate in RATES[:-1]:
        recording = run(cell, codes, RunOptions(fidelity, record_hz=rate))
        assert len(recording.time) < len(dense.time) / 9
        assert told(recording) == told(dense)


@pytest.mark.slow
def test_rows_that_are_thinned_change_nothing_either() -> None:
    cell, codes = runnable()
    dense, thin = (run(cell, codes, RunOptions(most_rows=most)) for most in (1_000_000, 20))
    assert len(thin.time) <= 20
    assert told(thin) == told(dense)


def test_the_rows_of_an_arm_beside_others_are_those_of_the_arm_alone() -> None:
    """With others about, a row is written at every tick and thinned; it must be the same bits."""
    cell, _ = runnable()
    alone = Cell("c", {"left": cell.stations["left"]}, signals=cell.signals)
    beside = replace(alone, stations={**alone.stations, "right": cell.stations["right"]})
    code = compiled(alone, "mov joints(20, 60, -150, 0, -60, 0)", "wait 0.3 s", "mov home")
    for rate in (250, 7):
        one, other = (run(made, {"left": code}, RunOptions(record_hz=rate)) for made in (alone, beside))
        np.testing.assert_array_equal(one.time, other.time)
        for name in ("left/q", "left/qd", "left/tau", "left/current", "left/voltage", "left/q_ref"):
            np.testing.assert_array_equal(one.channels[name].values, other.channels[name].values)


class Proportional:
    """A joint controller in Python: called once in a tick, it writes its rows one by one."""

    traits = LawTraits()

    def step(self, now: LawInput, memory: Array, /) -> Array:
        del memory
        return np.asarray(60.0 * (now.ref[0] - now.meas[0]) - 1.0 * now.meas[1])


def test_a_law_in_python_has_a_past_too() -> None:
    cell, _ = runnable()
    beside = Cell("c", dict(cell.stations), signals=cell.signals)
    alone = Cell("c", {"left": cell.stations["left"]}, signals=cell.signals)
    code = compiled(alone, "mov joints(2, 60, -150, 0, -60, 0)", "wait 0.1 s")
    options = RunOptions(record_hz=100, laws={"left": Proportional()})
    one, other = (run(made, {"left": code}, options) for made in (alone, beside))
    np.testing.assert_array_equal(one.channels["left/q"].values, other.channels["left/q"].values)


def test_the_past_is_exact_at_ticks_and_linear_between_them() -> None:
    past = Past(0, np.array([1.0, 2.0]))
    past.enter(1, np.array([[2.0, 2.0], [4.0, 3.0]]))
    past.enter(3, np.array([[8.0, 4.0]]))
    assert [past.at(k).tolist() for k in (0, 1, 2, 3)] == [[1, 2], [2, 2], [4, 3], [8, 4]]
    assert past.at(2.25).tolist() == [5.0, 3.25]
    assert past.at(9.5).tolist() == [8.0, 4.0]


def test_the_past_keeps_what_may_still_be_asked_for_and_no_more() -> None:
    past = Past(0, np.zeros(1))
    for k in range(100):
        past.enter(1 + 10 * k, np.arange(1.0 + 10 * k, 11.0 + 10 * k)[:, None])
        past.forget(10 * k - 15)
        assert past.at(max(10 * k - 15, 0)).item() == max(10 * k - 15, 0)
        assert len(past._blocks) <= 4


def test_what_carries_parts_is_where_it_was_at_every_tick_that_has_passed() -> None:
    """An arm whose move has been computed to its end is asked by others that have not come so far."""
    cell, _ = runnable()
    slower = replace(cell.stations["left"].controller, rates=Rates(500))
    left = replace(cell.stations["left"], controller=slower)
    at = start_run(replace(cell, stations={**cell.stations, "left": left}), KINEMATIC).stations["left"]
    assert (at.cell_ticks, len(at.hands)) == (2, 1)
    way = np.linspace(0.01, 0.4, 40)[:, None] * np.ones(left.robot.n)
    known = np.vstack([left.q_start, left.q_start + way])
    at.follow(JointReference(known[1:], np.zeros_like(way), np.zeros_like(way)))
    assert at.due == 80
    for due in range(81):
        q = (known[due // 2] + known[(due + 1) // 2]) / 2.0
        (X_WM,) = at.carriers(due).values()
        expected = (left.X_WB @ forward(left.robot, q)).matrix()
        np.testing.assert_allclose(X_WM.matrix(), expected, rtol=0.0, atol=ROUNDING)
