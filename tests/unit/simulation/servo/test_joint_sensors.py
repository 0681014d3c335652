"""Sensors between the arm and its law: steps, noise, rate and delay."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, LawInput, LawTraits
from ropsim.model import ControllerModel, JointSensor, JointSensors, Payload
from ropsim.simulation import Servo, ServoState
from ropsim.simulation.testing import KeptDrives
from ropsim.spatial import Array
from support.hydraulic_arm import hydraulic_arm
from support.servo_cases import controller, part, quintic

START, GOAL = np.array([0.7, -1.6]), np.array([0.75, -1.7])
TICKS = 40
SOURCE = """\
def law(state, ref, meas, sensed, out):
    for j in range(out.shape[0]):
        state[held, j] = state[held, j]
        state[q, j] = meas[0, j]
        state[a, j] = sensed[pressure_a, j]
        out[j] = 0.2 * (ref[0, j] - meas[0, j]) + state[held, j]
"""
TRAITS = LawTraits(state_names=("held", "q", "a"), hold_row=0, sensed=("pressure_a",))
LAW = CompiledLaw("reading", SOURCE, (), np.zeros((0, 2)), TRAITS)
NONE = np.zeros(2)


class InPython:
    """The same law in Python."""

    traits = TRAITS

    def step(self, now: LawInput, state: Array, /) -> Array:
        state[1], state[2] = now.meas[0], now.sensed[0]
        return np.asarray(0.2 * (now.ref[0] - now.meas[0]) + state[0])


def _under(*sensors: JointSensor, seed: int = 0) -> ControllerModel:
    return replace(controller(2), sensors=JointSensors(sensors, seed))


def _states(model: ControllerModel, law: Any = LAW, engine: Engine = Engine.PYTHON) -> list[ServoState]:
    """Return the states at each tick of a motion."""
    servo = Servo.build(hydraulic_arm(), model, law, engine)
    states, reference = [servo.initial_state(START)], quintic(START, GOAL, TICKS)
    for k in range(TICKS):
        row = part(reference, k, k + 1)
        states.append(servo.run(states[-1], row, Payload(), servo.recorder(states[-1])))
    return states


def _seen(model: ControllerModel, **more: Any) -> tuple[Array, Array]:
    """Return true and measured values at each tick: coordinates and pressures, shape (ticks, 4)."""
    states = _states(model, **more)
    true = [np.concatenate((one.q, one.drive("pressure_a"))) for one in states[:-1]]
    return np.array(true), np.array([one.law[1:].ravel() for one in states[1:]])


def test_without_sensors_a_law_gets_true_values() -> None:
    true, seen = _seen(_under())
    np.testing.assert_array_equal(seen, true)
    assert np.ptp(true[:, 0]) > 1e-4


def test_a_sensor_rounds_to_whole_steps() -> None:
    steps = np.array([1e-4, 2e-4]), np.array([6e3, 7e3])
    true, seen = _seen(
        _under(JointSensor("coordinate", steps[0], NONE), JointSensor("pressure", steps[1], NONE))
    )
    whole = np.concatenate(steps)
    np.testing.assert_allclose(seen / whole, np.round(seen / whole), atol=1e-9)
    assert (np.abs(seen - true) <= 0.5000001 * whole).all()
    assert len(np.unique(seen[:, 0])) > 2


def test_what_is_measured_comes_after_its_delay() -> None:
    true, seen = _seen(_under(JointSensor("pressure", NONE, NONE, delay=3e-3)))
    np.testing.assert_array_equal(seen[3:, 2:], true[:-3, 2:])
    np.testing.assert_array_equal(seen[:3, 2:], true[[0, 0, 0], 2:])
    np.testing.assert_array_equal(seen[:, :2], true[:, :2])


def test_a_sample_holds_until_the_next_one() -> None:
    true, seen = _seen(_under(JointSensor("coordinate", NONE, NONE, period=4e-3, delay=1e-3)))
    ticks = np.maximum((np.arange(TICKS) - 1) // 4 * 4, 0)
    np.testing.assert_array_equal(seen[:, :2], true[ticks, :2])


def test_noise_has_its_deviation_and_is_white() -> None:
    """Of 6,000 numbers the deviation is within 4 %, the mean within 0.05, neighbours are not alike."""
    sensor = JointSensor("pressure", NONE, np.array([1e4, 2e4]))
    servo = Servo.build(hydraulic_arm(), _under(sensor, seed=5), LAW, Engine.PYTHON)
    start = servo.initial_state(START)
    rows = []
    for tick in range(6000):
        frame = np.zeros((5, 2))
        servo.sensors.measure(frame, servo.layout.kept(start.values), tick)
        rows.append(frame[4] / sensor.noise)
    noise = np.array(rows)
    assert np.abs(noise.std(axis=0) - 1.0).max() < 0.04
    assert np.abs(noise.mean(axis=0)).max() < 0.05
    around = np.corrcoef(np.column_stack((noise[1:], noise[:-1])).T) - np.eye(4)
    assert np.abs(around).max() < 0.05
    assert 2.5 < np.abs(noise).max() < 6.0


def test_noise_depends_on_its_seed_and_on_the_tick_alone() -> None:
    noisy = JointSensor("coordinate", NONE, np.full(2, 1e-4))
    one, again, other = (_seen(_under(noisy, seed=seed)) for seed in (1, 1, 2))
    np.testing.assert_array_equal(one[1], again[1])
    assert np.abs((one[1] - one[0]) - (other[1] - other[0]))[:, :2].max() > 1e-5


ALL = (
    JointSensor("coordinate", np.full(2, 1e-4), np.full(2, 1e-4), period=2e-3, delay=1e-3),
    JointSensor("pressure", np.full(2, 6e3), np.full(2, 1e4), delay=2e-3),
)


@pytest.mark.parametrize(("law", "engine"), [(LAW, Engine.NUMBA), (InPython(), Engine.PYTHON)])
def test_laws_of_all_kinds_are_given_the_same(law: Any, engine: Engine) -> None:
    (_, expected), (_, seen) = (
        _seen(_under(*ALL, seed=3)),
        _seen(_under(*ALL, seed=3), law=law, engine=engine),
    )
    np.testing.assert_allclose(seen, expected, rtol=1e-9)


def test_slices_do_not_change_what_is_measured() -> None:
    servo = Servo.build(hydraulic_arm(), _under(*ALL, seed=3), LAW, Engine.PYTHON)
    start, reference = servo.initial_state(START), quintic(START, GOAL, TICKS)
    whole = servo.run(start, reference, Payload(), servo.recorder(start))
    np.testing.assert_array_equal(whole.values, _states(_under(*ALL, seed=3))[-1].values)


@pytest.mark.parametrize(
    ("sensor", "timed"),
    [
        (JointSensor("pressure", np.full(2, 6e3), np.full(2, 1e4)), True),
        (JointSensor("pressure", NONE, NONE, period=5e-3), True),
        (JointSensor("pressure", np.full(2, 6e3), NONE, delay=2e-3), False),
        (JointSensor("current", NONE, np.ones(2)), False),
    ],
)
def test_a_kept_slice_is_taken_again_where_the_sensors_say_the_same(sensor: JointSensor, timed: bool) -> None:
    """Noise and samples depend on the number of the tick; what no law reads does not count."""
    source = SOURCE.replace("state[held, j]\n", "state[held, j] + 1e-9 * sensed[pressure_a, j]\n")
    law = replace(LAW, source=source)
    servo, kept = Servo.build(hydraulic_arm(), _under(sensor, seed=3), law, Engine.PYTHON), KeptDrives()
    reference, start = quintic(START, GOAL, 12), servo.initial_state(START)
    for tick in (0, 7):
        state = ServoState(tick, start.values.copy(), start.layout)
        recorder = servo.recorder(state)
        given = state, reference, Payload(), recorder, np.empty((12, 0))
        after = kept.drive("one", servo, *given)
        alone = servo.run(state, reference, Payload(), servo.recorder(state))
        np.testing.assert_array_equal(after.values, alone.values)
    assert kept.anew == (24 if timed else 12)
