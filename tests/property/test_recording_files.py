"""Recording files: whatever was damaged, there is a diagnostic; whatever was written comes back."""

from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.core import Span
from ropsim.flow import (
    EVENTS,
    AwaitEvent,
    Channel,
    CriticalLimit,
    Event,
    InputChange,
    LimitQuantity,
    MotionKind,
    Origin,
    OutputEvent,
    OverrideChange,
    ReachedSpeed,
    Recording,
    RunFacts,
    SpeedCause,
    StationFacts,
)
from ropsim.records import RecordingFileError, read_recording, recording_bytes
from ropsim.records.plain_values import tagged, untagged
from support.characters import ANY
from support.examples import examples
from support.recordings import pick_and_place, two_findings

CONTENT = recording_bytes(pick_and_place(1, 10.0, two_findings()))
PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(ANY),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(ANY), inner, max_size=4),
    max_leaves=12,
)


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("fuzz") / "run.npz"


def outcome(path: Path) -> str:
    """The code of the diagnostic, or `read` where a whole recording came back."""
    try:
        read_recording(path)
    except RecordingFileError as error:
        return error.diagnostic.code
    return "read"


@settings(max_examples=examples(300), derandomize=True)
@given(flips=st.lists(st.integers(0, 8 * len(CONTENT) - 1), min_size=1, max_size=6))
def test_flipped_bits_give_a_diagnostic_or_a_recording(place: Path, flips: list[int]) -> None:
    damaged = bytearray(CONTENT)
    for flip in flips:
        damaged[flip // 8] ^= 1 << (flip % 8)
    place.write_bytes(bytes(damaged))
    assert outcome(place) in {"read", "X871", "X872", "X873", "X874", "X875"}


@settings(max_examples=examples(100), derandomize=True)
@given(directory=st.integers(1, 8 * 2500), flips=st.integers(1, 255))
def test_damaged_directory_gives_a_diagnostic_or_a_recording(place: Path, directory: int, flips: int) -> None:
    damaged = bytearray(CONTENT)
    damaged[-1 - directory % 2500] ^= flips
    place.write_bytes(bytes(damaged))
    assert outcome(place) in {"read", "X871", "X872", "X873", "X874", "X875"}


@settings(max_examples=examples(60), derandomize=True)
@given(content=st.binary(max_size=400))
def test_arbitrary_bytes_give_a_diagnostic(place: Path, content: bytes) -> None:
    place.write_bytes(content)
    with pytest.raises(RecordingFileError):
        read_recording(place)


@settings(max_examples=examples(100), derandomize=True)
@given(value=PLAIN)
def test_plain_values_come_back(value: object) -> None:
    assert untagged(tagged(value)) == value


TEXTS = st.text(ANY, max_size=8)
NUMBERS = st.floats()
ORIGINS = st.none() | st.builds(
    Origin,
    st.none() | st.builds(Span, TEXTS, *[st.integers(0, 9)] * 4),
    st.integers(1, 99),
    st.lists(TEXTS, max_size=3).map(tuple),
    st.lists(st.integers(0, 99), max_size=3).map(tuple),
)
FIELDS: dict[str, st.SearchStrategy[object]] = {
    "time": NUMBERS,
    "duration": NUMBERS,
    "station": TEXTS,
    "origin": ORIGINS,
    "motion": st.sampled_from(MotionKind) | TEXTS,
    "critical": st.none() | st.builds(CriticalLimit, TEXTS, st.sampled_from(LimitQuantity), NUMBERS),
    "reached": st.none()
    | st.builds(
        ReachedSpeed,
        *[NUMBERS] * 4,
        st.sampled_from(SpeedCause),
        NUMBERS,
        NUMBERS,
        TEXTS,
        st.none() | st.sampled_from(LimitQuantity),
        TEXTS,
    ),
    "looked": st.lists(TEXTS, max_size=2).map(tuple),
    "path_error_max": st.none() | NUMBERS,
    "target": st.lists(NUMBERS, max_size=3).map(tuple),
    "channel": TEXTS,
    "signal": TEXTS,
    "came": st.booleans(),
    "free_orientation": st.booleans(),
    "text": TEXTS,
    "part": TEXTS,
    "name": TEXTS,
    "ordinal": st.integers(),
    "serial": st.integers(),
    "depth": st.integers(),
}


def events() -> st.SearchStrategy[Event]:
    """Return events of all kinds with any fields."""
    values = {OutputEvent: st.booleans() | st.integers() | NUMBERS, AwaitEvent: st.booleans()}
    drawn = {kind: FIELDS | {"value": values.get(kind, NUMBERS)} for kind in EVENTS.values()}
    return st.sampled_from(list(EVENTS.values())).flatmap(
        lambda kind: st.builds(kind, **{one.name: drawn[kind].get(one.name, NUMBERS) for one in fields(kind)})
    )


@settings(max_examples=examples(60), derandomize=True)
@given(
    values=st.lists(NUMBERS, max_size=20),
    changes=st.lists(NUMBERS, min_size=1, max_size=5),
    happened=st.lists(events(), max_size=4),
    about=st.builds(
        RunFacts,
        project=st.text(ANY),
        record_hz=NUMBERS,
        checked=st.lists(st.text(ANY), max_size=2).map(tuple),
        inputs=st.lists(st.builds(InputChange, NUMBERS, TEXTS, NUMBERS), max_size=2).map(tuple),
        overrides=st.lists(st.builds(OverrideChange, NUMBERS, NUMBERS), max_size=2).map(tuple),
        stopped=st.none() | NUMBERS,
        stations=st.lists(st.builds(StationFacts, TEXTS, control_hz=NUMBERS), max_size=2).map(tuple),
    ),
    unit=st.text(ANY, max_size=5),
)
def test_any_channel_event_and_fact_comes_back(
    place: Path, values: list[float], changes: list[float], happened: list[Event], about: RunFacts, unit: str
) -> None:
    time = np.arange(len(values), dtype=np.float64)
    channels = {
        "x": Channel(np.array(values, dtype=np.float64), unit),
        "h": Channel(np.array(changes), unit, times=np.arange(float(len(changes)))),
    }
    written = Recording(time, channels, tuple(happened), (), 1.0, about)
    place.write_bytes(recording_bytes(written))
    assert read_recording(place) == written
