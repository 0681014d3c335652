import io
import json
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from ropsim.core import Diagnostic, Label, Severity, TextEdit
from ropsim.flow import Channel, Event, Placement, Recording
from ropsim.records import RecordingFileError, npz, read_recording, recording_bytes, write_recording
from ropsim.spatial import Pose
from support.recordings import SOURCE, empty_recording, pick_and_place, two_findings

PLACEMENTS = (
    Placement(0.0, "box", "", Pose(np.array([0.1, 0.2, 0.3]))),
    Placement(
        0.1 + 0.2, "box", "tool:jaws", Pose(np.array([0.0, 0.0, 1 / 3]), np.array([0.8, 0.6, 0.0, 0.0]))
    ),
    Placement(1.5, "box", "", Pose(), visible=False),
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
    event = Event(0.5, "output", "lamp", None, 0.0, {"value": True, "level": float("-inf")})
    recording = pick_and_place(1, 20.0, (*two_findings(), finding))
    return replace(recording, events=(*recording.events, event), placements=PLACEMENTS)


def assert_equal(one: Recording, other: Recording) -> None:
    assert np.array_equal(one.time, other.time)
    assert list(one.channels) == list(other.channels)
    for name, channel in one.channels.items():
        read_channel = other.channels[name]
        assert np.array_equal(channel.values, read_channel.values, equal_nan=True)
        assert (channel.unit, channel.columns, channel.description) == (
            read_channel.unit,
            read_channel.columns,
            read_channel.description,
        )
    assert one.events == other.events
    assert one.findings == other.findings
    assert [finding.data for finding in one.findings] == [finding.data for finding in other.findings]
    assert (one.duration, one.header) == (other.duration, other.header)
    assert one.placements == other.placements


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
    assert_equal(sample(), read_recording(tmp_path / "run.npz"))


def test_empty_recording_comes_back_equal(tmp_path: Path) -> None:
    write_recording(empty_recording(), tmp_path / "run.npz")
    assert_equal(empty_recording(), read_recording(tmp_path / "run.npz"))


def test_time_that_is_not_finite_comes_back(tmp_path: Path) -> None:
    write_recording(replace(sample(), duration=float("inf")), tmp_path / "run.npz")
    assert read_recording(tmp_path / "run.npz").duration == float("inf")


def test_sequences_and_arrays_in_the_header_come_back_as_lists(tmp_path: Path) -> None:
    header = {"tuple": (1, (2.5, None)), "array": np.array([[1.0], [2.0]]), "number": np.int64(7)}
    write_recording(replace(sample(), header=header), tmp_path / "run.npz")
    assert read_recording(tmp_path / "run.npz").header == {
        "tuple": [1, [2.5, None]],
        "array": [[1.0], [2.0]],
        "number": 7,
    }


def test_equal_recordings_are_equal_files() -> None:
    assert recording_bytes(sample()) == recording_bytes(sample())


def test_numpy_reads_the_file_as_documented(tmp_path: Path) -> None:
    write_recording(sample(), tmp_path / "run.npz")
    with np.load(tmp_path / "run.npz") as archive:
        header = json.loads(archive["header"].tobytes())
        assert header["format"] == "ropsim-recording"
        assert header["channels"]["q"]["unit"] == "rad"
        assert np.array_equal(archive["channel/q"], sample().channels["q"].values)
        assert archive["time"].shape == sample().time.shape


def test_header_is_strict_json() -> None:
    header = npz.unpack(recording_bytes(sample()))["header"].tobytes().decode("ascii")

    def refuse(word: str) -> float:
        raise AssertionError(f"`{word}` is no JSON")

    json.loads(header, parse_constant=refuse)


def test_failed_write_leaves_the_old_file(tmp_path: Path) -> None:
    write_recording(sample(), tmp_path / "run.npz")
    with pytest.raises(RecordingFileError) as caught:
        write_recording(replace(sample(), header={"robot": object()}), tmp_path / "run.npz")
    assert caught.value.diagnostic.code == "X876"
    assert "header['robot']" in str(caught.value) or "['robot']" in str(caught.value)
    assert_equal(sample(), read_recording(tmp_path / "run.npz"))
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


def test_newer_format_is_told(tmp_path: Path) -> None:
    (tmp_path / "run.npz").write_bytes(changed({"version": 3}))
    assert code_of(tmp_path / "run.npz") == "X873"


def test_the_first_format_is_read_and_says_that_it_does_not_know_where_parts_were(tmp_path: Path) -> None:
    arrays = npz.unpack(changed({"version": 1}))
    plain = json.loads(arrays["header"].tobytes())
    del plain["placements"]
    arrays["header"] = np.frombuffer(json.dumps(plain).encode(), np.uint8)
    (tmp_path / "run.npz").write_bytes(npz.pack(arrays))
    old = read_recording(tmp_path / "run.npz")
    assert old.placements == ()
    assert [found.code for found in old.findings[len(sample().findings) :]] == ["X879"]
    assert_equal(replace(sample(), placements=()), replace(old, findings=old.findings[:-1]))


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
        {"channels": {"absent": {"unit": "", "columns": [], "description": ""}}},
        {"channels": {"q": {"unit": "", "columns": ["one"], "description": ""}}},
        {"channels": {"q": {"unit": 1, "columns": [], "description": ""}}},
        {"duration": None},
        {"duration": 10**400},
        {"header": []},
    ],
)
def test_inconsistent_header_is_told(tmp_path: Path, header: dict[str, object]) -> None:
    (tmp_path / "run.npz").write_bytes(changed(header))
    assert code_of(tmp_path / "run.npz") == "X874"
