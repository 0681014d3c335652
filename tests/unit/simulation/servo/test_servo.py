"""The servo-driven arm."""

import os
import subprocess
import sys
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.linalg import expm

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, LawError, LawInput, LawTraits
from ropsim.core import RopsimError
from ropsim.dynamics import gravity
from ropsim.flow import JointReference
from ropsim.model import Payload, Rates
from ropsim.simulation import (
    DivergedError,
    DriveDataError,
    NoDrivesError,
    OptionError,
    Servo,
    ServoArrayError,
    ServoState,
)
from ropsim.spatial import Array
from support.arms import drive, random_arm
from support.dc_drives import dc_motor, voltage_amplifier
from support.gains import cascaded
from support.servo_cases import (
    GOAL,
    START,
    CascadeInPython,
    controller,
    part,
    puma,
    quintic,
    standing,
    with_rates,
)

NOTHING = Payload()
BOX = Payload(0.5, np.array([0.0, 0.0, 0.1]), np.diag([4e-4, 4e-4, 6e-4]))
TICKS = 140
TWO_ENGINES = 1e-9  # elementary functions of two libraries over 140 ms of closed loop


HOLD = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        out[j] = par[0, j]
"""


def _constant(volts: float) -> CompiledLaw:
    return CompiledLaw("constant", HOLD, ("u",), np.full((1, 1), volts))


@pytest.fixture(scope="module")
def servo() -> Servo:
    return Servo.build(*puma())


def _run(servo: Servo, reference: JointReference, payload: Payload = NOTHING) -> ServoState:
    start = servo.initial_state(START, payload)
    return servo.run(start, reference, payload, servo.recorder(start))


def test_the_arm_follows_a_slow_reference(servo: Servo) -> None:
    reference = quintic(START, START + 0.1 * (GOAL - START), 1000)
    state = servo.initial_state(START)
    recorder = servo.recorder(state)
    servo.run(state, reference, NOTHING, recorder)
    error = recorder.channels()["q_ref"] - recorder.channels()["q"]
    assert (np.abs(error).max(axis=0) < _friction_over_stiffness(servo)).all()


def _friction_over_stiffness(servo: Servo) -> Array:
    """Return how far the proportional loops alone yield to Coulomb friction [rad]: R·Tc/Kt / (kp·kv)."""
    gains = cascaded(puma()[1])
    volts = [
        dc_motor(one).resistance
        * max(one.friction.coulomb_positive, -one.friction.coulomb_negative)
        / dc_motor(one).torque_constant
        for one in servo.robot.drives
    ]
    return np.asarray(volts / (gains.kp * gains.kv))


def test_a_start_at_rest_stays_at_rest(servo: Servo) -> None:
    after = _run(servo, standing(START, 200))
    sag = 1e-9  # [rad] currents and integrals balance gravity from the first tick
    np.testing.assert_allclose(after.q, START, rtol=0, atol=sag)
    np.testing.assert_allclose(after.qd, 0.0, rtol=0, atol=1e-9)


def _torque_constants(servo: Servo) -> Array:
    """Return G·Kt of each joint [N·m/A]."""
    return np.array([one.ratio_at(0.0) * dc_motor(one).torque_constant for one in servo.robot.drives])


def test_motors_at_rest_carry_gravity_and_payload(servo: Servo) -> None:
    state = servo.initial_state(START, BOX)
    torque = _torque_constants(servo) * state.drive("current")
    np.testing.assert_allclose(torque, gravity(servo.robot, START, BOX), rtol=1e-12, atol=1e-12)


def test_a_grasp_makes_the_arm_yield_and_the_integral_carry_the_part(servo: Servo) -> None:
    start = servo.initial_state(START)
    recorder = servo.recorder(start)
    after = servo.run(start, standing(START, 1000), BOX, recorder)
    assert np.abs(recorder.channels()["q"][50] - START).max() > 1e-6
    torque = _torque_constants(servo) * after.drive("current")
    needed = gravity(servo.robot, START, BOX)
    assert abs(torque[1] - needed[1]) < 0.1 * abs(needed[1] - gravity(servo.robot, START)[1])


def test_two_runs_give_the_same_bits(servo: Servo) -> None:
    reference = quintic(START, GOAL, TICKS)
    np.testing.assert_array_equal(_run(servo, reference).values, _run(servo, reference).values)


def test_a_fresh_process_gives_the_same_bits(servo: Servo) -> None:
    script = (
        "import numpy as np\n"
        "from support.servo_cases import *\n"
        "from ropsim.simulation import Servo\n"
        "from ropsim.model import Payload\n"
        "servo = Servo.build(*puma())\n"
        "state = servo.initial_state(START)\n"
        f"state = servo.run(state, quintic(START, GOAL, {TICKS}), Payload(), servo.recorder(state))\n"
        "print(state.values.tobytes().hex())\n"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    done = subprocess.run(
        [sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == _run(servo, quintic(START, GOAL, TICKS)).values.tobytes().hex()


@pytest.mark.parametrize("length", [1, 7, 20])
def test_slices_of_any_length_give_the_same_bits(servo: Servo, length: int) -> None:
    reference = quintic(START, GOAL, TICKS)
    whole = servo.initial_state(START)
    log = servo.recorder(whole, 3)
    whole = servo.run(whole, reference, NOTHING, log)
    state = servo.initial_state(START)
    cut_log = servo.recorder(state, 3)
    for begin, end in pairwise([*range(0, TICKS, length), TICKS]):
        state = servo.run(state, part(reference, begin, end), NOTHING, cut_log)
    assert state.tick == whole.tick == TICKS
    np.testing.assert_array_equal(state.values, whole.values)
    for name, values in log.channels().items():
        np.testing.assert_array_equal(cut_log.channels()[name], values)


def test_the_state_given_to_run_stays_as_it_is(servo: Servo) -> None:
    state = servo.initial_state(START)
    before = state.values.copy()
    assert servo.run(state, quintic(START, GOAL, 10), NOTHING, servo.recorder(state)).q[0] != before[0]
    np.testing.assert_array_equal(state.values, before)


def test_plain_python_and_compiled_code_agree() -> None:
    reference = quintic(START, GOAL, TICKS)
    python, compiled = (
        _run(Servo.build(*puma(), engine=engine), reference) for engine in (Engine.PYTHON, Engine.NUMBA)
    )
    np.testing.assert_allclose(python.values, compiled.values, rtol=TWO_ENGINES, atol=TWO_ENGINES)


def test_the_built_in_law_in_python_gives_the_same_bits(servo: Servo) -> None:
    robot, model = puma()
    law = CascadeInPython(model, robot)
    slow = Servo.build(robot, model, law)
    reference = quintic(START, GOAL, TICKS)
    np.testing.assert_array_equal(_run(slow, reference).values, _run(servo, reference).values)
    assert law.times[:3] == [0.0, 0.001, 0.002]


def test_another_law_takes_the_place_of_the_built_in_one() -> None:
    robot, model = puma()
    source = "def law(par, state, ref, meas, load, aux, out):\n    out[:] = 0.0\n"
    off = CompiledLaw("off", source, (), np.zeros((0, 6)))
    servo = Servo.build(robot, model, off)
    after = _run(servo, standing(START, 50))
    assert np.abs(after.qd).max() > 1e-3  # nobody holds the arm


def test_other_gains_run_the_same_compiled_code(servo: Servo) -> None:
    robot, model = puma()
    soft = replace(cascaded(model), kp=cascaded(model).kp * 0.5)
    softer = Servo.build(robot, replace(model, gains=soft))
    assert softer.kernel is servo.kernel
    reference = quintic(START, GOAL, TICKS)
    assert np.abs(_run(softer, reference).q - _run(servo, reference).q).max() > 1e-6


@pytest.mark.parametrize("ratio", [60.0, -60.0])
def test_positive_output_of_the_law_drives_the_joint_forward(ratio: float) -> None:
    robot = replace(random_arm(6, "R", (drive(ratio=ratio),)), gravity=np.zeros(3))
    servo = Servo.build(robot, controller(1), _constant(1.0), Engine.PYTHON)
    state = servo.initial_state(np.zeros(1))
    recorder = servo.recorder(state)
    after = servo.run(state, standing(np.zeros(1), 50), NOTHING, recorder)
    assert after.qd[0] > 0.0
    assert recorder.channels()["tau"][-1, 0] > 0.0
    assert recorder.channels()["voltage"][-1, 0] == np.sign(ratio)


def test_the_amplifier_clips_the_voltage(servo: Servo) -> None:
    state = servo.initial_state(START)
    recorder = servo.recorder(state)
    servo.run(state, standing(START + 1.0, 30), NOTHING, recorder)
    voltage = np.abs(recorder.channels()["voltage"])
    limits = [voltage_amplifier(one).max_voltage for one in servo.robot.drives]
    assert (voltage <= limits).all()
    assert (voltage[2] == limits).all()  # over the first tick the arm still stands on its reference


def test_the_integral_stands_still_while_the_output_is_clipped(servo: Servo) -> None:
    start = servo.initial_state(START)
    after = servo.run(start, standing(START + 1.0, 5), NOTHING, servo.recorder(start))
    np.testing.assert_array_equal(after.law, start.law)


def test_a_single_axis_moves_as_the_matrix_exponential_says() -> None:
    """Without gravity and Coulomb friction, motor and axis are linear in (q̇, i): ẋ = A·x + b·u."""
    one = drive(ratio=60.0)
    robot = replace(random_arm(6, "R", (one,)), gravity=np.zeros(3))
    servo = Servo.build(robot, controller(1, Rates(1000, 4, 16)), _constant(5.0), Engine.PYTHON)
    link, motor = robot.links[0], dc_motor(one)
    x, y, _ = link.com
    inertia = link.inertia[2, 2] + link.mass * (x * x + y * y) + motor.rotor_inertia * one.ratio_at(0.0) ** 2
    A = np.zeros((3, 3))
    A[0, 1] = one.ratio_at(0.0) * motor.torque_constant / inertia
    A[1] = np.array([-one.ratio_at(0.0) * motor.back_emf_constant, -motor.resistance, 5.0]) / motor.inductance
    expected = (expm(A * 0.05) @ np.array([0.0, 0.0, 1.0]))[:2]
    state = servo.initial_state(np.zeros(1))
    after = servo.run(state, standing(np.zeros(1), 50), NOTHING, servo.recorder(state))
    integration = 1e-7  # RK4 at 62.5 µs with an electrical time constant of 1.7 ms
    np.testing.assert_allclose([after.qd[0], after.drive("current")[0]], expected, rtol=integration)


def test_more_plant_steps_converge_with_fourth_order() -> None:
    robot, model = puma()
    reference = quintic(START, GOAL, 60)
    ends: list[Array] = []
    for steps in (4, 8, 32):
        servo = Servo.build(robot, with_rates(model, Rates(1000, 4, steps)))
        ends.append(_run(servo, reference).q)
    coarse, fine = (float(np.abs(end - ends[2]).max()) for end in ends[:2])
    assert coarse < 1e-6
    assert fine < coarse / 8.0 + 1e-14  # sixteen in theory; friction near standstill costs a little


def test_the_step_of_the_standard_rates_costs_less_than_a_micrometre_at_a_metre() -> None:
    robot, model = puma()
    reference = quintic(START, GOAL, 1000)
    standard, fine = (
        _run(Servo.build(robot, with_rates(model, rates)), reference)
        for rates in (Rates(), Rates(1000, 4, 32))
    )
    assert 0.0 < np.abs(standard.q - fine.q).max() < 1e-6


def test_an_arm_without_drives_is_refused() -> None:
    with pytest.raises(NoDrivesError, match="`random_RR` has 0 drives for 2 joints") as caught:
        Servo.build(random_arm(1, "RR"), controller(2))
    assert caught.value.diagnostic.code == "S700"


def test_an_impossible_drive_is_refused_by_name() -> None:
    broken = replace(drive(), motor=replace(dc_motor(drive()), inductance=0.0))
    with pytest.raises(DriveDataError, match=r"`inductance` of the drive of joint `1` is `0\.0`"):
        Servo.build(random_arm(0, "R", (broken,)), controller(1))


def test_gains_for_another_number_of_joints_are_refused() -> None:
    with pytest.raises(RopsimError, match=r"`kp` has shape `\(5,\)`; allowed is `\(6,\)`") as caught:
        Servo.build(robots.load("puma560"), controller(5))
    assert caught.value.diagnostic.code == "C600"


def test_rates_below_one_are_refused() -> None:
    with pytest.raises(OptionError, match="`plant_steps` is `0`"):
        Servo.build(robots.load("puma560"), controller(6, Rates(1000, 4, 0)))


def test_a_reference_of_another_shape_is_refused(servo: Servo) -> None:
    state = servo.initial_state(START)
    bad = JointReference(np.zeros((3, 6)), np.zeros((3, 6)), np.zeros((2, 6)))
    with pytest.raises(ServoArrayError, match=r"`reference\.qdd` has shape `\(2, 6\)`"):
        servo.run(state, bad, NOTHING, servo.recorder(state))


@pytest.mark.parametrize("engine", list(Engine))
def test_a_nan_in_the_reference_is_an_error_with_its_time(engine: Engine) -> None:
    servo = Servo.build(*puma(), engine=engine)
    reference = quintic(START, GOAL, 5)
    reference.q[2, 3] = np.nan
    state = servo.initial_state(START)
    with pytest.raises(DivergedError, match="reference of joint `4` is not finite") as caught:
        servo.run(state, reference, NOTHING, servo.recorder(state))
    found = caught.value.diagnostic
    assert (found.code, found.data["tick"], found.data["time_s"]) == ("S701", 3, 0.003)  # row 2 is due then


NAN_AT_A_TICK = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        out[j] = 0.0
    if state[0, 0] == par[0, 0]:
        out[3] = math.nan
    state[0, 0] += 1.0
"""


@pytest.mark.parametrize("engine", list(Engine))
@pytest.mark.parametrize("tick", [0, 1, 41, 99])
def test_a_compiled_law_that_puts_out_nan_is_named_with_joint_and_tick(engine: Engine, tick: int) -> None:
    traits = LawTraits(state_names=("ticks",))
    law = CompiledLaw("nan_at_a_tick", NAN_AT_A_TICK, ("tick",), np.full((1, 6), 1.0 + tick), traits)
    servo = Servo.build(*puma(), law=law, engine=engine)
    start = servo.initial_state(START)
    values = start.values.copy()
    servo.layout.memory(values)[0] = 1.0  # at 0 laws are rehearsed
    start = ServoState(0, values, servo.layout)
    with pytest.raises(DivergedError, match="output of the joint controller of joint `4`") as caught:
        servo.run(start, standing(START, 100), NOTHING, servo.recorder(start))
    assert caught.value.diagnostic.data["tick"] == tick + 1  # at the end of that tick


def test_a_slice_that_diverges_names_the_same_tick_however_it_is_cut() -> None:
    coarse = Servo.build(puma()[0], with_rates(puma()[1], Rates(50, 4, 2)))
    reference = quintic(START, GOAL, 400)
    found = []
    for cut in (1, 7, 400):
        state = coarse.initial_state(START)
        recorder = coarse.recorder(state)
        with pytest.raises(DivergedError) as caught:  # noqa: PT012 - which slice fails is what is asked
            for first in range(0, 400, cut):
                state = coarse.run(state, reference.part(first, min(first + cut, 400)), NOTHING, recorder)
        found.append(caught.value.diagnostic)
    assert found[0] == found[1] == found[2]


def test_a_law_in_python_that_returns_nan_is_named_with_its_tick() -> None:
    class Poisoned:
        traits = LawTraits()

        def step(self, now: LawInput, _state: Array, /) -> Array:
            return np.full(6, np.nan if now.time > 0.0165 else 0.0)

    with pytest.raises(ServoArrayError, match=r"not finite.*at 0.017 s \(control tick 17\)") as caught:
        _run(Servo.build(*puma(), law=Poisoned()), standing(START, 30))
    assert caught.value.diagnostic.data["tick"] == 17


def test_a_start_that_is_not_finite_is_refused(servo: Servo) -> None:
    with pytest.raises(ServoArrayError, match="`q` holds a number that is not finite"):
        servo.initial_state([0.0, 0.0, np.inf, 0.0, 0.0, 0.0])


def test_a_law_in_python_that_returns_too_few_voltages_is_refused() -> None:
    class Short:
        traits = LawTraits()

        def step(self, _now: LawInput, _state: Array, /) -> Array:
            return np.zeros(2)

    servo = Servo.build(*puma(), law=Short())
    with pytest.raises(ServoArrayError, match="`u` has shape"):
        _run(servo, standing(START, 1))


def test_an_error_inside_a_law_in_python_reaches_its_author() -> None:
    class Faulty:
        traits = LawTraits()

        def step(self, _now: LawInput, _state: Array, /) -> Array:
            raise ValueError("mistake in the law")

    with pytest.raises(
        LawError, match=r"ValueError: mistake in the law \(test_servo.py, line \d+\)"
    ) as caught:
        _run(Servo.build(*puma(), law=Faulty()), standing(START, 1))
    assert isinstance(caught.value.__cause__, ValueError)


def test_a_state_cannot_be_written_to(servo: Servo) -> None:
    state = _run(servo, standing(START, 1))
    with pytest.raises(ValueError, match="read-only"):
        state.q[0] = 1.0


def test_read_only_references_are_taken(servo: Servo) -> None:
    reference = quintic(START, GOAL, 5)
    for array in (reference.q, reference.qd, reference.qdd):
        array.flags.writeable = False
    assert _run(servo, reference).tick == 5
