"""The law of live runs: whatever was done to one and when, a run that is given it records the same."""

from dataclasses import dataclass, replace
from typing import Literal

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.flow import Recording
from ropsim.records import inputs_of, with_inputs
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.studio.testing import LiveControl, LiveOverride, LivePace, LiveSpeed, Order, PacedClock, SetSignal
from ropsim.workbench import Project, open_overlaid
from support.examples import examples
from support.live import KEYS, FakeLine, project

TICK, SLICE = 1e-3, 4e-3
"""Control tick and interpolation tick of the controller [s]."""


@dataclass(frozen=True)
class Played:
    """A live run and what its line has heard."""

    recording: Recording
    line: FakeLine


@pytest.fixture(scope="module")
def keys(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return open_overlaid(project(tmp_path_factory.mktemp("keys"), KEYS), {})


def play(opened: Project, line: FakeLine, speed: float, options: RunOptions) -> Played:
    cell, codes = opened.runnable(opened.programs())
    clock = PacedClock(line.now, speed)
    pace = LivePace("main", codes, clock, line, line.now, line.now)
    return Played(run(cell, codes, replace(options, watch=pace)), line)


def again(opened: Project, recording: Recording, options: RunOptions) -> Recording:
    cell, codes = opened.runnable(opened.programs())
    return run(cell, codes, with_inputs(options, inputs_of(recording)))


ORDERS: st.SearchStrategy[Order] = st.one_of(
    st.builds(SetSignal, st.sampled_from(["start", "more"]), st.sampled_from([0.0, 1.0])),
    st.builds(SetSignal, st.just("level"), st.floats(-5.0, 5.0)),
    st.builds(LiveSpeed, st.floats(0.1, 8.0)),
    st.builds(LiveOverride, st.sampled_from([0.0, 0.3, 1.0])),
    st.builds(LiveControl, st.sampled_from(["hold", "continue", "step"])),
)


@pytest.mark.slow
@settings(max_examples=examples(10), deadline=None, derandomize=True)
@given(
    plan=st.lists(st.tuples(st.floats(0.0, 2.0), ORDERS), max_size=12),
    speed=st.floats(0.1, 8.0),
    work=st.sampled_from([0.0, 1e-5, 1e-4]),
    end=st.sampled_from(["continue", "stop"]),
)
def test_what_was_done_to_a_live_run_gives_the_same_recording_again(
    keys: Project,
    plan: list[tuple[float, Order]],
    speed: float,
    work: float,
    end: Literal["continue", "stop"],
) -> None:
    after: list[tuple[float, Order]] = [
        (2.2, LiveControl(end)),
        (2.2, LiveOverride(1.0)),
        (2.2, LiveSpeed(8.0)),
        (2.3, SetSignal("start", 1.0)),
    ]
    line = FakeLine([*plan, *after], work=work)
    options = RunOptions(Fidelity.KINEMATIC)
    played = play(keys, line, speed, options)
    if end == "continue":
        assert "S761" not in {found.code for found in played.recording.findings}
    assert played.recording == again(keys, played.recording, options)


def test_the_law_holds_for_drives_and_dynamics(keys: Project) -> None:
    plan: list[tuple[float, Order]] = [
        (1.7003, SetSignal("start", 1.0)),
        (2.6501, SetSignal("more", 1.0)),
        (2.7, LiveOverride(0.4)),
        (2.8, LiveControl("hold")),
        (2.9, SetSignal("level", 2.5)),
        (3.0, LiveControl("continue")),
        (3.05, SetSignal("start", 0.0)),
    ]
    played = play(keys, FakeLine(plan, work=2e-4), 1.0, RunOptions())
    done = inputs_of(played.recording)
    assert (len(done.inputs), len(done.overrides)) == (4, 3)
    assert played.recording == again(keys, played.recording, RunOptions())


def test_the_keys_decide_the_way_that_the_program_takes(keys: Project) -> None:
    lines = []
    for pressed in (3.0, 1.6):
        line = FakeLine([(1.5, SetSignal("start", 1.0)), (pressed, SetSignal("more", 1.0))])
        recording = play(keys, line, 1.0, RunOptions(Fidelity.KINEMATIC)).recording
        lines.append([event.span.line for event in recording.events if event.kind == "move" and event.span])
    assert lines == [[3, 7, 11, 7, 9], [3, 7, 9, 7, 9]]


def test_a_change_is_stamped_behind_what_is_computed_and_the_change_before(
    keys: Project,
) -> None:
    line = FakeLine([(1.50037, SetSignal("start", 1.0)), (1.50038, SetSignal("start", 0.0))])
    recording = play(keys, line, 1.0, RunOptions(Fidelity.KINEMATIC, longest=3.0)).recording
    first, second = (one.time for one in inputs_of(recording).inputs)
    assert 1.50037 < first <= 1.50037 + SLICE + TICK
    assert second == pytest.approx(first + TICK, abs=1e-12)
    assert [one["time"] for one in line.messages("stamped")] == [first, second]
