"""Typed records as plain values and back: the types of their fields are the only rule."""

import json
from dataclasses import dataclass
from enum import Enum

import pytest

from ropsim.records.plain_records import DocumentError, plain_record, record_from


class Colour(Enum):
    RED = "red"
    BLUE = "blue"


@dataclass(frozen=True)
class Inner:
    number: float
    count: int | None = None


@dataclass(frozen=True)
class Outer:
    name: str
    colour: Colour = Colour.RED
    inner: Inner | None = None
    many: tuple[Inner, ...] = ()
    value: bool | int | float = 0
    known: bool = True


@dataclass(frozen=True)
class Odd:
    text: str | bytes


WHOLE = Outer("a", Colour.BLUE, Inner(float("-inf"), 3), (Inner(0.5), Inner(float("inf"), 0)), True, False)


def test_a_record_comes_back_equal_through_strict_json() -> None:
    text = json.dumps(plain_record(WHOLE), allow_nan=False)
    assert record_from(Outer, json.loads(text), "outer") == WHOLE


@pytest.mark.parametrize("value", [True, 1, 1.0, -0.5])
def test_a_value_of_several_types_keeps_its_own(value: float) -> None:
    back = record_from(Outer, json.loads(json.dumps(plain_record(Outer("a", value=value)))), "outer")
    assert (back.value, type(back.value)) == (value, type(value))


def test_what_is_missing_has_its_default_and_what_is_unknown_is_passed_over() -> None:
    assert record_from(Outer, {"name": "a", "newer": [1]}, "outer") == Outer("a")


@pytest.mark.parametrize(
    ("plain", "told"),
    [
        ({}, "`name` of `outer` is missing"),
        ([], "`outer` is a `list`, not a `dict`"),
        ({"name": 3}, "`name` is a `int`, not a `str`"),
        ({"name": "a", "colour": "green"}, "`colour` is `green`, known are `red`, `blue`"),
        ({"name": "a", "inner": {"number": "x"}}, "`number` is not a number"),
        ({"name": "a", "inner": {"number": 10**400}}, "`number` is too large a number"),
        ({"name": "a", "inner": {"number": True}}, "`number` is not a number"),
        ({"name": "a", "inner": {"number": 1, "count": True}}, "`count` is a `bool`, not a `int`"),
        ({"name": "a", "many": {}}, "`many` is a `dict`, not a `list`"),
        ({"name": "a", "many": [None]}, "`many` is a `NoneType`, not a `dict`"),
        ({"name": "a", "value": "on"}, "`value` is not a number"),
        ({"name": "a", "known": 1}, "`known` is a `int`, not a `bool`"),
    ],
)
def test_what_does_not_fit_is_named(plain: object, told: str) -> None:
    with pytest.raises(DocumentError) as caught:
        record_from(Outer, plain, "outer")
    assert str(caught.value) == told


def test_a_type_without_a_plain_form_is_refused() -> None:
    with pytest.raises(TypeError, match="no plain form"):
        plain_record(Odd("a"))
