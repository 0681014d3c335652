"""Power balance of the motor inside the generated plant."""

import numpy as np

from ropsim.codegen import Engine, load
from ropsim.dynamics import arm_numbers, structure_of
from ropsim.model import DcMotor
from ropsim.simulation.testing import plant_code
from support.arms import drive, random_arm

ROUNDING = 1e-9  # powers up to 1e4 W


def test_electrical_power_is_heat_plus_magnetic_plus_mechanical_power() -> None:
    """u·i = R·i² + L·i·di/dt + τ·q̇ with Kt = Ke, for every joint and both signs of the gear ratio."""
    motor = DcMotor(0.2, 0.2, 1.5, 2e-3, 1e-4)
    ratios = (50.0, -80.0, 30.0)
    robot = random_arm(9, "RPR", tuple(drive(ratio=ratio, motor=motor) for ratio in ratios))
    code = plant_code(structure_of(robot))
    derivative = load("power", code.functions, Engine.PYTHON)
    constants = code.constants(arm_numbers(robot))
    rng = np.random.default_rng(3)
    for _ in range(20):
        x, u, dx = rng.uniform(-2.0, 2.0, 9), rng.uniform(-40.0, 40.0, 3), np.empty(9)
        derivative(x, u, constants, dx)
        qd, current, rate = x[3:6], x[6:], dx[6:]
        heat = motor.resistance * current**2
        magnetic = motor.inductance * current * rate
        mechanical = np.array(ratios) * motor.torque_constant * current * qd
        np.testing.assert_allclose(u * current, heat + magnetic + mechanical, rtol=0, atol=ROUNDING)
