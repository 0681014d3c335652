"""Laws and sensors of hydraulic arms in a cell file."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.model import CascadedGains, ControllerKind, ControllerModel, FlowGains, PiGains


def _read(text: str, robot: str = "patu655") -> tuple[ControllerModel | None, tuple[Diagnostic, ...]]:
    cell, findings = read_cell(SourceText("cell.toml", f'[robot]\nmodel = "{robot}"\n{text}'), "")
    return None if cell is None else cell.first.controller, findings


def _controller(text: str) -> ControllerModel:
    controller, findings = _read(f"[controller]\n{text}")
    assert findings == ()
    assert controller is not None
    return controller


@pytest.mark.parametrize(
    ("text", "kind", "gains"),
    [
        ("", ControllerKind.FLOW_LOAD_DAMPING, FlowGains),
        ('law = "parallel PI"', ControllerKind.PARALLEL_PI, PiGains),
        ('law = "fixed gains"', ControllerKind.CASCADED_P_PI, CascadedGains),
        ("kv = [0, 0]", ControllerKind.CASCADED_P_PI, CascadedGains),
        ("kd = [10, 10]", ControllerKind.FLOW_LOAD_DAMPING, FlowGains),
        ("lead = [0.01, 0.01]\nkp = [5, 5]", ControllerKind.FLOW_LOAD_DAMPING, FlowGains),
    ],
)
def test_a_hydraulic_arm_has_the_law_of_its_word_or_of_its_gains(
    text: str, kind: ControllerKind, gains: type
) -> None:
    controller = _controller(text)
    assert controller.kind is kind
    assert isinstance(controller.gains, gains)


def test_stated_gains_take_the_place_of_those_of_the_rule() -> None:
    standard, stated = (
        _controller('law = "parallel PI"'),
        _controller('law = "parallel PI"\nkp = [0.5, 0.25]'),
    )
    assert isinstance(standard.gains, PiGains)
    assert isinstance(stated.gains, PiGains)
    assert stated.gains.kp.tolist() == [0.5, 0.25]
    np.testing.assert_array_equal(stated.gains.ki, standard.gains.ki)
    assert stated.origins[0].source.startswith("kp as in the cell file; the others parallel PI loops")


def test_a_law_that_the_drives_do_not_take_is_refused_with_those_that_they_do() -> None:
    for law, robot in (("computed torque", "patu655"), ("parallel PI", "puma560")):
        _, (found,) = _read(f'[controller]\nlaw = "{law}"\n', robot)
        assert f"`{law}`" in found.message
        assert found.span is not None


def test_sensors_are_said_where_the_recording_says_where_numbers_come_from() -> None:
    controller = _controller(
        "[controller.sensors]\nseed = 4\npressure = { step = 6e3, delay = 0.002, rate = 500 }"
    )
    (sensor,) = controller.sensors.sensors
    assert (sensor.quantity, sensor.delay, sensor.period) == ("pressure", 0.002, 0.002)
    assert controller.sensors.seed == 4
    (origin,) = (one for one in controller.origins if one.parameters == "sensors")
    assert "pressure with steps of 6e+03, every 2 ms, 2 ms late" in origin.source


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("current = { bits = 12, range = 10 }", "`controller.sensors.current` has no meaning"),
        ("pressure = { bits = 12 }", "`range`"),
        ("coordinate = { bits = 60 }", "60"),
        ("coordinate = { noise = -1 }", "-1"),
    ],
)
def test_a_sensor_that_cannot_be_is_found(text: str, told: str) -> None:
    _, (found,) = _read(f"[controller.sensors]\n{text}\n")
    assert told in found.message


def test_angles_are_in_the_units_of_the_file_and_bits_of_a_turn() -> None:
    exact = _controller("[controller.sensors]\ncoordinate = { step = 0.01, noise = 0.02 }").sensors.sensors[0]
    np.testing.assert_allclose(np.degrees(exact.step), 0.01)
    np.testing.assert_allclose(np.degrees(exact.noise), 0.02)
    coded = _controller("[controller.sensors]\ncoordinate = { bits = 16 }").sensors.sensors[0]
    np.testing.assert_allclose(coded.step, 2.0 * np.pi / 2.0**16)
    assert robots.load("patu655").n == len(coded.step)
