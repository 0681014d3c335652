import io
import json
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from ropsim.core import Diagnostic, Label, Severity, TextEdit
from ropsim.flow import EVENTS as KINDS
from ropsim.flow import (
    AwaitEvent,
    Channel,
    Destinations,
    Event,
    GripEvent,
    InputChange,
    InputEvent,
    MessageEvent,
    MotionKind,
    MoveEvent,
    Origin,
    OutputEvent,
    OverrideChange,
    Placement,
    Recording,
    ReleaseEvent,
    SkipEvent,
    TaskEvent,
    WaitEvent,
)
from ropsim.records import RecordingFileError, npz, read_recording, readable, recording_bytes, write_recording
from ropsim.records.diagnostic_json import diagnostic_entry
from ropsim.spatial import Pose
from ropsim.views import html_report, summarize
from support.recordings import SOURCE, empty_recording, facts, pick_and_place, two_findings

PLACEMENTS = (
    Placement(0.0, "box", "", Pose(np.array([0.1, 0.2, 0.3]))),
    Placement(
        0.1 + 0.2, "box", "tool:jaws", Pose(np.array([0.0, 0.0, 1 / 3]), np.array([0.8, 0.6, 0.0, 0.0]))
    ),
    Placement(1.5, "box", "", Pose(), visible=False),
)

HERE = Origin(SOURCE.span(3), 2, ("main", "pick"), (0, 4))
WHEN = (0.1 + 0.2, 1 / 3, "robot", HERE)
EVENTS: tuple[Event, ...] = (
    MoveEvent(
        *WHEN, motion=MotionKind.LIN, ordinal=7, travel=1 / 7, settle=1e-3, zone=0.05, path_error_max=3e-5
    ),
    MoveEvent(*WHEN, motion=MotionKind.PTP, ordinal=8),
    SkipEvent(*WHEN, motion=MotionKind.PTP),
    WaitEvent(*WHEN, pause=float("inf")),
    AwaitEvent(*WHEN, channel="ready", value=False, came=True),
    *(OutputEvent(*WHEN, channel="lamp", value=value) for value in (True, 1, 1.0, float("-inf"))),
    MessageEvent(*WHEN, text="lone surrogate \ud800, \0 and ünïcode"),
    GripEvent(*WHEN, part="box"),
    ReleaseEvent(*WHEN),
    TaskEvent(0.5, 1.0, "robot", name="pick", serial=4, depth=1),
    InputEvent(0.5, signal="start", value=1.0),
)


def sample() -> Recording:
    """A recording with every kind of entry, numbers that are not finite included."""
    finding = Diagnostic(
        "M502",
        "joint-out-of-range",
        Severity.WARNING,
        "lone surrogate \ud800 and ünïcode",
        SOURCE.span(3),
        "label",
        (Label(SOURCE.span(4), "second"),),
        ("a note",),
        "a hint",
        TextEdit(SOURCE.span(5), "better"),
        {"limit_rad": float("inf"), "list": [1, None, True, {"deep": -0.5}]},
    )
    about = facts(
        checked=("collisions",),
        inputs=(InputChange(0.5, "start", 1.0),),
        overrides=(OverrideChange(0.25, 0.5), OverrideChange(0.75, 0.0)),
        stopped=1.0,
        parts_left=("box",),
        destinations=Destinations(2, 1),
    )
    recording = pick_and_place(1, 20.0, (*two_findings(), finding))
    return replace(recording, events=(*recording.events, *EVENTS), facts=about, placements=PLACEMENTS)


def code_of(path: Path) -> str:
    with pytest.raises(RecordingFileError) as caught:
        read_recording(path)
    return caught.value.diagnostic.code


def changed(header: dict[str, object]) -> bytes:
    """The sample's file with some entries of its JSON header replaced."""
    arrays = npz.unpack(recording_bytes(sample()))
    plain = json.loads(arrays["header"].tobytes()) | header
    arrays["header"] = np.frombuffer(json.dumps(plain).encode(), np.uint8)
    return npz.pack(arrays)


def test_recording_comes_back_equal(tmp_path: Path) -> None:
    write_recording(sample(), tmp_path / "run.npz")
    assert read_recording(tmp_path / "run.npz") == sample()


def test_empty_recording_comes_back_equal(tmp_path: Path) -> None:
    write_recording(empty_recording(), tmp_path / "run.npz")
    assert read_recording(tmp_path / "run.npz") == empty_recording()


def test_time_that_is_not_finite_comes_back(tmp_path: Path) -> None:
    write_recording(replace(sample(), duration=float("inf")), tmp_path / "run.npz")
    assert read_recording(tmp_path / "run.npz").duration == float("inf")


def test_every_kind_of_event_is_among_those_that_come_back() -> None:
    assert {type(event) for event in EVENTS} == set(KINDS.values())


def test_values_of_outputs_come_back_as_what_they_were(tmp_path: Path) -> None:
    write_recording(sample(), tmp_path / "run.npz")
    values = [event.value for event in read_recording(tmp_path / "run.npz").events_of(OutputEvent)]
    assert [type(value) for value in values] == [bool, int, float, float]


def test_what_was_read_is_seen_as_what_was_written(tmp_path: Path) -> None:
    write_recording(sample(), tmp_path / "run.npz")
    pages = [html_report(one, summarize(one), {}) for one in (sample(), read_recording(tmp_path / "run.npz"))]
    assert pages[0] == pages[1]


def test_equal_recordings_are_equal_files() -> None:
    assert recording_bytes(sample()) == recording_bytes(sample())


def test_numpy_reads_the_file_as_documented(tmp_path: Path) -> None:
    write_recording(sample(), tmp_path / "run.npz")
    with np.load(tmp_path / "run.npz") as archive:
        header = json.loads(archive["header"].tobytes())
        assert header["format"] == "ropsim-recording"
        assert header["channels"]["q"]["unit"] == "rad"
        assert header["channels"]["line"]["held"] is True
        assert replace(sample().channels["line"], times=archive["times/line"]) == sample().channels["line"]
        assert np.array_equal(archive["channel/q"], sample().channels["q"].values)
        assert archive["time"].shape == sample().time.shape


def test_header_is_strict_json() -> None:
    header = npz.unpack(recording_bytes(sample()))["header"].tobytes().decode("ascii")

    def refuse(word: str) -> float:
        raise AssertionError(f"`{word}` is no JSON")

    json.loads(header, parse_constant=refuse)


def test_failed_write_leaves_the_old_file(tmp_path: Path) -> None:
    write_recording(sample(), tmp_path / "run.npz")
    odd = replace(sample().findings[0], data={"robot": object()})
    with pytest.raises(RecordingFileError) as caught:
        write_recording(replace(sample(), findings=(odd,)), tmp_path / "run.npz")
    assert caught.value.diagnostic.code == "X876"
    assert "['robot']" in str(caught.value)
    assert read_recording(tmp_path / "run.npz") == sample()
    assert [path.name for path in tmp_path.iterdir()] == ["run.npz"]


def test_channel_names_with_control_characters_are_refused() -> None:
    bad = replace(sample(), channels={"a\x00b": Channel(sample().time, "")})
    with pytest.raises(RecordingFileError) as caught:
        recording_bytes(bad)
    assert caught.value.diagnostic.code == "X876"


def test_place_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(RecordingFileError) as caught:
        write_recording(sample(), tmp_path / "file" / "run.npz")
    assert caught.value.diagnostic.code == "X877"


def test_missing_file_is_told(tmp_path: Path) -> None:
    assert code_of(tmp_path / "none.npz") == "X870"
    assert code_of(tmp_path) == "X870"


@pytest.mark.parametrize("content", [b"", b"hello", b"PK\x03\x04" + b"\x00" * 100, b"\x00" * 10_000])
def test_foreign_files_are_told(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "run.npz").write_bytes(content)
    assert code_of(tmp_path / "run.npz") == "X871"


def test_archive_of_another_program_is_told(tmp_path: Path) -> None:
    np.savez(tmp_path / "run.npz", a=np.arange(3.0))
    assert code_of(tmp_path / "run.npz") == "X871"


def test_pickles_are_never_loaded(tmp_path: Path) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pickle.loads", lambda *_: pytest.fail("unpickled"))
        patch.setattr("pickle.load", lambda *_: pytest.fail("unpickled"))
        np.savez(tmp_path / "run.npz", header=np.array([{"a": 1}], dtype=object))
        assert code_of(tmp_path / "run.npz") == "X872"


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9, 0.999])
def test_truncated_file_is_told(tmp_path: Path, share: float) -> None:
    content = recording_bytes(sample())
    (tmp_path / "run.npz").write_bytes(content[: int(len(content) * share)])
    assert code_of(tmp_path / "run.npz") == "X871"


def test_array_that_announces_more_than_it_has_is_told(tmp_path: Path) -> None:
    content = io.BytesIO()
    np.lib.format.write_array_header_1_0(
        content, {"descr": "<f8", "fortran_order": False, "shape": (1 << 40, 1 << 10)}
    )
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        archive.writestr("header.npy", content.getvalue())
    (tmp_path / "run.npz").write_bytes(stream.getvalue())
    assert code_of(tmp_path / "run.npz") == "X872"


def test_archive_that_announces_more_than_the_limit_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_recording(sample(), tmp_path / "run.npz")
    monkeypatch.setattr("ropsim.records.npz.LIMIT", 10_000)
    assert code_of(tmp_path / "run.npz") == "X875"


def test_a_format_that_is_not_known_is_told_with_its_version_and_writer(tmp_path: Path) -> None:
    (tmp_path / "run.npz").write_bytes(changed({"version": 5, "facts": {"ropsim": "9.1"}}))
    with pytest.raises(RecordingFileError) as caught:
        read_recording(tmp_path / "run.npz")
    assert caught.value.diagnostic.code == "X873"
    assert "format version 5, written by ropsim 9.1; this ropsim reads 1, 2, 3 and 4" in str(caught.value)


def test_a_recording_of_the_version_before_overrides_is_read_as_it_is(tmp_path: Path) -> None:
    facts = json.loads(npz.unpack(recording_bytes(sample()))["header"].tobytes())["facts"]
    facts = {key: value for key, value in facts.items() if key not in {"overrides", "stopped"}}
    (tmp_path / "run.npz").write_bytes(changed({"version": 3, "facts": facts}))
    found, now = read_recording(tmp_path / "run.npz"), sample()
    assert found == replace(now, facts=replace(now.facts, overrides=(), stopped=None))


CHANNEL = {"unit": "", "columns": [], "description": "", "group": "joints", "subject": "", "held": False}


@pytest.mark.parametrize(
    "header",
    [
        {"placements": None},
        {"placements": [{"time": 0, "body": "a", "parent": "", "visible": True}]},
        {"placements": [{"time": 0, "body": "a", "parent": "", "pose": [0, 0, 0], "visible": True}]},
        {"placements": [{"time": 0, "body": "a", "parent": "", "pose": [0] * 7, "visible": True}]},
        {"placements": [{"time": 0, "body": "a", "parent": 1, "pose": [0, 0, 0, 1, 0, 0, 0], "visible": 1}]},
        {"events": 3},
        {"events": [{"time": "x"}]},
        {"findings": [{"severity": "fatal"}]},
        {"findings": [{**diagnostic_entry(two_findings()[0], readable), "category": "worst"}]},
        {"events": [{"kind": "jump", "time": 0.0}]},
        {"events": [{"kind": ["move"], "time": 0.0}]},
        {"events": [{"kind": "wait", "time": 0.0}]},
        {"events": [{"kind": "skip", "time": 0.0, "motion": 3}]},
        {"events": [{"kind": "wait", "time": 0.0, "pause": 1, "origin": {"span": {"line": 1}}}]},
        {"channels": {"absent": CHANNEL}},
        {"channels": {"q": CHANNEL | {"columns": ["one"]}}},
        {"channels": {"q": CHANNEL | {"unit": 1}}},
        {"channels": {"q": CHANNEL | {"group": "others"}}},
        {"channels": {"q": CHANNEL | {"held": True}}},
        {"channels": {"line": CHANNEL}},
        {"duration": None},
        {"duration": 10**400},
        {"facts": []},
        {"facts": {"fidelity": "perfect"}},
        {"facts": {"fidelity": True}},
        {"facts": {"stations": [{"axes": []}]}},
        {"facts": {"stations": [{"name": "robot", "axes": [{"name": "1", "lower": "low"}]}]}},
        {"facts": {"inputs": [{"signal": "start", "time": 1.0}]}},
        {"facts": {"overrides": [{"time": 1.0}]}},
        {"facts": {"overrides": [{"time": 1.0, "value": True}]}},
        {"facts": {"stopped": "soon"}},
    ],
)
def test_inconsistent_header_is_told(tmp_path: Path, header: dict[str, object]) -> None:
    (tmp_path / "run.npz").write_bytes(changed(header))
    assert code_of(tmp_path / "run.npz") == "X874"


def test_changes_that_are_not_in_order_of_time_are_told(tmp_path: Path) -> None:
    arrays = npz.unpack(recording_bytes(sample()))
    arrays["times/line"] = arrays["times/line"][::-1]
    (tmp_path / "run.npz").write_bytes(npz.pack(arrays))
    assert code_of(tmp_path / "run.npz") == "X874"
