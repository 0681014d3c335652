"""A cylinder that turns a joint: its lever, its chambers, the whole against equations written down anew."""

from collections.abc import Callable
from dataclasses import replace
from math import cos, hypot, pi, sin, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim.codegen import Engine
from ropsim.dynamics import (
    chain_of,
    compiled,
    drive_fault,
    range_fault,
    rotor_inertias,
    steady_drive,
)
from ropsim.dynamics.drives import largest_effort
from ropsim.model import Friction, Gear, JointType, RobotModel, linkage
from ropsim.spatial import Array
from support.cylinders import (
    CARRIER_PIN,
    CENTRE,
    CYLINDER,
    DRIVE,
    INERTIA,
    LINK_PIN,
    LOWER,
    MASS,
    RETRACTED,
    UPPER,
    lifted,
)
from support.drives import rates_of

GRAVITY = 9.81


def pins(q: float) -> float:
    """Return the distance of the pins by their places in the plane [m]."""
    (a, b, _), (c, d, _) = CARRIER_PIN, LINK_PIN
    return hypot(c * cos(q) - d * sin(q) - a, c * sin(q) + d * cos(q) - b)


def lever(q: float) -> float:
    """Return the distance of the axis from the line through both pins [m]."""
    (a, b, _), (c, d, _) = CARRIER_PIN, LINK_PIN
    x, y = c * cos(q) - d * sin(q), c * sin(q) + d * cos(q)
    return (a * y - b * x) / pins(q)


def effort(robot: RobotModel, q: float, qd: float) -> float:
    """Return the torque of the drive at constant speed [N·m]."""
    tau = np.empty(1)
    motion = (np.array([q]), np.array([qd]), np.zeros(1), np.zeros(6))
    compiled(robot, None, Engine.PYTHON).inverse(*motion, tau)
    return float(tau[0])


def held(robot: RobotModel, q: float) -> float:
    """Return the torque that holds the link [N·m]."""
    return effort(robot, q, 0.0)


def inertia(robot: RobotModel, q: float) -> float:
    """Return the inertia about the axis [kg·m²]."""
    M = np.empty(1)
    compiled(robot, None, Engine.PYTHON).mass_matrix(np.array([q]), M)
    return float(M[0])


def test_the_length_is_that_between_the_pins_and_the_ratio_the_lever_of_the_force() -> None:
    gear = linkage(CARRIER_PIN, LINK_PIN, RETRACTED, 0.5)
    for q in np.linspace(LOWER, UPPER, 9):
        assert gear.length_at(q) == pytest.approx(pins(q), rel=1e-12)
        assert gear.ratio_at(q) == pytest.approx(lever(q), rel=1e-12)
        slope = (pins(q + 1e-6) - pins(q - 1e-6)) / 2e-6
        assert gear.ratio_at(q) == pytest.approx(slope, rel=1e-8)


def test_pins_apart_along_the_axis_make_the_rod_longer_and_the_lever_shorter() -> None:
    beside = linkage(CARRIER_PIN, (*LINK_PIN[:2], 0.3), RETRACTED, 0.5)
    assert beside.length_at(0.2) == pytest.approx(hypot(pins(0.2), 0.3))
    assert beside.ratio_at(0.2) == pytest.approx(lever(0.2) * pins(0.2) / hypot(pins(0.2), 0.3))


def test_a_link_at_rest_is_held_by_the_difference_of_the_forces_of_both_chambers() -> None:
    robot = lifted()
    for q in (-0.3, 0.4, 1.3):
        load = held(robot, q)
        assert load == pytest.approx(MASS * GRAVITY * (CENTRE[0] * cos(q) - CENTRE[1] * sin(q)), rel=1e-9)
        a, b, *_ = steady_drive(DRIVE, q, 0.0, load).states
        assert a * CYLINDER.area_a - b * CYLINDER.area_b == pytest.approx(load / lever(q), rel=1e-12)
        assert a + b == pytest.approx(CYLINDER.supply_pressure + CYLINDER.return_pressure)


@pytest.mark.parametrize("speed", [-0.25, -0.04, 0.0, 0.04, 0.25])
@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_steady_state_stays(speed: float, sense: float) -> None:
    """Pressures stay but for what the laminar part of the flow is, while chambers grow and shrink."""
    mirrored = [(x, sense * y, z) for x, y, z in (CARRIER_PIN, LINK_PIN)]
    drive = replace(DRIVE, transmission=linkage(mirrored[0], mirrored[1], RETRACTED, sense * 0.5))
    q, effort = sense * 0.5, sense * 9000.0
    held = steady_drive(drive, q, speed, effort)
    out = rates_of(drive)(np.array(held.states), q, speed, held.output)
    assert out[0] == pytest.approx(effort)
    assert out[1:3] * CYLINDER.volumes(0.2)[1] / CYLINDER.bulk_modulus / CYLINDER.rated_flow == pytest.approx(
        [0.0, 0.0], abs=2e-4
    )
    assert out[3:] == pytest.approx([0.0, 0.0], abs=1e-6)
    assert np.sign(held.command * speed) == np.sign(speed) ** 2


def test_it_pushes_with_its_piston_and_pulls_with_its_ring() -> None:
    push = CYLINDER.area_a * 160e5 - CYLINDER.area_b * 1e5
    pull = CYLINDER.area_b * 160e5 - CYLINDER.area_a * 1e5
    assert pull < push
    assert largest_effort(DRIVE, 0.5) == pytest.approx(pull * lever(0.5))


def test_beyond_the_ends_of_its_stroke_the_chambers_stay_as_large_as_there() -> None:
    """No stop is modelled: a chamber that went on shrinking would have no volume in the end."""
    gear, end = linkage(CARRIER_PIN, LINK_PIN, RETRACTED, 0.5), UPPER + 0.3
    assert gear.out_at(end) > CYLINDER.stroke
    states = np.array([4e6, 3e6, 0.2, 0.0])
    at_end, longer = (
        rates_of(replace(DRIVE, motor=replace(CYLINDER, stroke=stroke)))(states, end, 0.0, 0.1)[2]
        for stroke in (CYLINDER.stroke, gear.out_at(end))
    )
    assert at_end == pytest.approx(longer, rel=1e-9)


def textbook(current: float) -> Callable[[float, Array], Array]:
    """Return the equations of the lifted link as they stand in books, for a valve current.

    The state is q, q̇, both pressures, opening and its rate.
    """
    c, friction = CYLINDER, DRIVE.friction

    def edge(fall: float) -> float:
        return float(fall / (fall * fall + 1e10) ** 0.25)

    def slope(_: float, x: Array) -> Array:
        q, qd, a, b, opening, rate = x.tolist()
        out, G = pins(q) - RETRACTED, lever(q)
        bend = (lever(q + 1e-5) - lever(q - 1e-5)) / 2e-5
        v = G * qd
        k = c.rated_flow * sqrt(2.0 / c.rated_pressure_drop)
        if opening > 0.0:
            flow_a, flow_b = (
                k * opening * edge(c.supply_pressure - a),
                -k * opening * edge(b - c.return_pressure),
            )
        else:
            flow_a, flow_b = (
                k * opening * edge(a - c.return_pressure),
                -k * opening * edge(c.supply_pressure - b),
            )
        leak = c.leakage * (a - b)
        a_rate = c.bulk_modulus / (c.dead_volume_a + c.area_a * out) * (flow_a - c.area_a * v - leak)
        b_rate = (
            c.bulk_modulus / (c.dead_volume_b + c.area_b * (c.stroke - out)) * (flow_b + c.area_b * v + leak)
        )
        rub = friction.viscous * v + friction.coulomb_positive * np.tanh(qd / friction.smoothing_speed)
        force = c.area_a * a - c.area_b * b - rub - c.moving_mass * bend * qd * qd
        down = MASS * GRAVITY * (CENTRE[0] * cos(q) - CENTRE[1] * sin(q))
        inertia = INERTIA + MASS * (CENTRE[0] ** 2 + CENTRE[1] ** 2) + c.moving_mass * G * G
        spool = c.natural_frequency**2 * (current / c.rated_input - opening)
        spool -= 2.0 * c.damping_ratio * c.natural_frequency * rate
        return np.array([qd, (G * force - down) / inertia, a_rate, b_rate, rate, spool])

    return slope


def simulated(current: float) -> Callable[[float, Array], Array]:
    """Return the same by the formulas of arm and drive."""
    robot, rates = lifted(), rates_of(DRIVE)
    forward = compiled(robot, None, Engine.PYTHON).forward

    def slope(_: float, x: Array) -> Array:
        out = rates(x[2:], float(x[0]), float(x[1]), current)
        qdd = np.empty(1)
        forward(x[:1], x[1:2], out[:1], qdd)
        return np.array([x[1], qdd[0], *out[1:]])

    return slope


@pytest.mark.parametrize(("current", "q"), [(0.35, -0.2), (-0.25, 1.0)])
def test_it_moves_as_the_equations_of_the_textbook_say(current: float, q: float) -> None:
    start = np.array([q, 0.0, *steady_drive(DRIVE, q, 0.0, held(lifted(), q)).states])
    ends = [
        solve_ivp(one(current), (0.0, 0.25), start, rtol=1e-9, atol=1e-9, method="LSODA").y[:, -1]
        for one in (simulated, textbook)
    ]
    assert abs(ends[0][0] - q) > 0.02
    np.testing.assert_allclose(ends[0], ends[1], rtol=2e-6, atol=1e-7)


def test_the_energy_of_link_and_rod_is_what_the_oil_has_done_less_friction() -> None:
    slope, q = simulated(0.5), 0.0
    start = [q, 0.0, *steady_drive(DRIVE, q, 0.0, held(lifted(), q)).states, 0.0]

    def with_work(t: float, x: Array) -> Array:
        v = lever(x[0]) * x[1]
        friction = DRIVE.friction
        rub = friction.viscous * v + friction.coulomb_positive * np.tanh(x[1] / friction.smoothing_speed)
        force = CYLINDER.area_a * x[2] - CYLINDER.area_b * x[3] - rub
        return np.append(slope(t, x[:6]), force * v)

    end = solve_ivp(with_work, (0.0, 0.3), np.array(start), rtol=1e-9, atol=1e-9, method="LSODA").y[:, -1]

    def energy(x: Array) -> float:
        about_axis = INERTIA + MASS * (CENTRE[0] ** 2 + CENTRE[1] ** 2)
        height = CENTRE[0] * sin(x[0]) + CENTRE[1] * cos(x[0])
        moving = about_axis + CYLINDER.moving_mass * lever(x[0]) ** 2
        return float(0.5 * moving * x[1] ** 2 + MASS * GRAVITY * height)

    gained = energy(end) - energy(np.array(start))
    assert gained > 50.0
    assert end[6] == pytest.approx(gained, rel=1e-6)


def test_the_rod_is_inertia_at_the_joint_by_the_square_of_its_lever() -> None:
    robot, bare = lifted(), lifted(replace(DRIVE, motor=replace(CYLINDER, moving_mass=0.0)))
    for q in (-0.2, 0.7):
        more = inertia(robot, q) - inertia(bare, q)
        assert more == pytest.approx(CYLINDER.moving_mass * lever(q) ** 2)
        assert rotor_inertias(robot, [[q]])[0, 0] == pytest.approx(more)
    slope = (lever(0.2 + 1e-5) - lever(0.2 - 1e-5)) / 2e-5
    extra = [effort(one, 0.2, 0.6) for one in (robot, bare)]
    assert extra[0] - extra[1] == pytest.approx(CYLINDER.moving_mass * lever(0.2) * slope * 0.36, rel=1e-6)


def test_a_drive_that_cannot_be_is_told_by_what_is_wrong() -> None:
    (joint,) = lifted().joints
    assert drive_fault(DRIVE) is None
    assert range_fault(DRIVE, joint) is None
    for wrong, word in ((dict(leakage=-1e-12), "leakage"), (dict(moving_mass=-1.0), "moving_mass")):
        found = drive_fault(replace(DRIVE, motor=replace(CYLINDER, **wrong)))
        assert found is not None
        assert word in found[0]
    found = drive_fault(replace(DRIVE, motor=replace(CYLINDER, area_b=1.1 * CYLINDER.area_a)))
    assert found is not None
    assert found[0] == "`area_b`"
    found = drive_fault(replace(DRIVE, motor=replace(CYLINDER, return_pressure=2e7)))
    assert found is not None
    assert "return_pressure" in found[0]
    for swapped in (replace(DRIVE, transmission=Gear()), replace(DRIVE, motor=replace(CYLINDER, area_b=0.0))):
        assert drive_fault(swapped) is not None
    cases = (
        (replace(joint, lower=-1.2), "a dead centre within the range"),
        (replace(joint, upper=pi / 1.8), "is 0.82964 to 1.3738 m long"),
        (replace(joint, lower=-0.45), "m long over the range of its joint; its cylinder is 0.82 to"),
        (replace(joint, upper=2.2), "a dead centre within the range"),
        (replace(joint, type=JointType.PRISMATIC), "turning joint"),
        (replace(joint, upper=float("inf")), "no limits"),
    )
    for wrong_joint, words in cases:
        found = range_fault(DRIVE, wrong_joint)
        assert found is not None
        assert words in found[1], found[1]


def test_friction_of_the_rod_has_the_lever_of_its_force() -> None:
    chain = chain_of(DRIVE)
    assert [state.name for state in chain.states] == ["pressure_a", "pressure_b", "opening", "opening_rate"]
    smooth = replace(DRIVE, friction=Friction(viscous=1e3))
    tau = [effort(lifted(one), 0.5, 0.3) for one in (smooth, replace(smooth, friction=Friction()))]
    assert tau[0] - tau[1] == pytest.approx(1e3 * lever(0.5) ** 2 * 0.3)
