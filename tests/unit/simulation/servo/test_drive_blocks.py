"""Blocks of drives in one arm: compiled code and Python mean the same, bit by bit, however it is sliced."""

import numpy as np

from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw
from ropsim.model import (
    BacklashGear,
    CurrentLoopMotor,
    Drive,
    EffortAmplifier,
    Gear,
    GuardedAmplifier,
    HydraulicVane,
    IdealMotor,
    LoadFriction,
    LugreFriction,
    Payload,
    RobotModel,
    StribeckFriction,
    ThermalDcMotor,
    ValveAmplifier,
)
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.arms import random_arm
from support.servo_cases import controller, standing

WARM = ThermalDcMotor(0.2, 0.2, 1.5, 6e-3, 2e-4, 0.6, 2.4, 20.0, 900.0, start_rise=30.0)
LOOP = CurrentLoopMotor(0.2, 0.21, 1.5, 6e-3, 2e-4, 40.0, 12.0, 800.0)
VANE = HydraulicVane(
    *(1e-4, 12.0, -6.0, 1.5e-5, 2e-12, 1e-2),
    supply_pressure=1.4e7,
    return_pressure=2e5,
    bulk_modulus=1.2e9,
    rated_flow=2e-4,
    rated_pressure_drop=7e6,
    rated_input=0.05,
    natural_frequency=500.0,
    damping_ratio=0.8,
    null_flow=4e-6,
    overlap=0.02,
)
DRIVES = (
    Drive(
        GuardedAmplifier(40.0, 20.0, 100.0),
        WARM,
        BacklashGear(-60.0, 2e4, 20.0, 3e-4),
        StribeckFriction(1e-4, 0.02, 0.04, 4.0, 1.4),
    ),
    Drive(EffortAmplifier(2.0), LOOP, Gear(50.0), LugreFriction(1e-4, 0.02, 0.04, 4.0, 30.0, 0.05)),
    Drive(ValveAmplifier(0.05), VANE, Gear(1.5), LoadFriction(2.0, 1.0, 0.1, 0.02)),
    Drive(EffortAmplifier(), IdealMotor(1e-3), Gear(-20.0), LugreFriction(1e-3, 0.1, 0.15, 2.0, 60.0)),
)
COMMANDS = np.array([[12.0, 0.6, 0.01, -0.4]])
HOLD = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        out[j] = par[0, j]
"""
TICKS = 40


def arm() -> RobotModel:
    return random_arm(8, "RRRR", DRIVES)


def moved(engine: Engine, slices: int) -> Array:
    """Return the state vector after some ticks."""
    servo = Servo.build(arm(), controller(4), CompiledLaw("hold", HOLD, ("u",), COMMANDS), engine)
    state = servo.initial_state(np.zeros(4))
    recorder = servo.recorder(state)
    for _ in range(slices):
        state = servo.run(state, standing(np.zeros(4), TICKS // slices), Payload(), recorder)
    return state.values


def test_compiled_code_has_every_bit_of_the_lines_in_python() -> None:
    compiled, lines = moved(Engine.NUMBA, 1), moved(Engine.PYTHON, 1)
    assert np.isfinite(compiled).all()
    assert np.abs(compiled[4:8]).min() > 1e-4
    np.testing.assert_array_equal(compiled, lines)


def test_slices_change_no_bit() -> None:
    np.testing.assert_array_equal(moved(Engine.NUMBA, 8), moved(Engine.NUMBA, 1))


def test_each_quantity_is_recorded_for_the_axes_that_have_it() -> None:
    servo = Servo.build(arm(), controller(4), CompiledLaw("hold", HOLD, ("u",), COMMANDS))
    state = servo.initial_state(np.zeros(4))
    recorder = servo.recorder(state)
    servo.run(state, standing(np.zeros(4), 5), Payload(), recorder)
    widths = {name: rows.shape[1] for name, rows in recorder.channels().items()}
    own = {"bristles": 2, "current": 2, "loop_voltage": 1, "winding_rise": 1, "motor_speed": 1, "opening": 1}
    assert {name: widths[name] for name in own} == own
