"""Recorded inputs from files: what they give, and what is said of those that cannot be read."""

import json
import os
from math import inf, nan
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim.cli.testing import main
from ropsim.flow import Interventions, OverrideChange, Recording, RunFacts
from ropsim.records import (
    InputsError,
    RecordingFileError,
    inputs_of,
    inputs_text,
    read_inputs,
    read_recording,
    with_inputs,
    write_recording,
)
from ropsim.records.inputs import LONGEST
from ropsim.records.plain_inputs import inputs_from_plain
from ropsim.simulation import Fidelity, InputChange, RunOptions
from ropsim.workbench import open_project
from support.characters import ANY
from support.live import KEYS, project

INPUTS = (InputChange(2.0, "start", 1.0), InputChange(2.5, "more", 1.0), InputChange(2.6, "level", -0.25))
KEYS_ONLY = Interventions(INPUTS)
ALL = Interventions(INPUTS, (OverrideChange(0.5, 0.25), OverrideChange(2.5, 0.0)), 2.55)


def written(path: Path, text: str) -> Path:
    path.write_text(text, "utf-8")
    return path


def as_json(inputs: tuple[InputChange, ...]) -> str:
    return json.dumps([{"signal": one.signal, "time": one.time, "value": one.value} for one in inputs])


def test_a_list_in_json_gives_its_inputs(tmp_path: Path) -> None:
    assert read_inputs(written(tmp_path / "keys.json", as_json(INPUTS))) == KEYS_ONLY


def test_a_list_may_hold_overrides_and_one_stop(tmp_path: Path) -> None:
    text = """[
      {"time": 2.5, "override": 0},
      {"signal": "start", "time": 0.5, "value": true},
      {"stop": true, "time": 9},
      {"override": 1.0, "time": 3.25}
    ]"""
    assert read_inputs(written(tmp_path / "keys.json", text)) == Interventions(
        (InputChange(0.5, "start", 1.0),), (OverrideChange(2.5, 0.0), OverrideChange(3.25, 1.0)), 9.0
    )


def test_what_was_given_is_written_in_order_of_time_and_comes_back(tmp_path: Path) -> None:
    text = inputs_text(ALL)
    entries = json.loads(text)
    assert [entry["time"] for entry in entries] == [0.5, 2.0, 2.5, 2.5, 2.55, 2.6]
    assert len(text.splitlines()) == len(entries) + 2
    (tmp_path / "keys.json").write_bytes(text)
    assert read_inputs(tmp_path / "keys.json") == ALL
    assert inputs_text(Interventions()) == b"[]\n"


TIMES = st.floats(0.0, 1e6)
GIVEN = st.builds(
    Interventions,
    st.lists(st.builds(InputChange, TIMES, st.text(ANY), st.floats(-1e9, 1e9))).map(sorted).map(tuple),
    st.lists(st.builds(OverrideChange, TIMES, st.floats(0.0, 1.0))).map(sorted).map(tuple),
    st.none() | TIMES,
)


@given(given_=GIVEN)
def test_whatever_was_given_comes_back(given_: Interventions) -> None:
    read = inputs_from_plain(json.loads(inputs_text(given_)), "a test")
    assert read.overrides == given_.overrides
    assert read.stopped == given_.stopped
    assert tuple(sorted(read.inputs)) == given_.inputs


def test_a_recording_tells_all_that_was_done_to_its_run(tmp_path: Path) -> None:
    facts = RunFacts(inputs=ALL.inputs, overrides=ALL.overrides, stopped=ALL.stopped)
    write_recording(Recording(np.zeros(0), {}, (), (), 0.0, facts), tmp_path / "live.npz")
    assert read_inputs(tmp_path / "live.npz") == ALL


@pytest.mark.parametrize(
    ("facts", "reason"),
    [
        (RunFacts(inputs=(InputChange(nan, "go", 1.0),)), "entry 1 of the inputs`: `time` must be"),
        (
            RunFacts(overrides=(OverrideChange(1.0, 1.0), OverrideChange(inf, 1.0))),
            "entry 2 of the overrides",
        ),
        (RunFacts(overrides=(OverrideChange(1.0, 1.5),)), "from 0 to 1, found 1.5"),
        (RunFacts(overrides=(OverrideChange(1.0, nan),)), "from 0 to 1, found nan"),
        (RunFacts(stopped=nan), "`stopped` must be a finite number"),
    ],
)
def test_times_and_values_of_a_recording_that_are_none_are_told(facts: RunFacts, reason: str) -> None:
    with pytest.raises(InputsError, match=reason) as caught:
        inputs_of(Recording(np.zeros(0), {}, (), (), 0.0, facts))
    assert caught.value.diagnostic.code == "X878"


def test_a_run_is_given_all_and_the_time_that_it_needs() -> None:
    options = with_inputs(RunOptions(longest=100.0, longest_wait=10.0), ALL)
    assert (options.inputs, options.overrides, options.stopped) == (INPUTS, ALL.overrides, 2.55)
    held = Interventions((), (OverrideChange(50.0, 0.1),), 70.0)
    slow = with_inputs(RunOptions(longest=100.0, longest_wait=10.0), held)
    assert (slow.longest, slow.longest_wait) == (1070.0, 170.0)


def test_of_two_overrides_at_one_time_the_one_that_stands_last_sets_the_time_of_a_run() -> None:
    both = (OverrideChange(50.0, 1.0), OverrideChange(50.0, 0.1), OverrideChange(20.0, 0.5))
    assert with_inputs(RunOptions(longest=100.0), Interventions((), both)).longest == 1050.0


def test_a_recording_gives_the_inputs_that_its_run_was_given(tmp_path: Path) -> None:
    folder = project(tmp_path, KEYS)
    options = with_inputs(RunOptions(Fidelity.KINEMATIC), KEYS_ONLY)
    recording = open_project(folder).simulate(options=options)
    write_recording(recording, tmp_path / "live.npz")
    assert inputs_of(recording) == KEYS_ONLY
    assert read_inputs(tmp_path / "live.npz") == KEYS_ONLY


def test_the_command_runs_with_them_and_makes_the_same_recording(tmp_path: Path) -> None:
    folder = project(tmp_path, KEYS)
    first, second = tmp_path / "first.npz", tmp_path / "second.npz"
    given_ = written(tmp_path / "keys.json", as_json(INPUTS))
    run = ["run", str(folder), "--kinematic"]
    assert main([*run, "--inputs", str(given_), "--record", str(first)]) == 0
    assert main([*run, "--inputs", str(first), "--record", str(second)]) == 0
    assert first.read_bytes() == second.read_bytes()


def test_the_command_follows_the_override_and_ends_where_the_inputs_say(tmp_path: Path) -> None:
    folder = project(tmp_path, KEYS)
    given_ = Interventions(INPUTS, (OverrideChange(0.5, 0.25), OverrideChange(1.5, 0.0)), 2.75)
    (tmp_path / "keys.json").write_bytes(inputs_text(given_))
    first, second = tmp_path / "first.npz", tmp_path / "second.npz"
    run = ["run", str(folder), "--kinematic"]
    assert main([*run, "--inputs", str(tmp_path / "keys.json"), "--record", str(first)]) == 0
    recording = read_recording(first)
    assert recording.facts.interventions == given_
    assert recording.duration == pytest.approx(2.75, abs=0.01)
    assert main([*run, "--inputs", str(first), "--record", str(second)]) == 0
    assert first.read_bytes() == second.read_bytes()


def test_the_command_does_not_write_over_the_inputs(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = project(tmp_path, KEYS)
    given_ = written(tmp_path / "keys.json", as_json(INPUTS))
    assert main(["run", str(folder), "--inputs", str(given_), "--record", str(given_)]) == 2
    assert "would replace the recorded inputs" in capsys.readouterr().err
    assert given_.read_text("utf-8") == as_json(INPUTS)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "no JSON"),
        ("[" * 100_000, "no JSON"),
        ("{}", "found a `dict`"),
        ("[1]", "entry 1"),
        ('[{"signal": "go", "value": 1}]', "`time` must be a number"),
        ('[{"signal": "go", "time": "1", "value": 1}]', "`time` must be a number"),
        ('[{"signal": "go", "time": 1, "value": 1e999}]', "finite"),
        ('[{"signal": "go", "time": 1e308, "value": 1}]', "`time` is 1e+308 s, at most 1e+06 s"),
        ('[{"signal": 3, "time": 1, "value": 1}]', "`signal`"),
        ('[{"time": 1, "value": 1}]', "`signal`"),
        ('[{"override": 0.5}]', "`time` must be a number"),
        ('[{"override": "0.5", "time": 1}]', "`override` must be a number"),
        ('[{"override": true, "time": 1}]', "`override` must be a number"),
        ('[{"override": 30, "time": 1}]', "an override is a number from 0 to 1, found 30"),
        ('[{"override": -0.1, "time": 1}]', "an override is a number from 0 to 1, found -0.1"),
        ('[{"override": NaN, "time": 1}]', "`override` must be a finite number"),
        ('[{"override": 0.5, "time": 1, "signal": "go"}]', "it has `signal` and `override`"),
        ('[{"stop": true}]', "`time` must be a number"),
        ('[{"stop": false, "time": 1}]', "`stop` must be `true`"),
        ('[{"stop": 1, "time": 1}]', "`stop` must be `true`"),
        ('[{"stop": true, "time": 1}, {"stop": true, "time": 2}]', "a run ends once"),
    ],
)
def test_what_is_no_list_of_inputs_is_told(tmp_path: Path, text: str, reason: str) -> None:
    with pytest.raises(InputsError) as caught:
        read_inputs(written(tmp_path / "keys.json", text))
    assert caught.value.diagnostic.code == "X878"
    assert reason in caught.value.diagnostic.message


def test_missing_and_foreign_files_are_told(tmp_path: Path) -> None:
    with pytest.raises(InputsError, match="no such file"):
        read_inputs(tmp_path / "no.json")
    (tmp_path / "bytes.json").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputsError, match="no UTF-8"):
        read_inputs(tmp_path / "bytes.json")
    with pytest.raises(RecordingFileError):
        read_inputs(written(tmp_path / "x.npz", "x"))


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(ANY, max_size=5),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(st.sampled_from(["signal", "time", "value", "override", "stop"]), inner, max_size=3)
    ),
    max_leaves=12,
)


@given(plain=JSON)
def test_no_plain_value_does_harm(plain: object) -> None:
    try:
        inputs = inputs_from_plain(plain, "a test")
    except InputsError:
        return
    assert isinstance(plain, list)
    assert len(inputs.inputs) + len(inputs.overrides) + (inputs.stopped is not None) == len(plain)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
def test_a_device_or_a_pipe_is_no_file_of_inputs(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for path in (pipe, Path("/dev/zero")):
        with pytest.raises(InputsError, match="it is no ordinary file"):
            read_inputs(path)


def test_a_late_input_makes_no_endless_run() -> None:
    late = Interventions((InputChange(1e6, "go", 1.0),))
    assert with_inputs(RunOptions(), late).longest == LONGEST == 4 * 3600.0
