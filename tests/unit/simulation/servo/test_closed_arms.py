"""Arms with closed chains under their controllers: cuts move as couplings do, and stay closed."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.flow import JointReference
from ropsim.model import JointSpring, Payload, RobotModel
from ropsim.robots import default_controller
from ropsim.simulation import DivergedError, Servo, ServoState, linear_loop
from ropsim.simulation.testing import diverged, is_sound
from support.closed_arms import COUPLED_PALLETIZER, five_bar, palletizer

CUT = palletizer()
FIVE_BAR = replace(five_bar(), drives=(COUPLED_PALLETIZER.drives[1],) * 2)
LOOPED = default_controller(FIVE_BAR)
CONTROLLER = default_controller(CUT)
TICKS = 400
PAYLOAD = Payload(20.0, np.array([0.1, 0.0, 0.2]), 0.2 * np.eye(3))
SWING = np.array([0.3, 0.15, -0.2, 0.4])


def reference(ticks: int) -> JointReference:
    t = np.arange(1, ticks + 1)[:, np.newaxis] / CONTROLLER.rates.control_hz
    return JointReference(
        COUPLED_PALLETIZER.home + SWING * (1.0 - np.cos(4.0 * t)),
        SWING * 4.0 * np.sin(4.0 * t),
        SWING * 16.0 * np.cos(4.0 * t),
    )


def run(robot: RobotModel, ticks: int = TICKS) -> tuple[Servo, ServoState]:
    servo = Servo.build(robot, CONTROLLER)
    state = servo.initial_state(robot.home, PAYLOAD)
    return servo, servo.run(state, reference(ticks), PAYLOAD, servo.recorder(state))


def test_parallelograms_as_cuts_follow_as_those_of_couplings() -> None:
    _, cut = run(CUT)
    _, coupled = run(COUPLED_PALLETIZER)
    assert np.abs(cut.q - coupled.q).max() < 1e-9  # found 3e-16
    assert np.abs(cut.qd - coupled.qd).max() < 1e-9
    assert cut.layout.passive == 0


def test_a_closed_chain_stays_closed_while_it_moves() -> None:
    servo = Servo.build(FIVE_BAR, LOOPED)
    state = servo.initial_state(FIVE_BAR.home)
    way = np.linspace(0.0, 0.2, TICKS)[:, np.newaxis] * [1.0, -1.0]
    motion = JointReference(FIVE_BAR.home + way, 0.0 * way, 0.0 * way)
    after = servo.run(state, motion, Payload(), servo.recorder(state))
    assert np.abs(after.q - FIVE_BAR.home).max() > 0.1
    assert after.values[after.layout.loops.gap] < 1e-12


def test_springs_on_coordinates_act_in_cuts_as_in_couplings() -> None:
    on = (JointSpring("return", 1, 3000.0, 0.1, 40.0),)
    _, plain = run(CUT, 50)
    _, cut = run(replace(CUT, joint_springs=on), 50)
    _, coupled = run(replace(COUPLED_PALLETIZER, joint_springs=on), 50)
    assert np.abs(cut.q - coupled.q).max() < 1e-9
    assert np.abs(cut.q - plain.q).max() > 1e-9  # the law knows the spring


def test_plain_python_runs_them_as_compiled_code_does() -> None:
    _, compiled = run(CUT, 3)
    servo = Servo.build(CUT, CONTROLLER, engine=Engine.PYTHON)
    state = servo.initial_state(CUT.home, PAYLOAD)
    plain = servo.run(state, reference(3), PAYLOAD, servo.recorder(state))
    assert np.abs(plain.values - compiled.values).max() < 1e-9


def test_the_linear_loop_of_cuts_is_that_of_couplings() -> None:
    cut, coupled = (linear_loop(one, CONTROLLER, one.home, PAYLOAD) for one in (CUT, COUPLED_PALLETIZER))
    for name in ("F", "G", "K", "L"):
        one, other = getattr(cut, name), getattr(coupled, name)
        assert one.shape == other.shape
        assert np.abs(one - other).max() < 1e-6 * max(1.0, np.abs(other).max()), name


def test_an_arm_that_holds_still_stays_where_it_is() -> None:
    servo = Servo.build(CUT, CONTROLLER)
    state = servo.initial_state(CUT.home, PAYLOAD)
    still = np.zeros((100, CUT.n))
    held = JointReference(still + CUT.home, still, still)
    after = servo.run(state, held, PAYLOAD, servo.recorder(state))
    assert np.abs(after.q - CUT.home).max() < 1e-9


def still(ticks: int) -> JointReference:
    rest = np.zeros((ticks, 2))
    return JointReference(rest + FIVE_BAR.home, rest, rest)


@pytest.mark.parametrize("speed", [20.0, 200.0], ids=["fast", "absurd"])
def test_chains_stay_closed_at_any_speed_that_can_be_integrated(speed: float) -> None:
    servo = Servo.build(FIVE_BAR, LOOPED)
    state = servo.initial_state(FIVE_BAR.home)
    values = state.values.copy()
    values[state.layout.qd] = speed * np.array([1.0, 0.8])
    fast = ServoState(0, values, state.layout)
    after = servo.run(fast, still(20), PAYLOAD, servo.recorder(fast))
    assert after.values[after.layout.loops.gap] < 1e-9


def test_speeds_beyond_that_end_the_run_with_the_tick() -> None:
    servo = Servo.build(FIVE_BAR, LOOPED)
    state = servo.initial_state(FIVE_BAR.home)
    values = state.values.copy()
    values[state.layout.qd] = 1e6
    fast = ServoState(0, values, state.layout)
    with pytest.raises(DivergedError, match="control tick 1") as caught:
        servo.run(fast, still(5), PAYLOAD, servo.recorder(fast))
    assert caught.value.diagnostic.code in {"S701", "S706"}


def test_chains_that_have_come_apart_are_named_with_the_gap() -> None:
    state = Servo.build(FIVE_BAR, LOOPED).initial_state(FIVE_BAR.home)
    assert is_sound(state.values, state.layout)
    values = state.values.copy()
    values[state.layout.loops.gap] = 2e-3
    assert not is_sound(values, state.layout)
    found = diverged(FIVE_BAR, ServoState(17, values, state.layout), LOOPED.rates).diagnostic
    assert found.code == "S706"
    assert "closed chains of `five-bar` are 0.002 (m, rad) apart" in found.message
    assert "(control tick 17)" in found.message
