"""Loops of hydraulic axes: a valve gives an axis its speed, and the arm swings on the oil of its chambers.

Each axis gets a PI regulator of its own: in the terms of the cascade kv = 0, so that
u = ki·(e + kp·∫e) + ke·q̇_ref. With the oil spring k = 2·β·(D·G)²/V of every axis the arm swings at the
frequencies ω of k against its masses; what leaks takes d = 2·β·L/V from that, per second. Of one axis
s³ + d·s² + ω²·s + c·ω² = 0 is stable up to a crossover c = d (H. E. Merritt, Hydraulic Control Systems, 1967,
chapter 6): half of that is taken.
"""

from math import sqrt

import numpy as np

from ropsim.dynamics import mass_matrix, steady_drive
from ropsim.kinematics import configurations
from ropsim.model import CascadedGains, HydraulicMotor, Mechanism, Rates, gain_names

SWING_SHARE = 0.25
"""Most of a crossover over the lowest frequency at which the arm swings on its oil."""
LEAST_SHARE = 0.03
"""Least of it: valves that are open damp, too."""
VALVE_SHARE = 0.2
"""Most of a crossover over the natural frequency of a valve, and over the control rate [Hz]."""
CORNER_SHARE = 0.5
"""Corner of the integral action over the crossover: it costs about 27 degrees of phase."""
SAMPLES = 64


def hydraulic_axes(robot: Mechanism) -> list[int]:
    """Return the axes with a hydraulic motor."""
    return [k for k, drive in enumerate(robot.drives) if isinstance(drive.motor, HydraulicMotor)]


def hydraulic_crossover(robot: Mechanism, rates: Rates) -> float:
    """Return the crossover of the loops of the hydraulic axes [rad/s], of which there is one or more."""
    axes, springs, leaks, valves = hydraulic_axes(robot), [], [], []
    for axis in axes:
        drive = robot.drives[axis]
        motor = drive.motor
        assert isinstance(motor, HydraulicMotor)
        oil = 2.0 * motor.bulk_modulus / motor.chamber_volume
        springs.append(sqrt(oil) * abs(motor.displacement * drive.ratio))
        leaks.append(oil * motor.leakage)
        valves.append(motor.natural_frequency)
    square = np.ix_(axes, axes)
    softest = max(
        float(np.linalg.eigvalsh(mass_matrix(robot, q)[square] / np.outer(springs, springs))[-1])
        for q in configurations(robot, SAMPLES)
    )
    swing = softest**-0.5
    fastest = VALVE_SHARE * min(rates.control_hz, *valves)
    return float(min(max(0.5 * min(leaks), LEAST_SHARE * swing), SWING_SHARE * swing, fastest))


def with_hydraulic_axes(gains: CascadedGains, robot: Mechanism, crossover: float) -> CascadedGains:
    """Return gains with those of hydraulic axes put in."""
    axes = hydraulic_axes(robot)
    rows = {name: np.array(getattr(gains, name)) for name in gain_names(gains)}
    per_speed = np.array([steady_drive(robot.drives[axis], 0.0, 1.0, 0.0).command for axis in axes])
    own = {
        "kp": CORNER_SHARE * crossover,
        "kv": 0.0,
        "ki": crossover * per_speed,
        "kf": 1.0,
        "ke": per_speed,
        "ka": 0.0,
    }
    for name, values in own.items():
        rows[name][axes] = values
    return CascadedGains(**rows)


def hydraulic_statement(crossover: float) -> str:
    """Return how the gains come about."""
    return (
        "a PI regulator for each hydraulic axis, from oil, leakage and masses of the model: crossover "
        f"{crossover:.3g} rad/s, integral action {CORNER_SHARE * crossover:.3g} rad/s; speed fed forward"
    )
