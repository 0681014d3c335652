"""Records are compared by content; equal ones have equal fingerprints, in every process."""

import copy
import gc
import math
import pickle
import subprocess
import sys
from dataclasses import FrozenInstanceError, dataclass, fields, is_dataclass, replace
from enum import Enum, StrEnum
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim.robots import default_controller, load
from ropsim.spatial import Array, Pose, fingerprint, frozen, record
from ropsim.workbench import open_project

EXAMPLES = Path(__file__).parents[3] / "examples"
NUMBERS = st.floats(width=64)


class Side(Enum):
    LEFT = 1
    RIGHT = 2


class Way(StrEnum):
    SHORT = "short"
    LONG = "long"


@record
class Point:
    name: str
    place: Array
    side: Side = Side.LEFT


@record
class Pair:
    first: Point
    second: Point


@dataclass(frozen=True, slots=True)
class Plain:
    number: float


def point(*numbers: float, name: str = "p") -> Point:
    return Point(name, frozen(numbers))


def test_records_of_equal_content_are_equal_and_found_in_mappings() -> None:
    assert point(1.0, 2.0) == point(1.0, 2.0)
    assert {point(1.0): "here"}[point(1.0)] == "here"
    assert Pair(point(1.0), point(2.0)) == Pair(point(1.0), point(2.0))
    assert Pair(point(1.0), point(2.0)) != Pair(point(2.0), point(1.0))


@pytest.mark.parametrize(
    "other",
    [
        point(1.0, 3.0),
        point(1.0),
        point(1.0, 2.0, name="q"),
        Point("p", frozen([1.0, 2.0]), Side.RIGHT),
        Point("p", frozen([[1.0, 2.0]])),
        "p",
    ],
)
def test_any_other_content_is_another_value(other: object) -> None:
    assert point(1.0, 2.0) != other
    assert fingerprint(point(1.0, 2.0)) != fingerprint(other)


def test_a_record_cannot_be_changed() -> None:
    one: Any = point(1.0)
    with pytest.raises(FrozenInstanceError):
        one.name = "q"


@given(st.lists(NUMBERS, max_size=5), st.lists(NUMBERS, max_size=5))
def test_equal_numbers_have_equal_fingerprints_and_only_these(a: list[float], b: list[float]) -> None:
    same = len(a) == len(b) and all(
        x == y or (math.isnan(x) and math.isnan(y)) for x, y in zip(a, b, strict=True)
    )
    assert (fingerprint(point(*a)) == fingerprint(point(*b))) is same
    assert (fingerprint(tuple(a)) == fingerprint(tuple(b))) is same
    assert (point(*a) == point(*b)) is same


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (1, 1.0),
        (1, True),
        (None, 0),
        ("1", 1),
        ("ab", b"ab"),
        (("ab", "c"), ("a", "bc")),
        ((1, (2,)), ((1, 2),)),
        ([], ()),
        ({"a": 1}, {"a": 2}),
        ({"a": {"b": 1}}, {"b": {"a": 1}}),
        (Side.LEFT, Side.RIGHT),
        (Plain(1.0), Plain(2.0)),
        (np.zeros(2), np.zeros(2, dtype=np.float32)),
        (np.zeros(2), np.zeros((2, 1))),
    ],
)
def test_values_that_look_alike_have_different_fingerprints(one: object, other: object) -> None:
    assert fingerprint(one) != fingerprint(other)


def test_a_member_of_a_text_enum_is_its_text() -> None:
    assert fingerprint((Way.SHORT, 1)) == fingerprint(("short", 1))
    assert fingerprint(Way.SHORT) != fingerprint(Way.LONG)


def test_the_order_of_sets_and_mappings_does_not_count() -> None:
    assert fingerprint({"a": 1, "b": 2}) == fingerprint(MappingProxyType({"b": 2, "a": 1}))
    assert fingerprint({"a", "b", "c"}) == fingerprint(frozenset("cba"))


@pytest.mark.parametrize("what", [len, object(), np.array(["a"]), (1, [print])])
def test_what_is_no_value_has_no_fingerprint(what: object) -> None:
    with pytest.raises(TypeError, match="no value"):
        fingerprint(what)


def test_a_fingerprint_is_not_kept_while_an_array_can_be_written_to() -> None:
    loose = Point("p", np.array([1.0, 2.0]))
    before = fingerprint(loose)
    loose.place[0] = 5.0
    assert fingerprint(loose) != before


def test_the_fingerprint_of_a_record_that_is_gone_is_not_another_ones() -> None:
    seen = set()
    for k in range(2000):  # new objects take the places of old ones
        seen.add(fingerprint(point(float(k))))
        gc.collect(0)
    assert len(seen) == 2000


def test_arrays_are_read_only_after_pickling_and_copying() -> None:
    robot = load("puma560")
    for again in (pickle.loads(pickle.dumps(robot)), copy.deepcopy(robot)):
        assert again == robot
        assert again is not robot
        assert arrays(again)
        assert not any(array.flags.writeable for array in arrays(again))


@pytest.mark.slow
def test_equal_texts_give_equal_cells_in_every_process() -> None:
    script = (
        "import sys; from ropsim.spatial import fingerprint; from ropsim.workbench import open_project;"
        "print(fingerprint(open_project(sys.argv[1]).cell))"
    )
    for name in ("palletizing", "operator"):
        here = open_project(EXAMPLES / name).cell
        assert here == open_project(EXAMPLES / name).cell
        done = subprocess.run(
            [sys.executable, "-c", script, str(EXAMPLES / name)], capture_output=True, text=True, check=True
        )
        assert done.stdout.strip() == fingerprint(here)


def test_any_changed_number_of_a_robot_or_controller_changes_its_fingerprint() -> None:
    for value in (load("puma560"), default_controller("puma560")):
        prints = [fingerprint(value), *(fingerprint(one) for one in changed(value))]
        assert len(prints) > 40
        assert len(set(prints)) == len(prints)


def test_poses_keep_their_own_equality_and_agree_with_fingerprints() -> None:
    assert Pose(np.array([0.0, 1.0, 2.0])) == Pose(np.array([-0.0, 1.0, 2.0]))
    assert fingerprint(Pose(np.array([0.0, 1.0, 2.0]))) == fingerprint(Pose(np.array([-0.0, 1.0, 2.0])))


def arrays(value: object) -> list[Array]:
    """Return all arrays within records and tuples."""
    if isinstance(value, np.ndarray):
        return [value]
    if isinstance(value, tuple):
        return [array for one in value for array in arrays(one)]
    if is_dataclass(value) and not isinstance(value, type):
        return [array for one in fields(value) for array in arrays(getattr(value, one.name))]
    return []


def changed(value: object) -> list[object]:
    """Return copies of a record, each with one number that is farther from zero, or the next one."""
    if isinstance(value, bool | str | Enum | Pose) or value is None:
        return []
    if isinstance(value, int | float):
        return (
            []
            if math.isinf(value)
            else [value - 1 if isinstance(value, float) and value < 0.0 else value + 1]
        )
    if isinstance(value, np.ndarray):
        found: list[object] = []
        for k in range(value.size):
            other = value.copy()
            other.flat[k] = np.nextafter(other.flat[k], np.inf)
            found.append(frozen(other))
        return found
    if isinstance(value, tuple):
        return [(*value[:k], other, *value[k + 1 :]) for k, one in enumerate(value) for other in changed(one)]
    assert is_dataclass(value)
    assert not isinstance(value, type)
    return [
        replace(value, **{one.name: other})
        for one in fields(value)
        if one.init
        for other in changed(getattr(value, one.name))
    ]
