import json
from dataclasses import dataclass

import numpy as np
import pytest

from ropsim.records import readable
from ropsim.records.plain_values import NotPlainError, tagged, untagged
from ropsim.views import summarize
from support.recordings import empty_recording, pick_and_place, two_findings


@dataclass(frozen=True)
class Record:
    size: float
    parts: tuple[int, ...]

    @property
    def twice(self) -> float:
        return 2.0 * self.size

    @property
    def itself(self) -> "Record":
        return self


def test_records_become_mappings_with_their_single_valued_properties() -> None:
    assert readable(Record(float("inf"), (1,))) == {"size": "Infinity", "parts": [1], "twice": "Infinity"}


def test_summaries_are_strict_json() -> None:
    for recording in (empty_recording(), pick_and_place(1, findings=two_findings())):
        document = json.loads(json.dumps(readable(summarize(recording)), allow_nan=False))
        assert document["cycle_time"] == summarize(recording).cycle_time
        assert document["cycle_time_valid"] is True


@pytest.mark.parametrize(
    "value", [float("inf"), float("-inf"), [1, float("inf")], {"a": {"b": float("-inf")}}]
)
def test_numbers_that_are_not_finite_come_back(value: object) -> None:
    assert untagged(json.loads(json.dumps(tagged(value), allow_nan=False))) == value


def test_nan_comes_back() -> None:
    back = untagged(tagged(float("nan")))
    assert isinstance(back, float)
    assert np.isnan(back)


@pytest.mark.parametrize("value", [object(), {1: 2}, b"x", {"a": [np.array([object()])]}, 1j])
def test_what_no_file_can_keep_is_refused(value: object) -> None:
    with pytest.raises(NotPlainError):
        tagged(value)


def test_endless_nesting_is_refused() -> None:
    loop: list[object] = []
    loop.append(loop)
    with pytest.raises(NotPlainError):
        tagged(loop)
