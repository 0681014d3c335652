"""Meant contacts act on the arm: statics, bounces, friction, and what does not change."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim import robots
from ropsim.controller import CompiledLaw, LawInput, LawTraits, PythonLaw
from ropsim.dynamics import inverse_dynamics
from ropsim.flow import Recording
from ropsim.kinematics import jacobian
from ropsim.model import (
    Box,
    Cell,
    Cylinder,
    Device,
    FixedObject,
    Gripper,
    MeantContact,
    Part,
    Shape,
    SwitchDrive,
    Tool,
)
from ropsim.simulation import Fidelity, RunOptions, run, run_collisions
from ropsim.spatial import Array, Pose
from support.cells import one_station, with_station
from support.compiled import code_of, station_code
from support.pressed import GRAVITY, MASS, PIN, RADIUS, contact, pressed_cell, springs

STIFFNESS = 1e5
SERVO = 2e4
"""Stiffness of both axes under the law of these tests [N/m]."""
HELD = springs(np.array([SERVO, SERVO]), np.array([400.0, 400.0]), MASS * GRAVITY)
LOOSE = springs(np.zeros(2), np.zeros(2))
"""No effort at all: what hangs falls."""


def ran(
    cell: Cell,
    *lines: str,
    law: CompiledLaw | PythonLaw | None = HELD,
    fidelity: Fidelity = Fidelity.DYNAMIC,
    step: float | None = None,
) -> Recording:
    options = RunOptions(fidelity, laws={"robot": law} if law else {}, longest_step=step, record_hz=1000)
    return run(cell, {"robot": code_of(cell, *lines)}, options)


def wrenches(recording: Recording) -> Array:
    return recording.rows("contact_wrench")


DOWN = ("mov joints(0, 9)", "wait 0.6 s")
"""The ball, whose radius is 10 mm, is sent 1 mm into the block."""


def test_the_static_force_is_that_of_contact_and_servo_in_series() -> None:
    recording = ran(pressed_cell(contact(STIFFNESS)), *DOWN)
    force, z = wrenches(recording)[-1][2], recording.rows("q")[-1][1]
    assert force == pytest.approx(STIFFNESS * (RADIUS - z), rel=1e-6)
    assert force == pytest.approx(1e-3 / (1.0 / STIFFNESS + 1.0 / SERVO), rel=0.01)


def test_efforts_of_the_drives_less_the_inverse_dynamics_are_the_wrench() -> None:
    """Newton at rest of a six-axis arm: what the drives bear beside gravity comes from the contact."""
    cell = _puma()
    recording = run(cell, {"robot": code_of(cell, *_PRESS)}, RunOptions())
    q, tau, qd = (recording.rows(name)[-1] for name in ("q", "tau", "qd"))
    robot, tool = cell.first.robot, cell.first.tools["pin"]
    zeros = np.zeros(robot.n)
    gravity = inverse_dynamics(robot, q, zeros, zeros, payload=tool.loads[0])
    friction = tau - gravity + jacobian(robot, q).T @ wrenches(recording)[-1]
    assert np.abs(qd).max() < 1e-5
    assert wrenches(recording)[-1][2] == pytest.approx(100.0, abs=1.0)
    assert np.abs(jacobian(robot, q).T @ wrenches(recording)[-1]).max() > 20.0
    assert np.abs(friction).max() < 1.0  # [N·m]


def test_a_falling_mass_bounces_as_a_mass_on_spring_and_damper() -> None:
    """Gravity, spring and damper in closed form; the law puts out nothing."""
    k, c, start = 5e4, 120.0, RADIUS + 0.01
    cell = pressed_cell(contact(k, c), start=(0.0, start), hz=10_000)
    recording = ran(cell, "wait 0.3 s", law=LOOSE)

    def rates(_: float, y: Array) -> list[float]:
        depth = RADIUS - y[0]
        force = max(k * depth - c * min(depth / 1e-5, 1.0) * y[1], 0.0) if depth > 0.0 else 0.0
        return [y[1], force / MASS - GRAVITY]

    times = recording.time
    exact = solve_ivp(
        rates, (0.0, float(times[-1])), [start, 0.0], t_eval=times, rtol=1e-9, atol=1e-12, max_step=1e-4
    )
    z = recording.rows("q")[:, 1]
    assert z.min() < RADIUS - 5e-4
    assert np.abs(z - exact.y[0]).max() < 2e-5


@pytest.mark.parametrize("damping", [10.0, 50.0, 200.0])
def test_no_bounce_is_higher_than_the_one_before(damping: float) -> None:
    """At 1 kHz also with 1 % of the critical damping: the holding of the force adds less than that takes."""
    cell = pressed_cell(contact(STIFFNESS, damping), start=(0.0, RADIUS + 5e-3))
    z, speed = (ran(cell, "wait 2 s", law=LOOSE).rows(name)[:, 1] for name in ("q", "qd"))
    tops = [z[0], *(z[k] for k in range(1, len(z) - 1) if speed[k - 1] > 0.0 >= speed[k] and z[k] > RADIUS)]
    assert all(after <= before + 1e-5 for before, after in pairwise(tops))
    assert len(tops) > 1


def test_a_stiff_contact_at_rest_stays_at_rest() -> None:
    cell = pressed_cell(contact(4e5, 400.0), solid=PIN)
    recording = ran(cell, "mov joints(0, 9.8)", "wait 1 s")
    late = recording.time > recording.time[-1] - 0.3
    assert np.ptp(wrenches(recording)[late, 2]) < 1e-6 * wrenches(recording)[-1, 2]


def test_sliding_friction_is_mu_times_the_normal_force() -> None:
    cell = pressed_cell(contact(STIFFNESS, 500.0, 0.3), solid=PIN)
    recording = ran(cell, "mov joints(0, 9)", "wait 0.3 s", "mov joints(200, 9)", law=HELD)
    qd = recording.rows("qd")[:, 0]
    sliding = wrenches(recording)[qd > 0.05]
    assert len(sliding) > 100
    assert -sliding[:, 0] == pytest.approx(0.3 * sliding[:, 2], rel=0.02)


@pytest.mark.parametrize("damping", [10.0, 200.0, 1500.0])
def test_friction_of_a_slow_slide_is_full_whatever_the_damping(damping: float) -> None:
    """At 1 kHz friction of 5 N stops the 3 kg in a tick from 1.7 mm/s; 10 mm/s are 0.2 % of the most."""
    cell = pressed_cell(contact(STIFFNESS, damping, 0.3), solid=PIN)
    recording = ran(cell, "mov joints(0, 9)", "wait 0.3 s", "mov joints(10, 9) speed 0.2 %")
    sliding = wrenches(recording)[np.abs(recording.rows("qd")[:, 0] - 0.01) < 1e-3]
    assert len(sliding) > 300
    assert -sliding[:, 0] == pytest.approx(0.3 * sliding[:, 2], rel=0.02)


def test_a_recording_does_not_depend_on_how_the_reference_is_sliced() -> None:
    cell = pressed_cell(contact(STIFFNESS, 500.0, 0.3), solid=PIN)
    lines = ("mov joints(0, 9)", "lin (30, 0, 9) speed 50 mm/s", "mov joints(30, 40)")
    whole, cut = ran(cell, *lines), ran(cell, *lines, step=7e-3)
    for name in ("q", "qd", "tau", "contact_wrench"):
        assert np.array_equal(whole.rows(name), cut.rows(name)), name
    assert np.abs(wrenches(whole)).max() > 1.0


def test_a_contact_that_is_never_touched_changes_no_bit() -> None:
    free, near = pressed_cell(), pressed_cell(contact(STIFFNESS))
    lines = ("mov joints(100, 60)", "mov joints(0, 12)", "wait 0.1 s")
    without, with_it = ran(free, *lines), ran(near, *lines)
    for name in without.channels:
        assert np.array_equal(without.rows(name), with_it.rows(name), equal_nan=True), name
    assert not wrenches(with_it).any()
    assert "contact_wrench" not in without.channels


def test_a_kinematic_run_has_the_force_of_the_geometry_and_is_not_moved() -> None:
    recording = ran(pressed_cell(contact(STIFFNESS)), *DOWN, law=None, fidelity=Fidelity.KINEMATIC)
    assert recording.rows("q")[-1] == pytest.approx([0.0, 9e-3], abs=1e-12)
    assert wrenches(recording)[-1] == pytest.approx([0.0, 0.0, STIFFNESS * 1e-3, 0.0, 0.0, 0.0], abs=1e-6)


class SpringsInPython:
    """`HELD` once more, as a Python object."""

    traits = LawTraits()

    def step(self, now: LawInput, state: Array, /) -> Array:
        del state
        lift = np.array([0.0, MASS * GRAVITY])
        return np.asarray(SERVO * (now.ref[0] - now.meas[0]) - 400.0 * now.meas[1] + lift)


def test_a_law_in_python_feels_the_contact_as_a_compiled_one_does() -> None:
    cell = pressed_cell(contact(STIFFNESS))
    compiled, python = ran(cell, *DOWN), ran(cell, *DOWN, law=SpringsInPython())
    assert wrenches(python)[-1] == pytest.approx(wrenches(compiled)[-1], rel=1e-9, abs=1e-12)


def test_the_torque_that_a_law_measures_is_that_of_the_drives() -> None:
    """A law that puts out what it measured last, without contact and in it: nothing is added on the way."""
    recording = ran(pressed_cell(contact(STIFFNESS)), *DOWN)
    q, qd, tau, q_ref = (recording.rows(name)[-1] for name in ("q", "qd", "tau", "q_ref"))
    wanted = SERVO * (q_ref - q) - 400.0 * qd + np.array([0.0, MASS * GRAVITY])
    assert tau == pytest.approx(wanted, abs=1e-3)


def test_a_contact_deeper_than_meant_is_a_collision() -> None:
    meant = pressed_cell(contact(STIFFNESS))
    shallow = replace(meant, contacts=(replace(meant.contacts[0], depth=1e-4),))
    none = replace(meant, contacts=())
    for cell, collides in ((meant, False), (shallow, True), (none, True)):
        recording = ran(cell, *DOWN, law=None, fidelity=Fidelity.KINEMATIC)
        codes = [one.code for one in run_collisions(recording, cell).findings]
        assert codes == (["S751"] if collides else []), cell.contacts


def test_a_contact_that_the_control_rate_cannot_follow_is_told() -> None:
    """The bound is c + k·T/2 < 2·m/T: on 3 kg across and 2 kg down at 1 kHz, 4000 N·s/m."""
    for damping, told in ((3900.0, []), (4100.0, ["S775"])):
        found = ran(pressed_cell(contact(1e5, damping)), "wait 0.01 s").findings
        assert [one.code for one in found] == told


def test_each_of_two_stations_is_pushed_back_as_one_alone() -> None:
    alone = pressed_cell(contact(STIFFNESS))
    left = replace(alone.first, name="left")
    right = replace(left, name="right", X_WB=Pose(np.array([0.3, 0.0, 0.0])))
    cell = replace(alone, stations={"left": left, "right": right})
    second = ("wait 0.05 s", "mov joints(0, 8.5)", "wait 0.2 s")
    codes = {"left": station_code(cell, "left", *DOWN), "right": station_code(cell, "right", *second)}
    both = run(cell, codes, RunOptions(laws={"left": HELD, "right": HELD}, record_hz=1000))
    one = ran(alone, *DOWN)
    found = both.channels["left/contact_wrench"].values[: len(one.time)]
    assert np.array_equal(found, wrenches(one))
    force = both.channels["right/contact_wrench"].values[-1, 2]
    assert force == pytest.approx(1.5e-3 / (1.0 / STIFFNESS + 1.0 / SERVO), rel=0.01)


def test_an_arm_that_is_lost_in_a_contact_keeps_what_was_recorded() -> None:
    """The law puts out more than any number once the arm is pressed; the wrench has the rows of the arm."""
    source = HELD.source.replace("par[2, k]", "par[2, k] + (1e301 if 0.001 < meas[0, 1] < 0.0099 else 0.0)")
    lost = replace(HELD, name="lost", source=source)
    recording = ran(pressed_cell(contact(STIFFNESS)), *DOWN, law=lost)
    assert "S701" in [one.code for one in recording.findings]
    assert len(wrenches(recording)) == len(recording.time)
    assert np.isfinite(recording.rows("q")).all()
    assert 0.0 < wrenches(recording)[:, 2].max() < STIFFNESS * 1e-3
    assert recording.rows("q")[-1][1] < 0.0099


def _gripping(moving: str, standing: str) -> Cell:
    """Return a gantry with a gripper above a part that lies on the block."""
    cell = pressed_cell(start=(0.0, 0.02))
    tool = Tool(
        "tip",
        gripper=Gripper(0.1, 0.1, 5e-3),
        shapes=(Shape(Cylinder(0.005, 0.02), Pose(np.array([0.0, 0.0, 0.01]))),),
    )
    part = Part("cube", np.array([0.02, 0.02, 0.02]), 0.2, Pose(np.array([0.0, 0.0, 0.02])))
    meant = MeantContact("press", moving, (standing,), STIFFNESS, 200.0, 0.2, 5e-3)
    return replace(with_station(cell, tools={"tip": tool}), parts=(part,), contacts=(meant,))


def test_a_part_is_pushed_back_while_a_gripper_holds_it() -> None:
    cell = _gripping("cube", "block")
    lines = ("close", "mov joints(0, 40)", "mov joints(0, 19)", "wait 0.1 s", "open", "wait 0.1 s")
    recording = ran(cell, *lines, law=None, fidelity=Fidelity.KINEMATIC)
    force, gripper = wrenches(recording)[:, 2], recording.rows("gripper")
    assert force[gripper == 1.0][-1] == pytest.approx(STIFFNESS * 1e-3, rel=1e-6)
    assert force[gripper == 0.0][-1] == 0.0
    assert force[0] == 0.0


def test_a_tool_is_pushed_back_by_a_part_that_lies_and_not_by_the_one_it_holds() -> None:
    cell = _gripping("tip", "cube")
    pressing = ran(cell, "mov joints(0, 19)", "wait 0.1 s", law=None, fidelity=Fidelity.KINEMATIC)
    assert wrenches(pressing)[-1, 2] == pytest.approx(STIFFNESS * 1e-3, rel=1e-5)  # the edges are near
    held = ran(cell, "mov joints(0, 19)", "close", "mov joints(0, 40)", law=None, fidelity=Fidelity.KINEMATIC)
    assert wrenches(held)[-1].tolist() == [0.0] * 6


def test_a_device_stands_under_a_tool_and_pushes_back() -> None:
    belt = Device(
        "belt", robots.slide((Shape(Box((0.4, 0.2, 0.1)), Pose(np.array([0.0, 0.0, -0.05]))),)), _DOOR, Pose()
    )
    meant = MeantContact("press", "tip", ("belt",), STIFFNESS, 200.0)
    cell = replace(pressed_cell(meant, objects=()), devices={"belt": belt})
    recording = ran(cell, *DOWN, law=None, fidelity=Fidelity.KINEMATIC)
    assert wrenches(recording)[-1, 2] == pytest.approx(STIFFNESS * 1e-3, rel=1e-6)


_DOOR = SwitchDrive("", 0.0, 0.1, 1.0, 1.0)


def _puma() -> Cell:
    ROBOT = robots.load("puma560")
    table = FixedObject("table", Pose(np.array([0.5, 0.0, 0.05])), (Shape(Box((0.6, 1.0, 0.1))),))
    pose = Pose(np.array([0.0, 0.0, 0.05]))
    tool = Tool(
        "pin",
        Pose(np.array([0.0, 0.0, 0.1])),
        0.5,
        np.array([0.0, 0.0, 0.05]),
        np.eye(3) * 1e-3,
        shapes=(Shape(Cylinder(0.01, 0.1), pose),),
    )
    return one_station(
        "puma",
        ROBOT,
        robots.default_controller("puma560"),
        tools={"pin": tool},
        default_tool="pin",
        start=ROBOT.home,
        objects=(table,),
        contacts=(MeantContact("press", "pin", ("table",), STIFFNESS, 200.0, 0.2, 2e-3),),
    )


_PRESS = ("mov (500, 0, 110)", "lin (500, 0, 99) speed 20 mm/s", "wait 1 s")
