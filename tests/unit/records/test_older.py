"""Recordings of older formats: a run as ropsim wrote it in version 2 is read with typed facts and events."""

from pathlib import Path

import numpy as np
import pytest

from ropsim.core import Category
from ropsim.flow import (
    AxisType,
    ChannelGroup,
    Fidelity,
    GripEvent,
    InputChange,
    InputEvent,
    MessageEvent,
    MotionKind,
    MoveEvent,
    Origin,
    OutputEvent,
    Recording,
    ReleaseEvent,
    SkipEvent,
    TaskEvent,
    WaitEvent,
)
from ropsim.records import RecordingFileError, npz, read_recording, recording_bytes
from ropsim.views import event_text, summarize
from support.older_recordings import KEPT, version_2


def file_of(path: Path, **changes: object) -> Path:
    """Write the run in its old format, with some entries of the document changed."""
    path.write_bytes(version_2(**changes))
    return path


@pytest.fixture
def old(tmp_path: Path) -> Recording:
    return read_recording(file_of(tmp_path / "old.npz"))


def test_its_events_are_typed_and_tell_what_they_told(old: Recording) -> None:
    assert [type(event) for event in old.events] == [
        MessageEvent,
        MoveEvent,
        GripEvent,
        TaskEvent,
        OutputEvent,
        WaitEvent,
        ReleaseEvent,
        SkipEvent,
        InputEvent,
    ]
    assert [event_text(event) for event in old.events] == [
        event["text"].replace("= True", "= on") for event in KEPT["document"]["events"]
    ]
    (move,), (wait,) = old.events_of(MoveEvent), old.events_of(WaitEvent)
    assert (move.motion, move.ordinal, move.line, move.station) == (MotionKind.PTP, 0, 4, "robot")
    assert wait.origin == Origin(wait.span, 1, ("main", "Carry"), (0, 0))
    assert (wait.time, wait.duration, wait.pause) == (0.2, 0.5, 0.5)
    assert old.events_of(OutputEvent)[0].value is True
    assert old.events_of(TaskEvent)[0] == TaskEvent(0.0, 0.7, "robot", name="Carry", serial=1, depth=1)


def test_its_facts_are_typed(old: Recording) -> None:
    facts, (station,) = old.facts, old.facts.stations
    assert (facts.project, facts.fidelity, facts.record_hz) == ("first_cell", Fidelity.KINEMATIC, 4.0)
    assert facts.inputs == (InputChange(1.0, "start", 1.0),)
    assert (station.program, station.source, station.robot) == ("p", "programs/main.task", "puma560")
    assert (station.control_hz, station.skipped_moves, len(station.axes)) == (1000.0, 1, 6)
    assert station.axes[0].type is AxisType.REVOLUTE
    assert station.axes[0].max_effort == 97.6
    assert "motor constants" in station.estimated


def test_what_held_its_value_has_the_same_values_at_the_rows(old: Recording) -> None:
    names = [name for name in KEPT["arrays"] if name.startswith("channel/")]
    assert len(names) == 6
    for name in names:
        channel = old.channels[name.removeprefix("channel/")]
        assert channel.held
        assert channel.rows(old.time).tolist() == KEPT["arrays"][name], name
    assert old.channels["signal.lamp"].group is ChannelGroup.SIGNALS
    assert (old.channels["line"].subject, old.channels["signal.lamp"].subject) == ("robot", "")


def test_written_again_it_is_of_the_present_format_and_equal(old: Recording, tmp_path: Path) -> None:
    (tmp_path / "new.npz").write_bytes(recording_bytes(old))
    assert read_recording(tmp_path / "new.npz") == old


def test_its_summary_counts_what_happened(old: Recording) -> None:
    summary = summarize(old)
    assert (dict(summary.moves), len(summary.skipped)) == ({"PTP": 1}, 1)
    assert (summary.grips, summary.empty_grips, summary.releases) == (0, 1, 1)
    assert not summary.cycle_time_valid


def test_the_first_format_is_read_and_says_that_it_does_not_know_where_parts_were(
    old: Recording, tmp_path: Path
) -> None:
    first = read_recording(file_of(tmp_path / "first.npz", version=1, placements=None))
    assert first.placements == ()
    assert [found.code for found in first.findings] == [*(found.code for found in old.findings), "X879"]
    assert first.events == old.events


def test_a_finding_without_a_category_has_that_of_its_kind(tmp_path: Path) -> None:
    finding = KEPT["document"]["findings"][0]
    findings = [{**finding, "code": code} for code in ("S761", "S723", "I464", "S751", "S703", "Q000")]
    read = read_recording(file_of(tmp_path / "ended.npz", findings=findings))
    assert [found.category for found in read.findings[: len(findings)]] == [
        Category.STOPPED,
        Category.UNFINISHED,
        Category.UNFINISHED,
        Category.COLLISION,
        Category.OTHER,
        Category.OTHER,
    ]


@pytest.mark.parametrize(
    "change",
    [
        {"header": []},
        {"header": {"fidelity": 3}},
        {"events": [{"kind": "move", "time": 0.0, "duration": 1.0, "data": {"visit": 1, "kind": "SPLINE"}}]},
        {
            "events": [
                {"kind": "output", "time": 0.0, "text": "lamp", "data": {"visit": 1, "channel": "lamp"}}
            ]
        },
        {"events": [{"kind": "output", "time": 0.0, "text": "a = " + "(" * 200, "data": {"channel": "a"}}]},
        {"events": [3]},
        {"channels": {"q": 3}},
    ],
)
def test_an_odd_document_is_told(tmp_path: Path, change: dict[str, object]) -> None:
    with pytest.raises(RecordingFileError) as caught:
        read_recording(file_of(tmp_path / "odd.npz", **change))
    assert caught.value.diagnostic.code == "X874"


def test_a_channel_with_columns_where_one_was_held_stays_in_rows(tmp_path: Path) -> None:
    channels = KEPT["document"]["channels"]
    wide = channels | {"line": channels["q"]}
    arrays = npz.unpack(version_2(channels=wide))
    arrays["channel/line"] = np.zeros((len(KEPT["arrays"]["time"]), 6))
    (tmp_path / "wide.npz").write_bytes(npz.pack(arrays))
    assert not read_recording(tmp_path / "wide.npz").channels["line"].held
