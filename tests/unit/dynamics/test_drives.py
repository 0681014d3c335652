"""Drives as chains of blocks."""

from dataclasses import replace
from math import inf, nan

import numpy as np
import pytest

from ropsim.codegen import Tracer
from ropsim.codegen.testing import reachable
from ropsim.dynamics import (
    DriveChain,
    chain_of,
    command_limit,
    drive_fault,
    forward_dynamics,
    friction,
    mass_matrix,
    steady_drive,
)
from ropsim.dynamics.drives.block import AmplifierBlock, FrictionBlock, MotorBlock, TransmissionBlock
from ropsim.dynamics.drives.table import AMPLIFIERS, FRICTIONS, MOTORS, TRANSMISSIONS
from ropsim.model import (
    CurrentLimitedAmplifier,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    Gear,
    IdealMotor,
    InputKind,
    Linkage,
    VoltageAmplifier,
    ideal_drive,
)
from support.arms import MOTOR, drive, random_arm, random_states

ELASTIC = Drive(VoltageAmplifier(40.0, 10.0), MOTOR, ElasticGear(80.0, 1e4, 5.0))


def test_a_chain_names_its_states_and_what_it_takes() -> None:
    names = [[state.name for state in chain_of(one).states] for one in (drive(), ideal_drive(), ELASTIC)]
    assert names == [["current"], [], ["current", "motor_coordinate", "motor_speed"]]
    assert chain_of(drive()).amplifier.kind is InputKind.VOLTAGE
    assert chain_of(ideal_drive()).amplifier.kind is InputKind.EFFORT


def test_the_numbers_of_a_drive_are_those_of_its_blocks_in_order() -> None:
    one = drive(ratio=-60.0, friction=Friction(0.1, 0.2, -0.3, 0.004))
    motor = (MOTOR.torque_constant, MOTOR.back_emf_constant, MOTOR.resistance, MOTOR.inductance)
    assert chain_of(one).numbers(one) == (40.0, *motor, MOTOR.rotor_inertia, -60.0, 0.1, 0.2, -0.3, 0.004)
    assert chain_of(one).size == 11


@pytest.mark.parametrize("ratio", [50.0, -50.0])
def test_a_dc_drive_in_a_steady_state_obeys_ohm_and_its_back_emf(ratio: float) -> None:
    held = steady_drive(drive(ratio=ratio), 0.0, 0.7, 30.0)
    current = 30.0 / (ratio * MOTOR.torque_constant)
    volts = MOTOR.resistance * current + MOTOR.back_emf_constant * ratio * 0.7
    assert held.states == pytest.approx((current,))
    assert held.output == pytest.approx(volts)
    assert held.command == pytest.approx(np.sign(ratio) * volts)


def test_an_ideal_drive_gives_what_it_is_commanded() -> None:
    assert steady_drive(ideal_drive(), 0.3, 2.0, 12.5) == ((), 12.5, 12.5)
    assert command_limit(ideal_drive()) == inf
    assert command_limit(ideal_drive(40.0)) == 40.0


@pytest.mark.parametrize("law", FRICTIONS.values())
@pytest.mark.parametrize("transmission", TRANSMISSIONS.values())
@pytest.mark.parametrize("motor", MOTORS.values())
@pytest.mark.parametrize("amplifier", AMPLIFIERS.values())
def test_friction_and_inertia_at_the_joint_are_those_of_numbers_speed_and_lever_alone(
    amplifier: AmplifierBlock, motor: MotorBlock, transmission: TransmissionBlock, law: FrictionBlock
) -> None:
    """Planning knows no states of drives: what a block brings to the joint must not need them."""
    chain, tracer = DriveChain(amplifier, motor, transmission, law), Tracer()
    p = tracer.variables("numbers", chain.size)
    q, qd = tracer.variable("q"), tracer.variable("qd")
    carried = chain.side(p, q, qd)
    rubbing = (carried.friction.torque, carried.friction.share) if carried.friction else ()
    sides = [side for side in (*rubbing, carried.inertia) if side is not None]
    read = {node.text.partition("[")[0] for node in reachable(sides) if node.op == "var"}
    assert read <= {"numbers", "qd"} | ({"q"} if transmission is TRANSMISSIONS[Linkage] else set())


def test_an_elastic_gear_is_twisted_by_what_it_carries() -> None:
    held = steady_drive(ELASTIC, 0.4, 0.0, 20.0)
    assert held.states == pytest.approx((20.0 / (80.0 * MOTOR.torque_constant), 0.4 + 20.0 / 1e4, 0.0))


def test_behind_an_elastic_gear_the_joint_feels_neither_rotor_nor_friction() -> None:
    soft = replace(ELASTIC, friction=Friction(0.1, 2.0, -2.0))
    with_drive, without = random_arm(2, "RR", (soft,) * 2), random_arm(2, "RR")
    for q, qd, tau in random_states(without, 3):
        np.testing.assert_array_equal(mass_matrix(with_drive, q), mass_matrix(without, q))
        one, other = (forward_dynamics(robot, q, qd, tau) for robot in (with_drive, without))
        np.testing.assert_allclose(one, other, rtol=1e-13)
        assert friction(with_drive, q, qd).tolist() == [0.0, 0.0]


OPEN = replace(drive(), amplifier=VoltageAmplifier(40.0, inf))


HELD = replace(drive(), amplifier=CurrentLimitedAmplifier(40.0, inf))


@pytest.mark.parametrize("one", [drive(), OPEN, HELD, ideal_drive(), ideal_drive(3.0), ELASTIC])
def test_a_possible_drive_has_no_fault(one: Drive) -> None:
    assert drive_fault(one) is None


@pytest.mark.parametrize(
    ("broken", "told"),
    [
        (replace(drive(), motor=replace(MOTOR, inductance=0.0)), "`inductance` is `0.0`"),
        (replace(drive(), motor=replace(MOTOR, resistance=-1.0)), "`resistance` is `-1.0`"),
        (replace(drive(), motor=replace(MOTOR, torque_constant=nan)), "`torque_constant` is `nan`"),
        (replace(drive(), amplifier=VoltageAmplifier(0.0, 1.0)), "`max_voltage` is `0.0`"),
        (replace(drive(), amplifier=VoltageAmplifier(inf, 1.0)), "`max_voltage` is `inf`"),
        (replace(drive(), amplifier=VoltageAmplifier(40.0, 0.0)), "`max_current` is `0.0`"),
        (replace(drive(), amplifier=VoltageAmplifier(40.0, nan)), "`max_current` is `nan`"),
        (replace(drive(), amplifier=CurrentLimitedAmplifier(40.0, -1.0)), "`max_current` is `-1.0`"),
        (replace(drive(), amplifier=CurrentLimitedAmplifier(inf, 1.0)), "`max_voltage` is `inf`"),
        (replace(drive(), motor=IdealMotor(), amplifier=CurrentLimitedAmplifier(40.0, 1.0)), "takes effort"),
        (replace(drive(), transmission=Gear(0.0)), "magnitude of `ratio` is `0.0`"),
        (replace(ideal_drive(), amplifier=EffortAmplifier(0.0)), "`max_effort` is `0.0`"),
        (replace(ELASTIC, transmission=ElasticGear(80.0, 0.0)), "`stiffness` is `0.0`"),
        (replace(ELASTIC, motor=replace(MOTOR, rotor_inertia=0.0)), "`rotor_inertia` is `0.0`"),
        (replace(drive(), motor=IdealMotor()), "takes effort, but its amplifier puts out voltage"),
        (replace(ideal_drive(), motor=MOTOR), "takes voltage, but its amplifier puts out effort"),
    ],
)
def test_an_impossible_drive_says_what_of_it_is(broken: Drive, told: str) -> None:
    found = drive_fault(broken)
    assert found
    assert told in " ".join(found)
