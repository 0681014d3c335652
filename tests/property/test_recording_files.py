"""Recording files: whatever was damaged, there is a diagnostic; whatever was written comes back."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.flow import Channel, Recording
from ropsim.records import RecordingFileError, read_recording, recording_bytes
from ropsim.records.plain_values import tagged, untagged
from support.recordings import pick_and_place, two_findings

CONTENT = recording_bytes(pick_and_place(1, 10.0, two_findings()))
PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
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


@settings(max_examples=300, derandomize=True)
@given(flips=st.lists(st.integers(0, 8 * len(CONTENT) - 1), min_size=1, max_size=6))
def test_flipped_bits_give_a_diagnostic_or_a_recording(place: Path, flips: list[int]) -> None:
    damaged = bytearray(CONTENT)
    for flip in flips:
        damaged[flip // 8] ^= 1 << (flip % 8)
    place.write_bytes(bytes(damaged))
    assert outcome(place) in {"read", "X871", "X872", "X873", "X874", "X875"}


@settings(max_examples=100, derandomize=True)
@given(directory=st.integers(1, 8 * 2500), flips=st.integers(1, 255))
def test_damaged_directory_gives_a_diagnostic_or_a_recording(place: Path, directory: int, flips: int) -> None:
    damaged = bytearray(CONTENT)
    damaged[-1 - directory % 2500] ^= flips
    place.write_bytes(bytes(damaged))
    assert outcome(place) in {"read", "X871", "X872", "X873", "X874", "X875"}


@settings(max_examples=60, derandomize=True)
@given(content=st.binary(max_size=400))
def test_arbitrary_bytes_give_a_diagnostic(place: Path, content: bytes) -> None:
    place.write_bytes(content)
    with pytest.raises(RecordingFileError):
        read_recording(place)


@settings(max_examples=100, derandomize=True)
@given(value=PLAIN)
def test_plain_values_come_back(value: object) -> None:
    assert untagged(tagged(value)) == value


@settings(max_examples=40, derandomize=True)
@given(
    values=st.lists(st.floats(width=64), max_size=20),
    header=st.dictionaries(st.text(), PLAIN, max_size=4),
    unit=st.text(max_size=5),
)
def test_any_channel_and_header_come_back(
    place: Path, values: list[float], header: dict[str, object], unit: str
) -> None:
    time = np.arange(len(values), dtype=np.float64)
    channel = Channel(np.array(values, dtype=np.float64), unit)
    place.write_bytes(recording_bytes(Recording(time, {"x": channel}, (), (), 1.0, header)))
    result = read_recording(place)
    assert result.header == header
    assert result.channels["x"].unit == unit
    assert np.array_equal(result.channels["x"].values, channel.values, equal_nan=True)
