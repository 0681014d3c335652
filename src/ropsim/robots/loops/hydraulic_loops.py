"""Loops of hydraulic axes: a valve sets the speed of an axis, and the arm swings on the oil of its chambers.

Each axis gets a PI regulator of its own: in the terms of the cascade kv = 0, so that u = ki·(e + kp·∫e) +
ke·q̇_ref. With the oil spring k = β·(A_a²/V_a + A_b²/V_b)·G² of every axis the arm swings at the frequencies
ω of k against its masses; leakage takes d = β·L·(1/V_a + 1/V_b) from that, per second; of a motor A is its
displacement, and both chambers are alike. Of one axis s³ + d·s² + ω²·s + c·ω² = 0 is stable up to a crossover
c = d (H. E. Merritt, Hydraulic Control Systems, 1967, chapter 6): a part of that is taken. A cylinder has
another lever at each place, and another speed out than in for one opening of its valve: ki is that of where
an opening moves the axis fastest, ke the middle of the range.
"""

from dataclasses import replace
from math import pi, sqrt

import numpy as np

from ropsim.dynamics import mass_matrix, steady_drive
from ropsim.kinematics import configurations
from ropsim.model import (
    CascadedGains,
    Drive,
    Hydraulic,
    HydraulicCylinder,
    HydraulicMotor,
    Linkage,
    Mechanism,
    Rates,
    gain_names,
)
from ropsim.spatial import Array

SWING_SHARE = 0.25
"""Most of a crossover over the lowest frequency at which the arm swings on its oil."""
LEAK_SHARE = 0.7
"""Crossover over the rate at which the oil leaks, up to which one axis is stable."""
LEAST_SHARE = 0.03
"""Least of it: open valves also damp."""
VALVE_SHARE = 0.2
"""Most of a crossover over the natural frequency of a valve, and over the control rate [Hz]."""
CORNER_SHARE = 0.25
"""Corner of the integral action over the crossover: it costs about 14 degrees of phase, and with the swing of
the oil an axis goes less than a tenth beyond a step of its reference."""
SAMPLES = 64
WINDOW = pi / 360.0
"""Window of a fine stop of a hydraulic axis [rad | m], half a degree: within it the arm swings for long, and
leakage of a valve is not compensated."""
LONGEST_SETTLING = 3.0
"""Longest wait for that [s]: arms swing on their oil for a second or two."""
PLACES = 33
"""Places at which the lever of a cylinder is evaluated."""


def hydraulic_axes(robot: Mechanism) -> list[int]:
    """Return the axes with a hydraulic motor or cylinder."""
    return [k for k, drive in enumerate(robot.drives) if isinstance(drive.motor, Hydraulic)]


def hydraulic_crossover(robot: Mechanism, rates: Rates) -> float:
    """Return the crossover of the loops of the hydraulic axes [rad/s], of which there is one or more."""
    axes, places = hydraulic_axes(robot), configurations(robot, SAMPLES)
    square = np.ix_(axes, axes)
    oils = np.array([[_oil(robot.drives[axis], float(q[axis])) for axis in axes] for q in places])
    steeper = np.array([_steeper(robot.drives[axis]) for axis in axes])
    springs, leaks = np.sqrt(oils[:, :, 0]), oils[:, :, 1] / steeper
    softest = max(
        float(np.linalg.eigvalsh(mass_matrix(robot, q)[square] / np.outer(spring, spring))[-1])
        for q, spring in zip(places, springs, strict=True)
    )
    swing = softest**-0.5
    fastest = VALVE_SHARE * min(rates.control_hz, *(_valve(robot.drives[axis]) for axis in axes))
    return float(min(max(LEAK_SHARE * leaks.min(), LEAST_SHARE * swing), SWING_SHARE * swing, fastest))


def _oil(drive: Drive, q: float) -> tuple[float, float]:
    """Return the spring of the oil at the joint [N·m/rad | N/m] and the rate at which it leaks away [1/s]."""
    motor, place = drive.motor, drive.shaft_at(q)
    assert isinstance(motor, Hydraulic)
    if isinstance(motor, HydraulicMotor):
        softness = 2.0 / motor.chamber_volume
    else:
        within = min(max(place, 0.0), motor.stroke) if isinstance(motor, HydraulicCylinder) else place
        a, b = motor.volumes(within)
        softness = 1.0 / a + 1.0 / b
    leak = motor.bulk_modulus * _leakage(motor) * softness
    return motor.oil_stiffness(place) * drive.ratio_at(q) ** 2, leak


def _leakage(motor: Hydraulic) -> float:
    """Return the leakage from chamber to chamber that damps as that of cylinder and valve do [m³/(s·Pa)].

    At its centre a valve takes Q_0/√(Δp_r·(p_s - p_r)) from a chamber for each Pa; of two chambers with
    opposite pressures half of that does the same between them.
    """
    if not motor.null_flow:
        return motor.leakage
    fall = motor.rated_pressure_drop * (motor.supply_pressure - motor.return_pressure)
    return motor.leakage + 0.5 * motor.null_flow / sqrt(fall)


def _steeper(drive: Drive) -> float:
    """Return how much more of an opening a valve lets through at its centre than beyond, at the most.

    Where edges leak, both edges of a chamber change the flow at the centre (H. E. Merritt, chapter 5: an open
    centre).
    """
    assert isinstance(drive.motor, Hydraulic)
    return 2.0 if drive.motor.null_flow else 1.0


def _valve(drive: Drive) -> float:
    assert isinstance(drive.motor, Hydraulic)
    return drive.motor.natural_frequency


def with_hydraulic_axes(gains: CascadedGains, robot: Mechanism, crossover: float | Array) -> CascadedGains:
    """Return gains with the gains of hydraulic axes inserted.

    Args:
        gains: of all axes.
        robot: the arm.
        crossover: of its hydraulic axes [rad/s], one for all or shape (axes,).
    """
    axes = hydraulic_axes(robot)
    rows = {name: np.array(getattr(gains, name)) for name in gain_names(gains)}
    per_speed = np.array([_per_speed(robot, axis) for axis in axes])
    middle = 0.5 * (per_speed.min(axis=1) + per_speed.max(axis=1))
    own = {
        "kp": CORNER_SHARE * crossover,
        "kv": 0.0,
        "ki": crossover * per_speed.min(axis=1),
        "kf": 1.0,
        "ke": middle,
        "ka": 0.0,
    }
    for name, values in own.items():
        rows[name][axes] = values
    return CascadedGains(**rows)


def _per_speed(robot: Mechanism, axis: int) -> Array:
    """Return current over speed of an axis without load, forward and back, over its range [A·s/rad].

    Leakage is neglected: it does not grow with the speed, and where it flows against a slow rod the current
    would have the other sign.
    """
    drive, joint = robot.drives[axis], robot.axis_joints[axis]
    if isinstance(drive.motor, HydraulicCylinder):
        drive = replace(drive, motor=replace(drive.motor, leakage=0.0))
    if isinstance(drive.motor, Hydraulic):
        drive = replace(drive, motor=replace(drive.motor, null_flow=0.0, overlap=0.0))
    places = (
        np.linspace(joint.lower, joint.upper, PLACES) if isinstance(drive.transmission, Linkage) else [0.0]
    )
    rows = [[way * steady_drive(drive, float(q), way, 0.0).command for way in (1.0, -1.0)] for q in places]
    return np.ravel(rows)


def hydraulic_statement(crossover: float) -> str:
    """Return how the gains come about."""
    return (
        "a PI regulator for each hydraulic axis, from oil, leakage and masses of the model: crossover "
        f"{crossover:.3g} rad/s, integral action {CORNER_SHARE * crossover:.3g} rad/s; speed fed forward"
    )
