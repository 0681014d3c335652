"""The law is given reference and measurement of the same instant, whatever the control rate."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, LawInput, LawTraits, cascaded_p_pi
from ropsim.flow import JointReference
from ropsim.model import ControllerModel, Friction, Payload, Rates, RobotModel
from ropsim.simulation import Servo, ServoState
from ropsim.spatial import Array
from support.arms import drive, random_arm
from support.gains import cascaded
from support.servo_cases import GOAL, START, CascadeInPython, controller, part, puma, quintic

NOTHING = Payload()
RATES = (500, 1000, 4000)
"""Control rates [Hz]."""
SPEED, RAMP = 1.0, 0.2
"""Constant speed [rad/s], and the time in which it is reached [s]."""
NO_ERROR = 1e-9
"""What is left of an error when the slowest loop has had a dozen of its time constants [rad]."""
NO_SHIFT = 1e-6
"""Rounding of a shift in time [control ticks]."""
TICKS = 60


def cruise(q: Array, hz: int, seconds: float) -> JointReference:
    """Return a reference that takes axis 1 from rest at `q` to a constant speed; the others stand still."""
    t = np.arange(1, round(seconds * hz) + 1) / hz
    u = np.minimum(t / RAMP, 1.0)
    reference = JointReference(*(np.zeros((len(t), len(q))) for _ in range(3)))
    reference.q[:] = q
    reference.q[:, 0] += SPEED * (RAMP * (u**3 - 0.5 * u**4) + np.maximum(t - RAMP, 0.0))
    reference.qd[:, 0] = SPEED * u * u * (3.0 - 2.0 * u)
    reference.qdd[:, 0] = SPEED / RAMP * 6.0 * u * (1.0 - u)
    return reference


def _standard(robot: RobotModel, hz: int) -> ControllerModel:
    """Return the cascaded controller with the standard gains for a control rate."""
    rates = Rates(control_hz=hz)
    return replace(controller(robot.n, rates), gains=robots.standard_gains(robot, rates))


def _errors(servo: Servo, reference: JointReference, q: Array) -> Array:
    """Return reference minus attained coordinates at every tick, shape (ticks + 1, n)."""
    start = servo.initial_state(q)
    recorder = servo.recorder(start)
    servo.run(start, reference, NOTHING, recorder)
    return recorder.channels()["q_ref"] - recorder.channels()["q"]


# --- constant speed


@pytest.mark.parametrize("hz", RATES)
def test_integral_action_leaves_no_error_at_constant_speed(hz: int) -> None:
    """Axis 1 of the PUMA stands upright: nothing changes for it while it turns alone, against friction."""
    robot, _ = puma()
    servo = Servo.build(robot, _standard(robot, hz))
    errors = _errors(servo, cruise(START, hz, 3.0), START)[:, 0]
    assert np.abs(errors[1 : hz // 5]).max() > 1e3 * NO_ERROR  # Coulomb friction was not foreseen
    assert np.abs(errors[-hz // 10 :]).max() <= NO_ERROR


@pytest.mark.parametrize("hz", RATES)
def test_exact_feed_forward_leaves_no_shift_in_time_at_constant_speed(hz: int) -> None:
    """Without integral action: an arm that runs a tick ahead of its reference is -1 tick late."""
    one = drive(friction=Friction(viscous=1e-3))
    robot = replace(random_arm(6, "R", (one,)), gravity=np.zeros(3))
    model = _standard(robot, hz)
    proportional = replace(model, gains=replace(cascaded(model), ki=np.zeros(1)))
    servo = Servo.build(robot, proportional, None, Engine.PYTHON)
    late = _errors(servo, cruise(np.zeros(1), hz, 1.0), np.zeros(1))[-1, 0] * hz / SPEED
    assert abs(late) < NO_SHIFT


# --- what a law is given

NOTED = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        for row in range(3):
            state[row, j] = ref[row, j]
        state[3, j] = meas[0, j]
        state[4, j] = meas[1, j]
        out[j] = 1.0
"""


@pytest.mark.parametrize("engine", Engine)
def test_a_compiled_law_is_given_what_holds_at_its_tick(engine: Engine) -> None:
    robot = random_arm(3, "RR", (drive(), drive(ratio=-40.0)))
    law = CompiledLaw("noted", NOTED, (), np.zeros((0, 2)), LawTraits(state_names=tuple("abcde")))
    servo = Servo.build(robot, controller(2), law, engine)
    reference = quintic(np.zeros(2), np.ones(2), 5)
    before = servo.initial_state(np.zeros(2))
    np.testing.assert_array_equal(before.reference, 0.0)
    for k in range(5):
        after = servo.run(before, part(reference, k, k + 1), NOTHING, servo.recorder(before))
        np.testing.assert_array_equal(after.law, [*before.reference, before.q, before.qd])
        np.testing.assert_array_equal(after.reference, [reference.q[k], reference.qd[k], reference.qdd[k]])
        before = after


class Keeping(CascadeInPython):
    """A law in Python that keeps what it is given."""

    def __init__(self, model: ControllerModel, robot: RobotModel) -> None:
        super().__init__(model, robot)
        self.given: list[LawInput] = []

    def step(self, now: LawInput, state: Array, /) -> Array:
        self.given.append(now)
        return super().step(now, state)


def test_a_law_in_python_is_given_what_the_log_says_of_its_tick() -> None:
    robot, model = puma()
    law = Keeping(model, robot)
    servo = Servo.build(robot, model, law)
    start = servo.initial_state(START)
    recorder = servo.recorder(start)
    servo.run(start, quintic(START, GOAL, TICKS), NOTHING, recorder)
    log = recorder.channels()
    assert len(law.given) == TICKS
    for tick, now in enumerate(law.given):
        assert now.time == pytest.approx(tick / servo.control_hz)
        np.testing.assert_array_equal(now.ref[:2], [log["q_ref"][tick], log["qd_ref"][tick]])
        np.testing.assert_array_equal(now.meas[:2], [log["q"][tick], log["qd"][tick]])


# --- slices and snapshots


def _servos() -> dict[str, Servo]:
    """Return the PUMA under a compiled law, a law in Python, and one whose output acts two ticks later."""
    robot, model = puma()
    law = cascaded_p_pi(model, robot)
    late = replace(law, traits=replace(law.traits, delay=2))
    return {
        "compiled": Servo.build(robot, model),
        "in Python": Servo.build(robot, model, CascadeInPython(model, robot)),
        "delayed": Servo.build(robot, model, late, Engine.PYTHON),
    }


@pytest.mark.parametrize("kind", ["compiled", "in Python", "delayed"])
def test_however_a_reference_is_cut_the_bits_are_the_same(kind: str) -> None:
    servo, reference = _servos()[kind], quintic(START, GOAL, TICKS)
    start = servo.initial_state(START)
    log = servo.recorder(start)
    whole = servo.run(start, reference, NOTHING, log)
    for seed in range(3):
        cuts = sorted(np.random.default_rng(seed).choice(np.arange(1, TICKS), 9, replace=False).tolist())
        state, cut_log = start, servo.recorder(start)
        for first, last in pairwise([0, *cuts, TICKS]):
            state = servo.run(state, part(reference, first, last), NOTHING, cut_log)
        np.testing.assert_array_equal(state.values, whole.values)
        for name, values in log.channels().items():
            np.testing.assert_array_equal(cut_log.channels()[name], values)


@pytest.mark.parametrize("kind", ["compiled", "in Python", "delayed"])
def test_a_snapshot_goes_on_with_the_same_bits(kind: str) -> None:
    """It is tick and numbers and nothing else; another servo takes it up, in the middle of a motion."""
    reference = quintic(START, GOAL, TICKS)
    servo, other = _servos()[kind], _servos()[kind]
    start = servo.initial_state(START)
    half = servo.run(start, part(reference, 0, 23), NOTHING, servo.recorder(start))
    whole = servo.run(start, reference, NOTHING, servo.recorder(start))
    snapshot = half.tick, half.values.tobytes()
    taken_up = ServoState(snapshot[0], np.frombuffer(snapshot[1]).copy(), other.layout)
    after = other.run(taken_up, part(reference, 23, TICKS), NOTHING, other.recorder(taken_up))
    assert after.tick == whole.tick
    np.testing.assert_array_equal(after.values, whole.values)
