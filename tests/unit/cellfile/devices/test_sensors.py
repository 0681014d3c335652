"""Sensors of a cell file: what measures an input, and mistakes."""

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.model import (
    DistanceSensor,
    ForceSensor,
    ForceTorqueSensor,
    Sensor,
    SensorErrors,
    WrenchAxis,
    WrenchFrame,
)

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


def test_errors_have_their_numbers_in_si_units() -> None:
    given = "range = 200, bits = 12, noise = 0.3, rate = 500, delay = 0.004"
    force = f'input = 1\nanalog = true\nsensor = {{ kind = "force torque", axis = "z", {given} }}'
    errors = SensorErrors(400.0 / 2**12, 0.3, 0.002, 0.004, 200.0)
    assert sensor_of(force) == ForceTorqueSensor("", WrenchAxis.Z, errors=errors)
    distance = 'input = 1\nanalog = true\nsensor = { kind = "distance", behind = 56, bits = 8, noise = 0.1 }'
    assert sensor_of(distance) == DistanceSensor("", 0.2, 0.056, SensorErrors(0.256 / 2**8, 1e-4))


def test_a_force_torque_sensor_has_axis_and_frame() -> None:
    keys = 'axis = "rx", frame = "interface", compensated = false'
    found = sensor_of(f'input = 1\nanalog = true\nsensor = {{ kind = "force torque", {keys} }}')
    assert found == ForceTorqueSensor("", WrenchAxis.RX, WrenchFrame.INTERFACE, compensated=False)
    assert (found.measures, found.unit) == ("torque", "Nm")


@pytest.mark.parametrize(
    ("keys", "code", "told"),
    [
        ('axis = "w"', "X808", "allowed are `x`, `y`, `z`, `rx`, `ry`, `rz`"),
        ('axis = "z", frame = "world"', "X808", "allowed are `tool`, `interface`"),
        ('axis = "z", rate = 1200', "X806", "allowed is 1 to 1000 Hz"),
        ('axis = "z", noise = -1', "X806", "allowed is 0 to 1e+09 N"),
        ('axis = "z", delay = 3', "X806", "allowed is 0 to 1 s"),
        ('axis = "z", bits = 12', "X803", "needs `range`"),
        ('axis = "z", range = 0', "X806", "allowed is 1e-06"),
        ('frame = "tool"', "X803", "needs `axis`"),
    ],
)
def test_errors_that_cannot_be_are_told(keys: str, code: str, told: str) -> None:
    text = f'{HEAD}input = 1\nanalog = true\nsensor = {{ kind = "force torque", {keys} }}'
    cell, (found,) = read_cell(SourceText("cell.toml", text), "c")
    assert cell is None
    assert found.code == code
    assert told in found.message


@pytest.mark.parametrize(
    "sensor", ['kind = "force torque", axis = "z"', 'kind = "force", noise = 2, stiffness = 20']
)
def test_a_switch_has_no_force_and_no_noise(sensor: str) -> None:
    assert code_of(f"input = 1\nsensor = {{ {sensor} }}") == "X812"


@pytest.mark.parametrize(("keys", "codes"), [("", ["X929"]), (", compensated = false", [])])
def test_a_sensor_of_contacts_in_a_cell_without_any_is_told(keys: str, codes: list[str]) -> None:
    text = f'{HEAD}input = 1\nanalog = true\nsensor = {{ kind = "force torque", axis = "z"{keys} }}'
    cell, findings = read_cell(SourceText("cell.toml", text), "c")
    assert cell is not None
    assert [one.code for one in findings] == codes


@pytest.mark.parametrize(("rate", "told"), [("400", "500 Hz"), ("700", "1000 Hz"), ("999", "1000 Hz")])
def test_a_rate_that_is_rounded_is_told_with_the_one_in_force(rate: str, told: str) -> None:
    keys = f'input = 1\nanalog = true\nsensor = {{ kind = "distance", rate = {rate} }}'
    cell, findings = read_cell(SourceText("cell.toml", HEAD + keys), "c")
    assert cell is not None
    found = [one.message for one in findings if one.code == "X933"]
    assert [f"the run has {told}" in one for one in found] == [True]


@pytest.mark.parametrize("rate", ["500", "333.333", "333.3", "1000", "20"])
def test_a_rate_at_whole_control_ticks_is_not_told(rate: str) -> None:
    keys = f'input = 1\nsensor = {{ kind = "distance", rate = {rate} }}'
    assert not read_cell(SourceText("cell.toml", HEAD + keys), "c")[1]


def test_a_rounded_rate_of_a_joint_sensor_is_told_too() -> None:
    text = '[robot]\nmodel = "puma560"\n\n[controller.sensors]\ncoordinate = { rate = %d }\n'
    for rate, codes in ((400, ["X933"]), (500, [])):
        cell, findings = read_cell(SourceText("cell.toml", text % rate), "c")
        assert cell is not None
        assert [one.code for one in findings] == codes
