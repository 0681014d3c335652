"""Kinds of controllers, each with its textbook property, on a mass that slides and on an arm."""

from dataclasses import replace

import numpy as np
import pytest
from scipy import linalg, signal

from ropsim import robots
from ropsim.blockdiagram import (
    Adaptation,
    AntiWindup,
    Axes,
    CascadeGains,
    Limits,
    OutputKind,
    cascade,
    computed_torque,
    hybrid_force,
    impedance,
    model_reference_adaptive,
    multivariable,
    p_controller,
    pi_controller,
    pid_controller,
    state_feedback,
)
from ropsim.controller import diagram_law, in_python, law_arrays
from ropsim.dynamics import gravity
from ropsim.flow import JointReference
from ropsim.model import Friction, JointType, Payload, RobotModel
from ropsim.simulation import Servo, SimulationOptions, linear_loop, simulate
from ropsim.spatial import Array
from support.diagrams import PERIOD, SLIDE, run, slide, voltages

MASS, VISCOUS = 10.0, 40.0
G = 9.81


def upright(viscous: float = VISCOUS) -> RobotModel:
    """Return the slide with a load along its axis: gravity pulls it down."""
    return replace(slide(MASS, viscous), gravity=np.array([-G, 0.0, 0.0]))


def steps(value: float, ticks: int = 3000) -> Array:
    return np.full((ticks, 1), value)


def test_p_leaves_the_error_that_its_stiffness_needs() -> None:
    q = run(upright(400.0), p_controller(SLIDE, 5000.0), steps(0.0, 6000)).channels["q"].values[-1, 0]
    assert q == pytest.approx(-MASS * G / 5000.0, rel=1e-6)


def test_pi_leaves_no_error_under_a_constant_load() -> None:
    made = run(upright(400.0), pi_controller(SLIDE, 5000.0, 20_000.0), steps(0.05, 6000))
    q = made.channels["q"].values[:, 0]
    assert q[0] == 0.0
    assert abs(q[500:] - 0.05).max() > 1e-4
    assert q[-1] == pytest.approx(0.05, abs=1e-7)


def test_the_integral_holds_the_load_from_the_start() -> None:
    q = run(upright(), pi_controller(SLIDE, 5000.0, 20_000.0), steps(0.0, 500)).channels["q"].values
    assert np.abs(q).max() < 1e-12


def test_pid_damps_what_pi_lets_swing_and_its_clamped_integral_overshoots_less() -> None:
    robot = slide(MASS, 200.0)
    gains = (4000.0, 4000.0, 200.0)
    overshoots = {}
    for remedy in (AntiWindup.NONE, AntiWindup.CLAMPING, AntiWindup.BACK_CALCULATION):
        made = pid_controller(
            SLIDE, gains, Limits(300.0, remedy, 0.1), filter_time=0.001, derivative_weight=0.0
        )
        q = run(robot, made, steps(0.5, 6000)).channels["q"].values[:, 0]
        overshoots[remedy] = q.max() - 0.5
        assert q[-1] == pytest.approx(0.5, abs=2e-3)
    assert overshoots[AntiWindup.CLAMPING] < 0.8 * overshoots[AntiWindup.NONE]
    assert overshoots[AntiWindup.BACK_CALCULATION] < 0.8 * overshoots[AntiWindup.NONE]


def test_the_cascade_follows_a_ramp_without_error_by_its_feed_forward() -> None:
    gains = CascadeGains(20.0, 800.0, 4000.0, per_speed=VISCOUS)
    time = PERIOD * np.arange(1, 3001)[:, None]
    follows = run(slide(MASS, VISCOUS), cascade(SLIDE, gains), 0.2 * time, np.full_like(time, 0.2))
    late = run(
        slide(MASS, VISCOUS),
        cascade(SLIDE, replace(gains, speed_share=0.0)),
        0.2 * time,
        np.full_like(time, 0.2),
    )
    assert abs(follows.channels["q_error"].values[-1, 0]) < 1e-6
    assert late.channels["q_error"].values[-1, 0] == pytest.approx(0.2 / 20.0, rel=1e-3)


def test_the_cascade_is_the_built_in_law_number_for_number() -> None:
    robot = robots.load("puma560")
    controller = robots.cascaded_controller(robot, robots.STANDARD_RATES)
    g = controller.gains
    axes = Axes((JointType.REVOLUTE,) * 6, PERIOD, OutputKind.VOLTAGE)
    given = CascadeGains(*(tuple(getattr(g, name).tolist()) for name in ("kp", "kv", "ki", "kf", "ke", "ka")))
    law = diagram_law(cascade(axes, given, Limits(voltages(robot), AntiWindup.CLAMPING)), robot)
    q = np.tile(robot.home, (200, 1))
    q[:, 0] += 0.01
    reference = JointReference(q, np.zeros_like(q), np.zeros_like(q))
    ours, built_in = (
        simulate(robot, controller, reference, SimulationOptions(start=robot.home, law=one))
        for one in (law, None)
    )
    np.testing.assert_allclose(ours.channels["q"].values, built_in.channels["q"].values, rtol=0.0, atol=1e-12)


def test_state_feedback_puts_the_poles_where_they_were_placed() -> None:
    A, B = np.array([[0.0, 1.0], [0.0, -VISCOUS / MASS]]), np.array([[0.0], [1.0 / MASS]])
    F, H, *_ = signal.cont2discrete((A, B, np.eye(2), np.zeros((2, 1))), PERIOD, "zoh")
    wanted = np.exp(PERIOD * np.array([-30.0 + 20.0j, -30.0 - 20.0j]))
    K = signal.place_poles(F, H, wanted).gain_matrix[0]
    robot = slide(MASS, VISCOUS)
    law = diagram_law(state_feedback(SLIDE, K[0], K[1]), robot)
    loop = linear_loop(robot, robots.default_controller(robot), robot.home, Payload(), law)
    poles = np.linalg.eigvals(loop.closed()[0])
    for one in wanted:
        assert np.abs(poles - one).min() < 1e-9


def test_a_multivariable_regulator_is_its_matrices() -> None:
    """The discrete linear-quadratic regulator as a static gain, and the cost that Riccati's equation says."""
    A, B = np.array([[0.0, 1.0], [0.0, 0.0]]), np.array([[0.0], [1.0 / MASS]])
    F, H, *_ = signal.cont2discrete((A, B, np.eye(2), np.zeros((2, 1))), PERIOD, "zoh")
    Q, R = np.diag([1e6, 1e3]), np.array([[0.01]])
    P = linalg.solve_discrete_are(F, H, Q, R)
    K = np.linalg.solve(R + H.T @ P @ H, H.T @ P @ F)
    diagram = multivariable(SLIDE, [[0.0]], np.zeros((1, 2)), [[0.0]], K)
    made = run(slide(MASS, 0.0), diagram, steps(0.1, 2000))
    x = np.column_stack((made.channels["q"].values[:, 0] - 0.1, made.channels["qd"].values[:, 0]))[1:]
    u = -x @ K[0]
    cost = np.einsum("ki,ij,kj->", x, Q, x) + 0.01 * float(u @ u)
    assert cost == pytest.approx(float(x[0] @ P @ x[0]), rel=1e-6)


def test_under_computed_torque_each_axis_obeys_its_own_linear_equation() -> None:
    robot = robots.load("puma560")
    rigid = tuple(replace(one, friction=Friction()) for one in robot.drives)
    robot = replace(robot, drives=rigid)
    kp, kd = 100.0, 20.0
    start = robot.home + 0.3
    q = np.tile(start, (700, 1))
    q[:, 1] += 0.02
    diagram = computed_torque(Axes((JointType.REVOLUTE,) * 6, PERIOD), kp, kd)
    reference = JointReference(q, np.zeros_like(q), np.zeros_like(q))
    options = SimulationOptions(start=start, law=diagram_law(diagram, robot))
    made = simulate(robot, robots.default_controller("puma560"), reference, options)
    error = (q[0] - made.channels["q"].values) / 0.02
    time = made.time - PERIOD
    expected = (1.0 + 10.0 * time) * np.exp(-10.0 * time)  # both poles at -10/s
    assert np.abs(error[20:, 1] - expected[20:]).max() < 0.02
    assert np.abs(np.delete(error, 1, axis=1)).max() < 0.02


def test_an_impedance_gives_way_by_force_over_stiffness() -> None:
    robot = robots.load("two_link")
    robot = replace(robot, drives=tuple(replace(one, friction=Friction()) for one in robot.drives))
    stiffness = np.array([900.0, 400.0])
    law = diagram_law(impedance(Axes((JointType.REVOLUTE,) * 2, PERIOD), stiffness, 0.1 * stiffness), robot)
    start = robot.home + 0.4
    q = np.tile(start, (4000, 1))
    reference = JointReference(q, np.zeros_like(q), np.zeros_like(q))
    part = Payload(2.0, np.array([0.05, 0.0, 0.1]))
    options = SimulationOptions(start=start, law=law, payload=part)
    controller = robots.cascaded_controller(robot, robots.STANDARD_RATES)
    held = simulate(robot, controller, reference, options).channels["q"].values[-1]
    np.testing.assert_allclose(held, start, rtol=0.0, atol=1e-9)  # the law knows the part
    heavy = replace(robot, links=tuple(replace(one, mass=1.5 * one.mass) for one in robot.links))
    gave = simulate(heavy, controller, reference, options).channels["q"].values[-1]
    force = gravity(robot, gave, part) - gravity(heavy, gave, part)  # that the law knows nothing of
    np.testing.assert_allclose(gave - start, force / stiffness, rtol=1e-6, atol=1e-9)
    assert np.abs(gave - start).max() > 0.003


def test_a_force_controlled_axis_presses_a_wall_with_its_force() -> None:
    """The wall is a spring; the plant is integrated here, for the simulation has no contact."""
    robot = slide(MASS, 300.0)
    diagram = hybrid_force(SLIDE, (True,), 25.0, (0.0, 50.0), (0.2, 5.0))
    wall = 20_000.0
    law = diagram_law(diagram, robot)
    function, arrays = in_python(law), law_arrays(law, 1)
    q = qd = u = 0.0
    for _ in range(20_000):
        arrays["meas"][:, 0] = q, qd, u
        function(arrays)
        u = float(arrays["out"][0])
        for _ in range(10):
            qdd = (u - 300.0 * qd - wall * q) / MASS
            qd += 1e-4 * qdd
            q += 1e-4 * qd
    assert u == pytest.approx(25.0, rel=1e-6)
    assert wall * q == pytest.approx(25.0, rel=1e-6)


def test_model_reference_adaptation_finds_mass_friction_and_load_under_a_rich_reference() -> None:
    time = PERIOD * np.arange(1, 40_001)[:, None]
    parts = ((0.30, 1.3), (0.20, 3.1), (0.10, 5.7))
    q = sum(a * (1.0 - np.cos(w * time)) for a, w in parts)
    qd = sum(a * w * np.sin(w * time) for a, w in parts)
    qdd = sum(a * w * w * np.cos(w * time) for a, w in parts)
    numbers = Adaptation(20.0, 10.0, 200.0, 2.0, 0.0, 0.0, 20.0, 60.0, 400.0)
    diagram = model_reference_adaptive(SLIDE, numbers)
    robot = upright()
    law = diagram_law(diagram, robot)
    servo = Servo.build(robot, robots.default_controller(robot), law)
    state = servo.initial_state(robot.home)
    recorder = servo.recorder(state, 10)
    state = servo.run(state, JointReference(q, qd, qdd), Payload(), recorder)
    error = recorder.channels()["q_ref"][:, 0] - recorder.channels()["q"][:, 0]
    first, last = np.abs(error[:300]).max(), np.abs(error[-300:]).max()
    assert last < 1e-3 * max(first, 1e-3) + 2e-4
    memory = servo.layout.memory(state.values.copy()).reshape(-1)
    for found in (MASS, VISCOUS, MASS * G):
        assert np.abs(memory / found - 1.0).min() < 0.02
