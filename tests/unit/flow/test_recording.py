import sys
from dataclasses import replace

import numpy as np
import pytest

from ropsim.core import Diagnostic, Severity, Span
from ropsim.flow import (
    ROBOT,
    Channel,
    GripEvent,
    MotionKind,
    MoveEvent,
    Recording,
    RunFacts,
    SkipEvent,
    StationFacts,
)


def test_a_recording_becomes_a_table_with_one_column_per_joint() -> None:
    time = np.array([0.0, 0.004])
    channels = {
        "q": Channel(np.array([[1.0, 2.0], [3.0, 4.0]]), "rad", ("1", "2")),
        "line": Channel(np.array([0.0, 7.0]), "", times=np.array([0.0, 0.001])),
    }
    table = Recording(time, channels, (), (), 0.004).to_pandas()
    assert list(table.columns) == ["q[1]", "q[2]", "line"]
    assert table["line"].tolist() == [0.0, 7.0]
    assert table.index.name == "time"
    assert table["q[2]"].tolist() == [2.0, 4.0]
    assert table.index.tolist() == [0.0, 0.004]


def test_a_table_without_pandas_names_the_extra_that_brings_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match=r"pip install 'ropsim\[pandas\]'"):
        Recording(np.zeros(1), {}, (), (), 0.0).to_pandas()


def run_of(*findings: Diagnostic, skips: int = 0) -> Recording:
    """Return a run of two moves, with findings and skipped moves."""
    events = [
        MoveEvent(0.0, motion=MotionKind.PTP, ordinal=0),
        MoveEvent(1.0, motion=MotionKind.LIN, ordinal=1),
        *[SkipEvent(1.5, motion=MotionKind.LIN)] * skips,
    ]
    q = Channel(np.zeros((1000, 6)), "rad")
    return Recording(np.linspace(0.0, 2.0, 1000), {"q": q}, tuple(events), findings, 2.0)


ERROR = Diagnostic("M501", "out-of-reach", Severity.ERROR, "2.104 m away", Span("main.task", 4, 1, 4, 9))
WARNING = Diagnostic("S731", "current-exceeded", Severity.WARNING, "5 A of 4 A")


def test_a_run_is_ok_without_errors_whatever_it_warns_of() -> None:
    assert run_of().ok
    assert run_of(WARNING).ok
    assert not run_of(WARNING, ERROR).ok


def test_a_run_with_a_skipped_move_is_not_ok() -> None:
    assert not run_of(skips=1).ok


def test_a_good_run_is_one_quiet_line() -> None:
    assert repr(run_of()) == "<Recording ok: 2 moves, 2.00 s, no findings>"
    assert repr(run_of(WARNING)) == "<Recording ok: 2 moves, 2.00 s, 1 warning>"


def test_a_printed_run_that_failed_shouts_and_names_its_first_error() -> None:
    text = str(run_of(WARNING, ERROR, replace(ERROR, code="M502"), skips=2))
    assert text.startswith(
        "<Recording FAILED: 2 moves, 2 SKIPPED, 2.00 s, 2 errors, 1 warning; first error: "
    )
    assert "main.task:4:1" in text
    assert "M501" in text
    assert "2.104 m away" in text


def test_a_printed_run_is_one_line_without_arrays_and_control_characters() -> None:
    text = repr(run_of(replace(ERROR, message="a\nb\x1b[2J")))
    assert text.isprintable()
    assert "array" not in text
    assert len(text) < 300


def held(times: list[float], values: list[float]) -> Channel:
    return Channel(np.array(values), "", times=np.array(times))


def test_a_change_is_in_force_from_the_row_after_it() -> None:
    channel = held([0.0, 0.002, 0.004], [1.0, 2.0, 3.0])
    assert channel.rows(np.array([0.0, 0.002, 0.003, 0.004, 0.008])).tolist() == [1.0, 1.0, 2.0, 2.0, 3.0]


def test_a_channel_is_read_at_any_time_held_or_linear_between_rows() -> None:
    time = np.array([0.0, 0.004])
    q = Channel(np.array([[1.0, 2.0], [3.0, 4.0]]), "rad", ("1", "2"))
    recording = Recording(time, {"q": q, "line": held([0.0, 0.001], [4.0, 7.0])}, (), (), 0.004)
    assert recording.at("q", 0.002).tolist() == [2.0, 3.0]
    assert recording.at("q", 9.0).tolist() == [3.0, 4.0]
    assert [float(recording.at("line", time)) for time in (0.001, 0.0011)] == [4.0, 7.0]


def test_recordings_of_equal_content_are_equal() -> None:
    assert run_of(WARNING) == run_of(WARNING)
    assert run_of(WARNING) != run_of(ERROR)


def test_events_of_one_kind_are_given_with_their_own_fields() -> None:
    assert [move.motion for move in run_of().events_of(MoveEvent)] == [MotionKind.PTP, MotionKind.LIN]
    assert run_of().events_of(GripEvent) == ()


def test_channels_have_the_name_of_their_station_before_the_quantity_where_it_has_one() -> None:
    facts = RunFacts(stations=(StationFacts(ROBOT), StationFacts("right")))
    assert facts.channel("q", ROBOT) == "q"
    assert facts.channel("q", "right") == "right/q"
