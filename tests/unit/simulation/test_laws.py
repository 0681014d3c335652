"""Laws of a user in the servo simulation: what they are given, say about themselves, and do wrong."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, LawError, LawInput, LawTraits, cascaded_p_pi
from ropsim.core import Diagnostic
from ropsim.dynamics import gravity
from ropsim.model import InputKind, Payload, RobotModel, ideal_drive
from ropsim.simulation import DivergedError, Servo, ServoState
from ropsim.spatial import Array
from support.arms import drive, random_arm
from support.servo_cases import GOAL, START, CascadeInPython, controller, part, puma, quintic, standing

NOTHING = Payload()
BOX = Payload(2.0, np.array([0.0, 0.01, 0.1]), np.diag([0.01, 0.02, 0.015]))
HALF: Any = 0.5
"""No number of ticks."""
HEAD = "def law(par, state, ref, meas, load, aux, out):\n"


def _law(body: str, traits: LawTraits | None = None, rows: int = 0, n: int = 2) -> CompiledLaw:
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    names = tuple(f"p{k}" for k in range(rows))
    return CompiledLaw("own", HEAD + lines, names, np.zeros((rows, n)), traits or LawTraits())


def _arm() -> RobotModel:
    return random_arm(3, "RR", (drive(), drive(ratio=-40.0)))


def _servo(law: Any, robot: RobotModel | None = None, engine: Engine = Engine.PYTHON) -> Servo:
    arm = robot or _arm()
    return Servo.build(arm, controller(arm.n), law, engine)


def _after(servo: Servo, ticks: int, payload: Payload = NOTHING, aux: Array | None = None) -> ServoState:
    start = servo.initial_state(np.zeros(servo.robot.n), payload)
    reference = standing(np.zeros(servo.robot.n), ticks)
    return servo.run(start, reference, payload, servo.recorder(start), aux)


def _found(law: Any, robot: RobotModel | None = None) -> Diagnostic:
    with pytest.raises(LawError) as caught:
        _servo(law, robot)
    return caught.value.diagnostic


# --- what a law is given


def test_a_law_is_given_the_payload() -> None:
    law = _law("for k in range(10):\n    state[k, 0] = load[k]", LawTraits(state_names=tuple("abcdefghij")))
    about_origin = BOX.inertia + BOX.mass * (BOX.com @ BOX.com * np.eye(3) - np.outer(BOX.com, BOX.com))
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = about_origin
    expected = [BOX.mass, *(BOX.mass * BOX.com), xx, yy, zz, xy, xz, yz]
    np.testing.assert_allclose(_after(_servo(law), 1, BOX).law[:, 0], expected, rtol=1e-15)


def test_a_law_is_given_the_torques_of_the_drives() -> None:
    law = _law("state[0, 0] = meas[2, 0]\nstate[0, 1] = meas[2, 1]", LawTraits(state_names=("tau",)))
    np.testing.assert_allclose(_after(_servo(law), 1).law[0], gravity(_arm(), np.zeros(2)), rtol=1e-12)


def test_a_law_is_given_the_signals_that_it_names_tick_by_tick() -> None:
    law = _law("state[0, 0] += aux[0]\nstate[0, 1] = aux[1]", LawTraits(state_names=("sum",), aux=("a", "b")))
    aux = np.array([[1.0, 10.0], [2.0, 20.0], [4.0, 30.0]])
    assert _after(_servo(law), 3, aux=aux).law[0].tolist() == [7.0, 30.0]


class Watching:
    """A law in Python that keeps what it is given."""

    traits = LawTraits(state_names=("count",), aux=("a",))

    def __init__(self) -> None:
        self.given: list[LawInput] = []

    def step(self, now: LawInput, state: Array, /) -> Array:
        self.given.append(now)
        state[0] += 1.0
        return np.zeros(2)


def test_a_law_in_python_is_given_the_same() -> None:
    law = Watching()
    after = _after(_servo(law), 3, BOX, np.array([[1.0], [2.0], [4.0]]))
    assert [now.aux.tolist() for now in law.given] == [[1.0], [2.0], [4.0]]
    assert [now.time for now in law.given] == [0.0, 0.001, 0.002]
    assert law.given[0].payload == BOX
    np.testing.assert_allclose(law.given[0].meas[2], gravity(_arm(), np.zeros(2), BOX), rtol=1e-12)
    assert after.law[0].tolist() == [3.0, 3.0]


# --- what a law remembers


def test_a_law_in_python_goes_on_from_any_state() -> None:
    """What it remembers is in the state, so a run can be taken up anywhere, and again."""
    robot, model = puma()
    servo = Servo.build(robot, model, CascadeInPython(model, robot))
    reference = quintic(START, GOAL, 60)
    start = servo.initial_state(START)
    half = servo.run(start, part(reference, 0, 30), Payload(), servo.recorder(start))
    ends = [servo.run(half, part(reference, 30, 60), Payload(), servo.recorder(half)) for _ in range(2)]
    whole = servo.run(start, reference, Payload(), servo.recorder(start))
    for end in ends:
        np.testing.assert_array_equal(end.values, whole.values)


# --- delay


@pytest.mark.parametrize("delay", [1, 2, 5])
def test_a_delayed_output_acts_so_many_ticks_later(delay: int) -> None:
    """A law that counts ticks: what the amplifier puts out is the count of `delay` ticks before."""
    body = "state[0, 0] += 1.0\nout[0] = state[0, 0]\nout[1] = state[0, 0]"
    servo = _servo(_law(body, LawTraits(state_names=("count",), delay=delay)))
    start = servo.initial_state(np.zeros(2))
    recorder = servo.recorder(start)
    servo.run(start, standing(np.zeros(2), 9), Payload(), recorder)
    volts = recorder.channels()["voltage"][1:, 0]
    held = start.output[0]
    assert volts.tolist() == pytest.approx([*[held] * delay, *range(1, 10 - delay)])


def test_a_delayed_law_holds_the_arm_from_the_first_tick() -> None:
    robot, model = puma()
    law = cascaded_p_pi(model, robot)
    late = replace(law, traits=replace(law.traits, delay=1))
    servo = Servo.build(robot, model, late, Engine.PYTHON)
    start = servo.initial_state(START)
    after = servo.run(start, standing(START, 40), Payload(), servo.recorder(start))
    np.testing.assert_allclose(after.q, START, rtol=0, atol=1e-9)


def test_slices_of_any_length_give_a_delayed_law_the_same_bits() -> None:
    robot, model = puma()
    law = cascaded_p_pi(model, robot)
    servo = Servo.build(robot, model, replace(law, traits=replace(law.traits, delay=3)), Engine.PYTHON)
    reference = quintic(START, GOAL, 20)
    start = servo.initial_state(START)
    whole = servo.run(start, reference, Payload(), servo.recorder(start))
    state = start
    for first in (0, 2, 9):
        last = {0: 2, 2: 9, 9: 20}[first]
        state = servo.run(state, part(reference, first, last), Payload(), servo.recorder(state))
    np.testing.assert_array_equal(state.values, whole.values)


# --- what does not fit


def test_a_law_of_voltages_does_not_drive_a_motor_of_torques() -> None:
    robot = replace(robots.load("two_link"), drives=(ideal_drive(), ideal_drive()))
    found = _found(_law("out[:] = 0.0", LawTraits(u_kind=InputKind.VOLTAGE)), robot)
    assert (found.code, "joint `1` takes effort" in found.message) == ("C602", True)
    _servo(_law("out[:] = 0.0", LawTraits(u_kind=InputKind.EFFORT)), robot)


@pytest.mark.parametrize(
    ("traits", "told"),
    [
        (LawTraits(hold_row=0), "names row 0 as `hold_row`, but has 0 rows"),
        (LawTraits(state_names=("a",), hold_row=-1), "names row -1"),
        (LawTraits(delay=-1), "has a delay of -1"),
        (LawTraits(delay=1001), "has a delay of 1001"),
        (LawTraits(delay=HALF), "has a delay of 0.5"),
    ],
)
def test_traits_that_cannot_be_are_refused(traits: LawTraits, told: str) -> None:
    found = _found(_law("out[:] = 0.0", traits))
    assert found.code == "C602"
    assert told in found.message


# --- what a law does wrong


@pytest.mark.parametrize(
    ("body", "told"),
    [
        ("out[5] = 0.0", "IndexError"),
        ("state[0, 0] = 1.0", "IndexError"),
        ("out[0] = meas[3, 0]", "IndexError"),
        ("out[0] = aux[0]", "IndexError"),
        ("out[0] = 1.0 / 0.0", "ZeroDivisionError"),
        ("out[0] = unknown", "NameError"),
        ("raise ValueError('no')", "ValueError: no"),
        ("out[0] = math.nan", "puts out `[nan, 0.0]`"),
        ("out[0] = math.sqrt(-1.0)", "ValueError"),
        ("this is no Python", "no Python: SyntaxError"),
    ],
)
def test_a_law_that_fails_at_rest_is_told_before_the_run(body: str, told: str) -> None:
    found = _found(_law(body))
    assert found.code == "C601"
    assert told in found.message
    assert "law(par, state, ref, meas, load, aux, out)" in (found.hint or "")


def test_a_source_without_a_law_is_told() -> None:
    found = _found(CompiledLaw("own", "def lore(par):\n    pass\n", (), np.zeros((0, 2))))
    assert "defines no function `law`" in found.message


@pytest.mark.parametrize("arguments", ["par, state, ref, meas, voltage", "par, state, ref, meas"])
def test_another_signature_is_told_with_the_right_one(arguments: str) -> None:
    found = _found(CompiledLaw("own", f"def law({arguments}):\n    pass\n", (), np.zeros((0, 2))))
    assert found.code == "C601"
    assert "load, aux, out" in (found.hint or "")


LATE = "state[0, 0] += 1.0\nout[int(state[0, 0]) - 1] = 0.0"


@pytest.mark.parametrize("engine", Engine)
def test_an_index_that_runs_away_ends_the_run_and_not_the_process(engine: Engine) -> None:
    servo = _servo(_law(LATE, LawTraits(state_names=("count",))), engine=engine)
    start = servo.initial_state(np.zeros(2))
    assert servo.run(start, standing(np.zeros(2), 2), Payload(), servo.recorder(start)).tick == 2
    with pytest.raises(LawError) as caught:
        servo.run(start, standing(np.zeros(2), 50), Payload(), servo.recorder(start))
    assert caught.value.diagnostic.code == "C601"
    assert "line 3, `out[int(state[0, 0]) - 1] = 0.0`" in caught.value.diagnostic.message


@pytest.mark.parametrize("engine", Engine)
@pytest.mark.parametrize("value", ["-math.inf", "math.inf", "math.nan"])
def test_an_output_that_is_not_finite_ends_the_run_at_its_tick(value: str, engine: Engine) -> None:
    body = f"state[0, 0] += 1.0\nout[1] = 1.0\nout[0] = {value} if state[0, 0] == 4.0 else 1.0"
    servo = _servo(_law(body, LawTraits(state_names=("count",))), engine=engine)
    start = servo.initial_state(np.zeros(2))
    with pytest.raises(DivergedError) as caught:
        servo.run(start, standing(np.zeros(2), 30), Payload(), servo.recorder(start))
    assert caught.value.diagnostic.data["tick"] == 4
    assert "output of the joint controller of joint" in caught.value.diagnostic.message


@pytest.mark.slow
def test_a_law_that_python_takes_and_the_compiler_does_not_is_told() -> None:
    body = "found = [1.0]\nfound.append('y')\nout[0] = 0.0"
    with pytest.raises(LawError) as caught:
        _servo(_law(body, n=1), random_arm(3, "R", (drive(),)), Engine.NUMBA)
    assert caught.value.diagnostic.code == "C601"
    assert "line 3, `found.append('y')`" in caught.value.diagnostic.message
