"""What laws read of their drives, and what they know of their arm."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, LawError, LawInput, LawTraits, law_model
from ropsim.core import Diagnostic
from ropsim.dynamics import inverse_dynamics, mass_matrix
from ropsim.model import Drive, ElasticGear, Friction, Payload, RobotModel
from ropsim.simulation import Servo, ServoState, linear_loop
from ropsim.spatial import Array
from support.arms import drive, random_arm
from support.hydraulic_arm import hydraulic_arm
from support.servo_cases import controller, standing

PRESSURES = ("pressure_a", "pressure_b", "opening")
AREAS = [np.pi * 0.02**2, np.pi * 0.016**2]
PLACE = np.array([0.7, -1.6])
BOX = Payload(3.0, np.array([0.1, 0.0, 0.05]), np.diag([0.01, 0.02, 0.015]))
MOTION = np.array([[0.7, -1.6], [0.4, -0.3], [1.5, 2.0]])


def elastic(ratio: float = 50.0) -> Drive:
    return replace(drive(), transmission=ElasticGear(ratio, 2e4, 5.0))


def _after(law: Any, robot: RobotModel, engine: Engine = Engine.PYTHON, ticks: int = 3) -> ServoState:
    servo = Servo.build(robot, controller(robot.n), law, engine)
    start = servo.initial_state(PLACE, BOX)
    return servo.run(start, standing(PLACE, ticks), BOX, servo.recorder(start))


def _law(text: str, states: tuple[str, ...], **more: Any) -> CompiledLaw:
    traits = more.pop("traits", LawTraits())
    traits = replace(traits, state_names=states)
    return CompiledLaw("own", text, (), np.zeros((0, 2)), traits, **more)


def _found(law: CompiledLaw, robot: RobotModel) -> Diagnostic:
    with pytest.raises(LawError) as caught:
        _after(law, robot)
    return caught.value.diagnostic


READING = """\
def law(state, sensed, out):
    for j in range(out.shape[0]):
        state[a, j] = sensed[pressure_a, j]
        state[b, j] = sensed[pressure_b, j]
        state[x, j] = sensed[opening, j]
        out[j] = 0.001
"""


class Reading:
    """A law in Python that keeps what it is given."""

    traits = LawTraits(state_names=("a", "b", "x"), sensed=PRESSURES)

    def __init__(self) -> None:
        self.given: list[LawInput] = []

    def step(self, now: LawInput, state: Array, /) -> Array:
        self.given.append(now)
        state[:] = now.sensed
        return np.full(2, 0.001)


@pytest.mark.parametrize("engine", [Engine.PYTHON, Engine.NUMBA])
def test_a_law_reads_the_states_of_drives_that_it_names(engine: Engine) -> None:
    law = _law(READING, ("a", "b", "x"), traits=LawTraits(sensed=PRESSURES))
    before, after = (_after(law, hydraulic_arm(), engine, ticks) for ticks in (2, 3))
    np.testing.assert_array_equal(after.law, [before.drive(name) for name in PRESSURES])
    assert np.abs(after.law[2]).min() > 0.0


def test_a_law_in_python_reads_the_same() -> None:
    compiled = _after(_law(READING, ("a", "b", "x"), traits=LawTraits(sensed=PRESSURES)), hydraulic_arm())
    law = Reading()
    np.testing.assert_array_equal(_after(law, hydraulic_arm()).values, compiled.values)
    np.testing.assert_allclose(law.given[0].model.drive("area_a"), AREAS, rtol=1e-14)


def test_a_law_reads_the_motor_side_of_elastic_gears() -> None:
    robot = random_arm(3, "RR", (elastic(), elastic()))
    text = "def law(state, sensed, out):\n    state[theta] = sensed[motor_coordinate]\n    out[:] = 1.0\n"
    law = _law(text, ("theta",), traits=LawTraits(sensed=("motor_coordinate",)))
    np.testing.assert_array_equal(
        _after(law, robot).law[0], _after(law, robot, ticks=2).drive("motor_coordinate")
    )


def test_a_drive_without_what_a_law_reads_is_refused() -> None:
    law = _law(READING, ("a", "b", "x"), traits=LawTraits(sensed=PRESSURES))
    found = _found(law, random_arm(3, "RR", (drive(), drive())))
    assert found.code == "C602"
    assert "reads `pressure_a`" in found.message
    assert "`current`" in found.message
    mixed = replace(hydraulic_arm(), drives=(hydraulic_arm().drives[0], drive()))
    assert _found(law, mixed).code == "C602"
    partly = _law(READING, ("a", "b", "x"), traits=LawTraits(sensed=PRESSURES, sensed_axes=(0,)))
    after = _after(partly, mixed)
    assert after.law[0, 0] > 0.0 == after.law[0, 1]


KNOWING = """\
def law(par, state, ref, drive, model, work, load, out):
    for k in range(3):
        for j in range(out.shape[0]):
            work[k, j] = par[k, j]
    inverse(model, work[0], work[1], work[2], load, work[tau])
    inertias(model, work[0], load, work[inertia])
    transmission(model, work[0], work[ratio], work[slope], work[place])
    for j in range(out.shape[0]):
        state[0, j] = work[tau, j]
        state[1, j] = work[ratio, j]
        state[2, j] = work[slope, j]
        state[3, j] = work[place, j]
        state[4, j] = drive[area_a, j]
        state[5, j] = drive[supply_pressure, j]
        state[6, j] = work[inertia, j]
        out[j] = 0.0
"""
WORK = ("q", "qd", "qdd", "tau", "ratio", "slope", "place", "inertia")


def _knowing(believed: RobotModel) -> CompiledLaw:
    names = ("at", "speed", "acceleration")
    traits = LawTraits(state_names=("tau", "ratio", "slope", "place", "area", "supply", "inertia"))
    model = law_model(believed)
    return CompiledLaw("knowing", KNOWING, names, MOTION, traits, model=model, work_names=WORK)


@pytest.mark.parametrize("engine", [Engine.PYTHON, Engine.NUMBA])
def test_a_law_knows_the_equations_of_motion_with_its_load(engine: Engine) -> None:
    robot = hydraulic_arm()
    found = _after(_knowing(robot), robot, engine, 1).law
    np.testing.assert_allclose(found[0], inverse_dynamics(robot, *MOTION, payload=BOX), rtol=1e-12)
    diagonal = np.diagonal(mass_matrix(robot, MOTION[0], BOX))
    np.testing.assert_allclose(found[6], diagonal, rtol=1e-12)
    np.testing.assert_array_equal(law_model(robot).inertias(MOTION[0], BOX), diagonal)
    np.testing.assert_allclose(
        law_model(robot).inverse(MOTION[0], MOTION[1], MOTION[2], BOX), found[0], rtol=1e-12
    )


def test_a_law_knows_the_levers_of_cylinders_and_the_numbers_of_the_drives() -> None:
    robot, small = hydraulic_arm(), 1e-6
    found, model = _after(_knowing(robot), robot, ticks=1).law, law_model(robot)
    np.testing.assert_allclose(model.transmission(MOTION[0]), found[1:4], rtol=1e-12)
    (_, _, more), (_, _, less) = (model.transmission(MOTION[0] + h) for h in (small, -small))
    np.testing.assert_allclose((more - less) / (2.0 * small), found[1], rtol=1e-8)
    (more, _, _), (less, _, _) = (model.transmission(MOTION[0] + h) for h in (small, -small))
    np.testing.assert_allclose((more - less) / (2.0 * small), found[2], rtol=1e-8)
    np.testing.assert_allclose(found[4], AREAS, rtol=1e-14)
    np.testing.assert_array_equal(model.drive("area_a"), found[4])
    assert found[5].tolist() == [140e5, 140e5]
    with pytest.raises(KeyError):
        model.drive("resistance")


def test_a_law_knows_the_ratios_of_gears() -> None:
    robot = random_arm(3, "RR", (drive(ratio=120.0), elastic(ratio=-40.0)))
    found = _after(
        replace(
            _knowing(robot),
            source=KNOWING.replace("area_a", "resistance").replace("supply_pressure", "sense"),
        ),
        robot,
        ticks=1,
    ).law
    np.testing.assert_allclose(found[1:4], [[120.0, -40.0], [0.0, 0.0], [84.0, 64.0]], rtol=1e-12)
    assert found[5].tolist() == [1.0, -1.0]


def test_a_law_may_believe_in_another_arm() -> None:
    robot = hydraulic_arm()
    believed = replace(robot, drives=tuple(replace(one, friction=Friction()) for one in robot.drives))
    found = _after(_knowing(believed), robot, ticks=1).law
    np.testing.assert_allclose(found[0], inverse_dynamics(believed, *MOTION, payload=BOX), rtol=1e-12)
    assert np.abs(found[0] - inverse_dynamics(robot, *MOTION, payload=BOX)).min() > 1.0


def test_an_argument_that_no_law_has_is_refused_by_name() -> None:
    found = _found(_law("def law(state, pressure, out):\n    out[:] = 0.0\n", ()), hydraulic_arm())
    assert found.code == "C601"
    assert "argument `pressure`" in found.message
    assert "sensed" in found.message


def test_seven_arguments_may_have_names_of_their_own() -> None:
    text = "def law(p, s, r, m, l, a, u):\n    s[0] = m[0]\n    u[:] = 0.0\n"
    np.testing.assert_array_equal(_after(_law(text, ("q",)), hydraulic_arm(), ticks=1).law[0], PLACE)


def test_the_loop_about_a_rest_has_what_a_law_reads() -> None:
    """Force feedback by pressures is feedback of the torque of the drive over its lever."""
    robot = hydraulic_arm()
    by_pressure = """\
def law(ref, meas, sensed, drive, out):
    for j in range(out.shape[0]):
        force = drive[area_a, j] * sensed[pressure_a, j] - drive[area_b, j] * sensed[pressure_b, j]
        out[j] = drive[sense, j] * (0.1 * (ref[0, j] - meas[0, j]) - 1e-6 * force)
"""
    by_torque = """\
def law(ref, meas, model, work, drive, out):
    transmission(model, meas[0], work[ratio], work[slope], work[place])
    for j in range(out.shape[0]):
        force = meas[2, j] / work[ratio, j]
        out[j] = drive[sense, j] * (0.1 * (ref[0, j] - meas[0, j]) - 1e-6 * force)
"""
    model, traits = law_model(robot), LawTraits(sensed=("pressure_a", "pressure_b"))
    laws = (
        _law(by_pressure, (), traits=traits, model=model),
        _law(by_torque, (), model=model, work_names=("ratio", "slope", "place")),
    )
    one, other = (linear_loop(robot, controller(2), PLACE, BOX, law) for law in laws)
    size = np.abs(one.K).max(axis=0) + 1e-12
    np.testing.assert_allclose(other.K / size, one.K / size, atol=1e-5)
    assert np.abs(one.K[:, 4:]).max() > 0.0
