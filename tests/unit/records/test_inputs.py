"""Recorded inputs from files: what they give, and what is said of those that cannot be read."""

import json
import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim.cli.main import main
from ropsim.records import InputsError, RecordingFileError, write_recording
from ropsim.records.inputs import inputs_from_plain, inputs_of, read_inputs, with_inputs
from ropsim.simulation import Fidelity, InputChange, RunOptions
from ropsim.workbench import open_project
from support.live import KEYS, project

INPUTS = (InputChange(2.0, "start", 1.0), InputChange(2.5, "more", 1.0), InputChange(2.6, "level", -0.25))


def written(path: Path, text: str) -> Path:
    path.write_text(text, "utf-8")
    return path


def as_json(inputs: tuple[InputChange, ...]) -> str:
    return json.dumps([{"signal": one.signal, "time": one.time, "value": one.value} for one in inputs])


def test_a_list_in_json_gives_its_inputs(tmp_path: Path) -> None:
    assert read_inputs(written(tmp_path / "keys.json", as_json(INPUTS))) == INPUTS


def test_a_recording_gives_the_inputs_that_its_run_was_given(tmp_path: Path) -> None:
    folder = project(tmp_path, KEYS)
    options = with_inputs(RunOptions(Fidelity.KINEMATIC), INPUTS)
    recording = open_project(folder).simulate(options=options)
    write_recording(recording, tmp_path / "live.npz")
    assert inputs_of(recording) == INPUTS
    assert read_inputs(tmp_path / "live.npz") == INPUTS


def test_the_command_runs_with_them_and_makes_the_same_recording(tmp_path: Path) -> None:
    folder = project(tmp_path, KEYS)
    first, second = tmp_path / "first.npz", tmp_path / "second.npz"
    given_ = written(tmp_path / "keys.json", as_json(INPUTS))
    run = ["run", str(folder), "--kinematic"]
    assert main([*run, "--inputs", str(given_), "--record", str(first)]) == 0
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
        ('[{"signal": 3, "time": 1, "value": 1}]', "`signal`"),
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
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(st.sampled_from(["signal", "time", "value"]), inner, max_size=3)
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
    assert len(inputs) == len(plain)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
def test_a_device_or_a_pipe_is_no_file_of_inputs(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for path in (pipe, Path("/dev/zero")):
        with pytest.raises(InputsError, match="it is no ordinary file"):
            read_inputs(path)
