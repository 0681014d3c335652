"""What somebody did to a run, given to another run: that one does the same, bit by bit."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import ropsim
from ropsim import icr, robots
from ropsim.flow import AwaitEvent, MoveEvent, OutputEvent, OverrideChange, Recording, WaitEvent
from ropsim.model import Cell, Rates, Signal, Station, Tool
from ropsim.records import inputs_of, with_inputs
from ropsim.simulation import Fidelity, NobodyWatches, OptionError, RunOptions, RunView, run
from ropsim.spatial import Pose
from ropsim.workbench import environment_of
from support.examples import examples

ARM = robots.load("puma560")
CONTROLLER = robots.default_controller("puma560")
SIGNALS = {
    "go": Signal("go", is_input=True, changes=((0.7, 1.0),)),
    "key": Signal("key", is_input=True),
    "level": Signal("level", is_input=True, analog=True),
    "ready": Signal("ready", is_input=False),
    "lamp": Signal("lamp", is_input=False),
}
FIRST = (
    "mov (500, -200, 300)",
    "lin (500, 0, 300) blend 30 mm",
    "lin (500, 0, 100) blend 30 mm",
    "lin (500, 200, 100) at 20 before end do set lamp on",
    "set ready on",
    "wait 0.3 s",
    "lin (500, 200, 300) speed 40 until key",
    "set lamp off",
    "mov home",
)
SECOND = (
    "wait until go",
    "mov joints (10, 60, -150, 0, -60, 0)",
    "wait until ready",
    "if key then",
    "  mov joints (0, 50, -150, 0, -60, 0)",
    "endif",
    "wait until not key timeout 0.2 s",
    "mov joints (0, 60, -150, 0, -60, 0)",
)


def _cell() -> Cell:
    """Return a cell with two arms, whose controllers have rates of their own."""
    slow = replace(CONTROLLER, rates=Rates(500, 4, CONTROLLER.rates.plant_steps))
    stations = (
        Station("a", ARM, CONTROLLER, Pose(), {"": Tool("")}, "", ARM.home, "a"),
        Station("b", ARM, slow, Pose(np.array([2.0, 0.0, 0.0])), {"": Tool("")}, "", ARM.home, "b"),
    )
    return replace(Cell("c", {one.name: one for one in stations}), signals=SIGNALS)


CELL = _cell()


def code(name: str, lines: Sequence[str]) -> icr.Program:
    text = "\n".join((f"program {name}", "units mm, deg, s", *lines, ""))
    compiled = ropsim.language.compile(text, environment_of(CELL, CELL.stations[name]), name)
    assert compiled.icr is not None, [str(one) for one in compiled.diagnostics]
    return compiled.icr


BOTH = {"a": code("a", FIRST), "b": code("b", SECOND)}
STOP = "stop"
Act = float | str | tuple[str, float]


@dataclass
class Hand(NobodyWatches):
    """Does something when a run has come to given times [s].

    Attributes:
        acts: times with an override, a signal with its value, or `STOP`.
        done: how many of them have been done.
        looked: last tick at which a program has looked at a channel.
        ticks: those at which overrides and the end were to act, with that of the run then.
    """

    acts: Sequence[tuple[float, Act]]
    done: int = 0
    looked: int = -1
    ticks: list[tuple[int, int]] = field(default_factory=list)

    @property
    def may_press(self) -> bool:
        """Return True."""
        return True

    def advanced(self, run: RunView) -> None:
        """Act where the time has come."""
        while self.done < len(self.acts) and run.time >= self.acts[self.done][0]:
            act = self.acts[self.done][1]
            self.done += 1
            match act:
                case float():
                    self.ticks.append((run.set_override(act), run.tick))
                case (signal, value):
                    run.press(signal, max(run.tick, self.looked) + 1 + self.done, value)
                case _:
                    self.ticks.append((run.stop(), run.tick))

    def reading(self, run: RunView) -> None:
        """Notice it."""
        self.looked = run.tick


def played(acts: Sequence[tuple[float, Act]], options: RunOptions, cell: Cell = CELL) -> Recording:
    codes = {name: BOTH[name] for name in cell.stations}
    return run(cell, codes, replace(options, watch=Hand(acts)))


def again(recording: Recording, options: RunOptions, cell: Cell = CELL) -> Recording:
    codes = {name: BOTH[name] for name in cell.stations}
    return run(cell, codes, with_inputs(options, inputs_of(recording)))


IDEAL = RunOptions(Fidelity.KINEMATIC)
ACTS: st.SearchStrategy[Act] = st.one_of(
    st.sampled_from([0.0, 0.1, 0.5, 1.0]),
    st.floats(0.05, 1.0),
    st.tuples(st.just("key"), st.sampled_from([0.0, 1.0])),
    st.tuples(st.just("level"), st.floats(-1.0, 1.0)),
)


@pytest.mark.slow
@settings(max_examples=examples(8), deadline=None, derandomize=True)
@given(
    acts=st.lists(st.tuples(st.floats(0.0, 6.0), ACTS), max_size=6),
    stop=st.one_of(st.none(), st.floats(0.0, 8.0)),
)
def test_whatever_was_done_to_a_run_makes_the_same_recording_again(
    acts: list[tuple[float, Act]], stop: float | None
) -> None:
    ends: list[tuple[float, Act]] = [(7.0, 1.0)] if stop is None else [(stop, STOP)]
    done = sorted([*acts, *ends], key=lambda one: one[0])
    first = played(done, IDEAL)
    assert first == again(first, IDEAL)


@pytest.mark.parametrize("stop", [0.2, 0.9, 1.7, 2.9, 3.3])
def test_the_same_holds_with_drives_for_overrides_holds_and_the_end(stop: float) -> None:
    acts: list[tuple[float, Act]] = [(0.5, 0.3), (1.1, 0.0), (1.5, 0.8), (stop, STOP)]
    first = played(sorted(acts, key=lambda one: one[0]), RunOptions())
    assert first.facts.stopped is not None
    assert first == again(first, RunOptions())


def test_the_recording_tells_what_was_done_at_the_ticks_at_which_it_acted() -> None:
    hand = Hand([(0.5, 0.25), (1.0, 0.0), (1.4, STOP)])
    recording = run(CELL, BOTH, replace(IDEAL, watch=hand))
    ticks = [tick for tick, _ in hand.ticks]
    facts = recording.facts
    assert facts.overrides == (OverrideChange(ticks[0] / 1000, 0.25), OverrideChange(ticks[1] / 1000, 0.0))
    assert facts.stopped == ticks[2] / 1000


def test_all_that_is_done_acts_within_an_interpolation_tick_of_the_slower_controller() -> None:
    hand = Hand([(0.1 * k, 0.3 + 0.02 * k) for k in range(25)])
    run(CELL, BOTH, replace(IDEAL, watch=hand))
    longest = max(one.controller.rates.interpolation_period for one in CELL.stations.values())
    assert len(hand.ticks) == 25
    assert max(acts - now for acts, now in hand.ticks) <= longest * 1000 + 1


def test_a_held_program_begins_nothing_until_it_goes_on() -> None:
    held = played([(0.1, 0.0), (2.0, 1.0)], IDEAL)
    for event in held.events_of(MoveEvent) + held.events_of(OutputEvent) + held.events_of(WaitEvent):
        assert not 0.1 < event.time < 2.0
    waits = [event for event in held.events_of(AwaitEvent) if event.channel == "go"]
    assert [(event.time, event.came) for event in waits] == [(0.0, True)]
    (move, *_) = [event for event in held.events_of(MoveEvent) if event.station == "b"]
    assert move.time == pytest.approx(2.0, abs=0.01)


def test_a_run_that_is_stopped_while_it_waits_for_a_key_waits_until_then_again() -> None:
    lone = replace(CELL, stations={"b": CELL.stations["b"]})
    first = played([(3.0, STOP)], IDEAL, lone)
    assert [one.code for one in first.findings] == ["S761"]
    assert first.duration == pytest.approx(3.0, abs=0.01)
    assert again(first, IDEAL, lone) == first


LOOP = ("repeat 3", "  mov (500, -200, 300)", "  mov (500, 200, 300) blend 20 mm", "  mov home", "endr")


def test_the_end_by_hand_is_told_at_its_own_time_and_pass_and_at_the_move_that_it_cut_short() -> None:
    lone = replace(CELL, stations={"a": CELL.stations["a"]})
    programs = {"a": code("a", LOOP)}
    moves = run(lone, programs, IDEAL).events_of(MoveEvent)
    cut = next(one for one in moves if (one.line, one.visit) == (5, 2))  # the second move of its stretch
    stop = cut.time + 0.2 * cut.duration
    ended = run(lone, programs, replace(IDEAL, watch=Hand([(stop, STOP)])))
    (finding,) = ended.findings
    assert finding.span
    assert finding.span.line == 5
    assert (finding.data["pass"], finding.label) == (2, "pass 2")
    told = finding.data["time_s"]
    assert isinstance(told, float)
    assert ended.facts.stopped == pytest.approx(stop, abs=0.02)
    assert stop <= told == pytest.approx(ended.duration)  # the arm brakes before it stands


def test_what_would_act_after_the_end_is_not_part_of_the_run() -> None:
    given_ = replace(IDEAL, overrides=(OverrideChange(1000.0, 0.5),), stopped=2000.0)
    recording = run(CELL, BOTH, given_)
    assert recording.facts.interventions == run(CELL, BOTH, IDEAL).facts.interventions
    assert "override" not in recording.channels


@pytest.mark.parametrize(
    "options",
    [
        RunOptions(overrides=(OverrideChange(1.0, 1.5),)),
        RunOptions(overrides=(OverrideChange(float("nan"), 0.5),)),
        RunOptions(overrides=(OverrideChange(-1.0, 0.5),)),
        RunOptions(stopped=float("inf")),
    ],
)
def test_what_nobody_can_have_done_is_refused(options: RunOptions) -> None:
    with pytest.raises(OptionError) as caught:
        run(CELL, BOTH, options)
    assert caught.value.diagnostic.code == "S703"
