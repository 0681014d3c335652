"""Keys of values: two share one only where they are the same."""

from dataclasses import dataclass
from enum import Enum, StrEnum

import numpy as np
import pytest

from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin
from ropsim.spatial import Pose, bits_of, bits_without


class Colour(Enum):
    RED = "red"


class Word(StrEnum):
    RED = "red"


@dataclass(frozen=True)
class One:
    value: object


@dataclass(frozen=True)
class Other:
    value: object


DIFFERENT = (
    None,
    True,
    1,
    1.0,
    2,
    "1",
    b"1",
    (),
    (1,),
    ((1,),),
    (1, 2),
    {"a": 1},
    {"a": 2},
    Colour.RED,
    "blue",
    One(1),
    One(1.0),
    Other(1),
    One(One(1)),
    np.array([1.0, 2.0]),
    np.array([[1.0, 2.0]]),
    np.array([1, 2]),
    np.array([0.0]),
    np.array([-0.0]),
    Pose(),
    Pose(np.array([1.0, 0.0, 0.0])),
)


def test_different_values_have_different_keys() -> None:
    keys = [bits_of(value) for value in DIFFERENT]
    assert len(set(keys)) == len(DIFFERENT)


def test_equal_values_have_one_key() -> None:
    move = MoveInstruction(MotionKind.LIN, Pose(np.array([0.1, 0.2, 0.3])), ModalState(zone=0.02))
    again = MoveInstruction(MotionKind.LIN, Pose(np.array([0.1, 0.2, 0.3])), ModalState(zone=0.02))
    assert bits_of(move) == bits_of(again)
    assert hash(bits_of(move)) == hash(bits_of(again))
    assert bits_of([1, "a"]) == bits_of((1, "a"))
    assert bits_of(Word.RED) == bits_of("red")


def test_every_field_of_a_move_but_those_left_out_counts() -> None:
    key = bits_without(MoveInstruction, "origin")
    move = MoveInstruction(MotionKind.LIN, None, ModalState())
    moved = MoveInstruction(MotionKind.LIN, None, ModalState(), Origin(visit=2))
    slower = MoveInstruction(MotionKind.LIN, None, ModalState(path_speed=0.1))
    assert key(move) == key(moved) != key(slower)
    assert bits_of(move) != bits_of(moved)


@pytest.mark.parametrize("value", [len, object(), {1, 2}, lambda: None])
def test_what_is_no_value_has_no_key(value: object) -> None:
    with pytest.raises(TypeError, match="no key"):
        bits_of(value)
