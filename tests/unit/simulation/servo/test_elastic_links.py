"""Links that yield at their drives: two masses, a beam, sag, the motor side, files."""

from collections.abc import Callable
from dataclasses import replace
from math import cos, pi, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim import robots
from ropsim.codegen import Engine, load
from ropsim.controller import LawInput
from ropsim.core import SourceText
from ropsim.dynamics import arm_numbers, drive_fault, gravity, structure_of
from ropsim.model import (
    Drive,
    EffortAmplifier,
    ElasticGear,
    Gear,
    IdealMotor,
    LinkElasticity,
    Payload,
    Rates,
    RobotModel,
)
from ropsim.nirox import read_nirox, write_nirox
from ropsim.robotfile import read_robot_file, write_robot_file
from ropsim.simulation import Servo, linear_loop, natural_modes
from ropsim.simulation.testing import fastest_pole, plant_code
from ropsim.spatial import Array
from support.arms import one_axis
from support.cylinders import DRIVE, lifted
from support.hydraulic_arm import hydraulic_arm
from support.servo_cases import CascadeInPython, puma, standing

STIFFNESS, MOTOR, RATIO, LINK = 4e3, 1e-4, 50.0, 0.6
HUB = MOTOR * RATIO**2
YIELDING = Drive(EffortAmplifier(), IdealMotor(MOTOR), Gear(RATIO), link=LinkElasticity(STIFFNESS))
SAGGING = Drive(EffortAmplifier(), IdealMotor(0.02), Gear(100.0), link=LinkElasticity(2e5, 300.0, 2.0))
"""Of a link that gravity bends down by its own weight."""


def slopes_of(robot: RobotModel) -> Callable[[float, Array], Array]:
    """Return the rates of the state of an arm that no command drives."""
    code = plant_code(structure_of(robot))
    (source,) = (one for one in code.functions if one.name == "derivative")
    function, numbers = load("slopes", (source,), Engine.PYTHON), code.constants(arm_numbers(robot))

    def rates(_: float, x: Array) -> Array:
        dx = np.empty(len(x))
        function(x.copy(), np.zeros(robot.n), numbers, dx)
        return dx

    return rates


def frequencies(robot: RobotModel, held: bool) -> Array:
    """Return the frequencies of an axis without gravity [rad/s]; with its hub held or free."""
    rates, size = slopes_of(robot), 4
    A = np.column_stack([rates(0.0, one) for one in np.eye(size)])  # without gravity it is linear
    free = A[np.ix_([0, 1], [0, 1])] if held else A
    found = np.abs(np.linalg.eigvals(free).imag)
    return np.asarray(np.sort(found[found > 1e-9]))


def test_two_masses_swing_against_each_other() -> None:
    """ω² = k·(1/J + 1/M) with a free hub, k/M with a held one."""
    robot = one_axis(YIELDING, LINK)
    expected = sqrt(STIFFNESS * (1.0 / HUB + 1.0 / LINK))
    assert frequencies(robot, held=False)[-1] == pytest.approx(expected, rel=1e-9)
    assert frequencies(robot, held=True)[-1] == pytest.approx(sqrt(STIFFNESS / LINK), rel=1e-9)
    assert fastest_pole(robot) == pytest.approx(expected, rel=1e-6)


def test_a_hub_of_its_own_adds_to_the_rotor() -> None:
    own = replace(YIELDING, link=LinkElasticity(STIFFNESS, 0.0, 0.4))
    expected = sqrt(STIFFNESS * (1.0 / (HUB + 0.4) + 1.0 / LINK))
    assert frequencies(one_axis(own, LINK), held=False)[-1] == pytest.approx(expected, rel=1e-9)


def test_behind_a_rigid_gear_it_is_an_elastic_gear() -> None:
    """The same equations with other names: hub coordinate and speed are those of the motor over G."""
    gear = replace(YIELDING, transmission=ElasticGear(RATIO, STIFFNESS, 3.0), link=None)
    link = replace(YIELDING, link=LinkElasticity(STIFFNESS, 3.0))
    begin = np.array([0.02, -0.3, 0.05, 0.1])
    one, other = (slopes_of(one_axis(each, LINK))(0.0, begin) for each in (gear, link))
    np.testing.assert_allclose(one, other, rtol=1e-12)


def test_a_twist_swings_as_the_closed_form_of_two_masses_with_a_damper() -> None:
    """Of a free pair the relative angle is e^{-δt}·cos(ω_d·t), the other part keeps its momentum."""
    robot = one_axis(replace(YIELDING, link=LinkElasticity(STIFFNESS, 4.0)), LINK)
    reduced = 1.0 / (1.0 / HUB + 1.0 / LINK)
    fade, twist = 0.5 * 4.0 / reduced, 1e-3
    swing = sqrt(STIFFNESS / reduced - fade**2)
    begin = np.array([0.0, 0.0, twist, 0.0])
    found = solve_ivp(slopes_of(robot), (0.0, 0.1), begin, rtol=1e-10, atol=1e-13)
    end = found.y[:, -1]
    expected = twist * np.exp(-fade * 0.1) * (cos(swing * 0.1) + fade / swing * np.sin(swing * 0.1))
    assert end[2] - end[0] == pytest.approx(expected, abs=1e-10)
    assert HUB * end[3] + LINK * end[1] == pytest.approx(0.0, abs=1e-9)


def test_a_beam_with_a_weight_at_its_tip_swings_and_sags_as_one_clamped() -> None:
    """K = 3·E·I/L: ω = √(3·E·I/(m·L³)) and F·L³/(3·E·I); steel tube 60 × 4 mm, 1.2 m, 8 kg."""
    length, weight = 1.2, 8.0
    bending = 2.1e11 * pi / 64.0 * (0.06**4 - 0.052**4)
    link = LinkElasticity(3.0 * bending / length, 0.0, 1.0)
    robot = one_axis(replace(YIELDING, link=link), weight * length**2)
    expected = sqrt(3.0 * bending / (weight * length**3))
    assert frequencies(robot, held=True)[-1] == pytest.approx(expected, rel=1e-9)
    assert weight * 9.81 * length / link.stiffness * length == pytest.approx(
        weight * 9.81 * length**3 / (3.0 * bending)
    )


def held_axis() -> tuple[RobotModel, Servo]:
    robot = lifted(SAGGING)
    return robot, Servo.build(robot, robots.default_controller(robot, Rates(1000)))


def test_a_load_bends_the_link_down_and_the_motor_does_not_see_it() -> None:
    """Sag τ/k below the reference, from the start on; the hub stays where it is told."""
    robot, servo = held_axis()
    load = Payload(40.0, np.array([2.0, 0.0, 0.0]))
    reference = np.array([0.3])
    start = servo.initial_state(reference, load)
    recorder = servo.recorder(start)
    end = servo.run(start, standing(reference, 1500), load, recorder)
    for state in (start, end):
        sag = gravity(robot, state.q, load)[0] / 2e5
        assert sag > 5e-3
        assert reference[0] - state.q[0] == pytest.approx(sag, rel=1e-3)
        assert state.drive("hub_coordinate")[0] == pytest.approx(reference[0], abs=1e-6)
        np.testing.assert_array_equal(state.sensed[0], state.drive("hub_coordinate"))
    assert recorder.channels()["hub_coordinate"].shape == (1501, 1)


def test_a_law_in_python_is_given_the_motor_side() -> None:
    robot, model = puma()
    soft = [replace(one, link=LinkElasticity(2e4, 20.0)) for one in robot.drives[:3]]
    arm, seen = replace(robot, drives=(*soft, *robot.drives[3:])), list[Array]()

    class Watching(CascadeInPython):
        """Keeps what it is given."""

        def step(self, now: LawInput, state: Array, /) -> Array:
            seen.append(now.meas[0].copy())
            return CascadeInPython.step(self, now, state)

    servo = Servo.build(arm, model, Watching(model, arm))
    start = servo.initial_state(arm.home)
    servo.run(start, standing(arm.home, 3), Payload(), servo.recorder(start))
    np.testing.assert_array_equal(seen[0][:3], start.drive("hub_coordinate"))
    assert np.abs(start.q - arm.home).max() > 1e-4
    np.testing.assert_allclose(seen[0], arm.home, atol=1e-12)


def test_the_mode_of_the_link_shows_in_the_linear_loop() -> None:
    """Near √(k/M) of the link behind a motor that its loop holds."""
    robot, _ = held_axis()
    controller = robots.default_controller(robot, Rates(1000))
    hz, damping = natural_modes(linear_loop(robot, controller, np.array([0.3]), Payload()))
    soft = 1.0 / (2.0 * pi) * sqrt(2e5 / 284.0)
    near = hz[(hz > 0.5 * soft) & (hz < 1.6 * soft) & (damping < 0.5)]
    assert len(near) >= 1


def test_a_stiff_link_moves_as_a_rigid_one() -> None:
    stiff = replace(SAGGING, link=LinkElasticity(2e9, 1e4, 0.5))
    rigid = replace(SAGGING, motor=IdealMotor(0.02 + 0.5 / 100.0**2), link=None)
    ends = []
    for drive in (stiff, rigid):
        robot = lifted(drive)
        servo = Servo.build(robot, robots.cascaded_controller(robot, Rates(1000, plant_steps=40)))
        start = servo.initial_state(np.array([0.3]))
        reference = standing(np.array([0.31]), 300)
        ends.append(servo.run(start, reference, Payload(), servo.recorder(start)).q[0])
    assert ends[0] == pytest.approx(ends[1], abs=3e-6)


def test_cylinders_move_elastic_links_too() -> None:
    """Before the boom of a cylinder, whose rod and piston are its hub."""
    robot = lifted(replace(DRIVE, link=LinkElasticity(4e5, 400.0, 5.0)))
    servo = Servo.build(robot, robots.default_controller(robot, Rates(1000)))
    start = servo.initial_state(np.array([0.3]))
    end = servo.run(start, standing(np.array([0.3]), 1000), Payload(), servo.recorder(start))
    sag = gravity(robot, end.q)[0] / 4e5
    assert end.drive("hub_coordinate")[0] - end.q[0] == pytest.approx(sag, rel=1e-3)
    assert abs(end.drive("hub_coordinate")[0] - 0.3) < 1e-3


def test_a_hub_needs_an_inertia() -> None:
    idle = replace(YIELDING, motor=IdealMotor(0.0))
    fault = drive_fault(idle)
    assert fault is not None
    assert fault[0] == "`hub_inertia`"
    assert drive_fault(replace(idle, link=LinkElasticity(STIFFNESS, 0.0, 1e-3))) is None
    twice = replace(YIELDING, transmission=ElasticGear(RATIO, STIFFNESS))
    assert drive_fault(twice) is not None
    assert drive_fault(replace(YIELDING, link=LinkElasticity(-1.0))) is not None


def test_files_keep_elastic_links() -> None:
    links = LinkElasticity(1.5e5, 80.0, 0.7), LinkElasticity(9e4)
    arm = hydraulic_arm()
    drives = [replace(drive, link=link) for drive, link in zip(arm.drives, links, strict=True)]
    robot = replace(arm, drives=tuple(drives))
    text = write_robot_file(robot).text
    again = read_robot_file(SourceText("robots/arm.toml", text))
    assert again.robot is not None, again.findings
    assert tuple(one.link for one in again.robot.drives) == links
    assert write_robot_file(again.robot).text == text
    read = read_nirox(SourceText("arm.stp", write_nirox(robot).text))
    assert read.robot is not None, read.findings
    assert tuple(one.link for one in read.robot.drives) == links


TEXT = """
convention = "standard"
joints = [{ a = 1000, limits = [-90, 90], speed = 60 }]
links = [{ mass = 10, com = [-500, 0, 0], inertia = [0.1, 1, 1, 0, 0, 0] }]

[[drives]]
kind = "servo"
ratio = 50
link_stiffness = 1e4
hub_inertia = 0.1
"""


@pytest.mark.parametrize("gone", ["hub_inertia = 0.1\n", "link_stiffness = 1e4\n"])
def test_a_file_with_nothing_to_turn_its_hub_is_refused_where_it_stands(gone: str) -> None:
    assert read_robot_file(SourceText("robots/arm.toml", TEXT)).robot is not None
    read = read_robot_file(SourceText("robots/arm.toml", TEXT.replace(gone, "")))
    assert read.robot is None
    (found,) = read.findings
    assert gone.split(maxsplit=1)[0] in found.message
    assert found.span is not None
