"""What is recorded, and when."""

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.dynamics import compiled
from ropsim.model import Payload
from ropsim.simulation import OptionError, Servo
from ropsim.simulation.testing import TickRecorder
from support.dc_drives import dc_motor
from support.servo_cases import GOAL, START, part, puma, quintic, standing

NOTHING = Payload()
BALANCE = 0.1
"""Torques up to 60 N·m; accelerations are differences over two ticks, 0.04 N·m at worst [N·m]."""


@pytest.fixture(scope="module")
def servo() -> Servo:
    return Servo.build(*puma())


def test_row_zero_is_the_start_at_its_own_reference(servo: Servo) -> None:
    start = servo.initial_state(START)
    recorder = servo.recorder(start)
    channels = recorder.channels()
    assert recorder.ticks.tolist() == [0.0]
    np.testing.assert_array_equal(channels["q"][0], START)
    np.testing.assert_array_equal(channels["q_ref"][0], START)
    resistance = [dc_motor(one).resistance for one in servo.robot.drives]
    np.testing.assert_allclose(channels["voltage"][0], resistance * start.drive("current"), rtol=1e-15)


def test_a_row_holds_the_state_at_the_end_of_its_tick_beside_its_reference(servo: Servo) -> None:
    reference = quintic(START, GOAL, 30)
    state = servo.initial_state(START)
    recorder = servo.recorder(state)
    after = servo.run(state, reference, NOTHING, recorder)
    channels = recorder.channels()
    np.testing.assert_array_equal(channels["q"][-1], after.q)
    np.testing.assert_array_equal(channels["qd"][-1], after.qd)
    np.testing.assert_array_equal(channels["current"][-1], after.drive("current"))
    np.testing.assert_array_equal(channels["q_ref"][1:], reference.q)
    np.testing.assert_array_equal(channels["qd_ref"][1:], reference.qd)


def test_the_recorded_torques_move_the_arm_as_it_was_recorded(servo: Servo) -> None:
    state = servo.initial_state(START)
    recorder = servo.recorder(state)
    servo.run(state, quintic(START, GOAL, 600), NOTHING, recorder)
    channels = recorder.channels()
    functions = compiled(servo.robot, engine=Engine.PYTHON)
    for row in range(50, 600, 50):
        before, after = channels["qd"][[row - 1, row + 1]]
        acceleration = (after - before) / (2.0 * servo.period)
        needed = np.empty(6)
        functions.inverse(channels["q"][row], channels["qd"][row], acceleration, np.zeros(6), needed)
        np.testing.assert_allclose(channels["tau"][row], needed, rtol=0, atol=BALANCE)


@pytest.mark.parametrize("decimation", [1, 3, 10])
def test_rows_are_equally_spaced_ticks_that_the_decimation_divides(servo: Servo, decimation: int) -> None:
    state = servo.initial_state(START)
    recorder = servo.recorder(state, decimation)
    for ticks in (7, 1, 22):
        state = servo.run(state, standing(START, ticks), NOTHING, recorder)
    assert recorder.ticks.tolist() == list(range(0, 31, decimation))
    assert recorder.channels()["q"].shape == (recorder.rows, 6)


def test_a_recording_may_begin_between_two_rows(servo: Servo) -> None:
    state = servo.initial_state(START)
    state = servo.run(state, standing(START, 7), NOTHING, servo.recorder(state))
    late = servo.recorder(state, 5)
    servo.run(state, standing(START, 8), NOTHING, late)
    assert late.ticks.tolist() == [10.0, 15.0]


def test_a_recording_that_begins_in_a_motion_begins_with_the_reference_of_that_instant(servo: Servo) -> None:
    start = servo.initial_state(START)
    whole = servo.recorder(start)
    reference = quintic(START, GOAL, 30)
    state = servo.run(start, part(reference, 0, 13), NOTHING, whole)
    late = servo.recorder(state)
    for recorder in (whole, late):
        servo.run(state, part(reference, 13, 30), NOTHING, recorder)
    for name, values in whole.channels().items():
        np.testing.assert_array_equal(late.channels()[name], values[13:])


def test_a_decimation_below_one_is_refused(servo: Servo) -> None:
    with pytest.raises(OptionError, match="`decimation` is `0`"):
        servo.recorder(servo.initial_state(START), 0)


def test_the_log_grows_and_keeps_what_it_holds(servo: Servo) -> None:
    state = servo.initial_state(START)
    recorder = servo.recorder(state)
    state = servo.run(state, quintic(START, GOAL, 100), NOTHING, recorder)
    early = recorder.channels()["q"].copy()
    servo.run(state, standing(GOAL, 6000), NOTHING, recorder)
    assert recorder.rows == 6101
    np.testing.assert_array_equal(recorder.channels()["q"][:101], early)


def test_the_past_of_an_arm_beside_others_has_each_state_at_its_tick(servo: Servo) -> None:
    """However coarse the recording is; the reference is followed in two pieces."""
    whole = quintic(START, GOAL, 30)
    states = [servo.initial_state(START)]
    alone = servo.recorder(states[0])
    for k in range(30):
        states.append(servo.run(states[-1], part(whole, k, k + 1), NOTHING, alone))
    beside = TickRecorder(servo.robot, states[0], 7)
    state = states[0]
    for first, last in ((0, 13), (13, 30)):
        state = servo.run(state, part(whole, first, last), NOTHING, beside)
        beside.take()
    for tick, known in enumerate(states):
        np.testing.assert_array_equal(beside.q_at(tick), known.q)
    assert (states[13].q != states[14].q).all()
