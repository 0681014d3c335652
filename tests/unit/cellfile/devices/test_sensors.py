"""Sensors of a cell file: what measures an input, and mistakes."""

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.model import DistanceSensor, ForceSensor, Sensor

HEAD = '[robot]\nmodel = "puma560"\n\n[signals.s]\n'


def sensor_of(keys: str) -> Sensor | None:
    cell, findings = read_cell(SourceText("cell.toml", HEAD + keys), "c")
    assert cell is not None, [str(found) for found in findings]
    return cell.signals["s"].sensor


def code_of(keys: str) -> str:
    cell, findings = read_cell(SourceText("cell.toml", HEAD + keys), "c")
    assert cell is None
    (found,) = findings
    return found.code


def test_sensors_have_their_numbers_in_si_units() -> None:
    distance = 'input = 1\nanalog = true\nsensor = { kind = "distance", range = 300, behind = 20 }'
    assert sensor_of(distance) == DistanceSensor("", 0.3, 0.02)
    force = 'input = 1\nsensor = { kind = "force", stiffness = 50, travel = 4, station = "robot" }'
    assert sensor_of(force) == ForceSensor("robot", 50e3, 0.004)


def test_what_is_not_said_has_a_default() -> None:
    assert sensor_of('input = 1\nsensor = { kind = "distance" }') == DistanceSensor("", 0.2)
    assert sensor_of('input = 1\nsensor = { kind = "force" }') == ForceSensor("", 2e4, 0.01)
    assert sensor_of("input = 1") is None


@pytest.mark.parametrize(
    ("keys", "code"),
    [
        ("input = 1\nsensor = { range = 3 }", "X803"),
        ('input = 1\nsensor = { kind = "colour" }', "X808"),
        ('input = 1\nsensor = { kind = "distance", reach = 3 }', "X802"),
        ('input = 1\nsensor = { kind = "distance", range = -3 }', "X806"),
        ('input = 1\nsensor = { kind = "distance", station = "left" }', "X809"),
        ('input = 1\nsensor = { kind = "distance" }\nchanges = [[1, 1]]', "X812"),
        ('output = 1\nsensor = { kind = "distance" }', "X812"),
    ],
)
def test_a_sensor_that_cannot_be_is_told(keys: str, code: str) -> None:
    assert code_of(keys) == code
