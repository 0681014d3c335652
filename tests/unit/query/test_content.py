"""Whether two values are the same: no reader may be able to tell them apart."""

from dataclasses import dataclass, field
from enum import Enum

import numpy as np
import pytest

from ropsim.query import is_same


class Kind(Enum):
    A = 1
    B = 2


@dataclass(frozen=True)
class Nothing:
    """A record without fields."""


@dataclass(frozen=True)
class One:
    value: object


@dataclass(frozen=True)
class Two:
    value: object
    place: object = field(default=0, compare=False)


@dataclass
class Found:
    """A record that finds something of itself when somebody asks."""

    value: object
    later: object = field(init=False, default=None)


ROW = tuple(range(40))


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (1, True),
        (1, 1.0),
        (0.0, -0.0),
        ("a", b"a"),
        ((1, 2), [1, 2]),
        ((1, 2), (1, 2, 3)),
        ((0.0, *ROW), (-0.0, *ROW)),
        ({"a": 1, "b": 2}, {"b": 2, "a": 1}),
        (np.zeros(2), np.zeros(3)),
        (np.zeros(2), -np.zeros(2)),
        (np.float64(1.0), 1.0),
        (Kind.A, Kind.B),
        (One(1), One(1.0)),
        (One(1), Two(1)),
        (Two("a", place=1), Two("a", place=2)),
        (int, str),
    ],
)
def test_values_that_a_reader_can_tell_apart_are_not_the_same(one: object, other: object) -> None:
    assert not is_same(one, other)
    assert not is_same((one,), (other,))
    assert not is_same((*ROW, one), (*ROW, other))


@pytest.mark.parametrize(
    "value", [float("nan"), -0.0, "text", (), [1], {"a": (1.5,)}, Kind.A, Nothing(), One(1)]
)
def test_equal_values_are_the_same(value: object) -> None:
    copy = {float: lambda: float(str(value)), One: lambda: One(1), Nothing: Nothing}.get(type(value))
    other = copy() if copy is not None else value
    assert is_same(value, other)
    assert is_same((*ROW, One(value)), (*ROW, One(other)))


def test_arrays_are_compared_by_their_numbers() -> None:
    assert is_same(np.arange(3.0), np.arange(3.0))
    assert is_same(Two(np.arange(3), 1), Two(np.arange(3), 1))


def test_what_a_record_finds_of_itself_does_not_tell_it_from_another_one() -> None:
    one, other = Found(1), Found(1)
    one.later = 2
    assert is_same(one, other)
    assert not is_same(one, Found(2))
