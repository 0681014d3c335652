"""Loops of fixed gains, joint by joint: gains of the cascade from motors, gears and masses of the model.

An inertia that changes with the posture or the load changes the bandwidth of such a loop by as much. Elastic
gears keep the speed loops of their axes below the frequency at which the arm swings on them.
"""

from functools import lru_cache

import numpy as np

from ropsim.dynamics import (
    axis_inertias,
    chain_of,
    elastic_axes,
    free_inertias,
    gear_stiffnesses,
    rotor_inertias,
    steady_drive,
)
from ropsim.kinematics import configurations
from ropsim.model import CascadedGains, Mechanism, Rates
from ropsim.robots.diagnostics import NoControllerError
from ropsim.robots.loops.elastic_gears import (
    ELASTIC_SHARE,
    SOFTER,
    elastic_frequencies,
    elastic_words,
    span,
)
from ropsim.spatial import Array, frozen, record

ELECTRICAL_SHARE = 1.0 / 3.0
"""Crossover of the speed loop over the electrical pole R/L: the current then lags by about 18 degrees."""

CONTROL_SHARE = 1.0 / 5.0
"""Crossover of the speed loop [rad/s] over the control rate [Hz]: the held output costs about 6 degrees."""

COUPLED_SHARE = 1.0 / 3.0
"""The same with the other joints free: their couplings make an axis lighter, which quickens its loop."""

POSITION_SHARE = 0.3
"""Bandwidth of the position loop over that of the speed loop: no overshoot of the cascade."""

INTEGRAL_SHARE = 0.4
"""Corner of the integral action over the crossover of the speed loop: it costs about 22 degrees, and the
Coulomb friction that vanishes at a stop is made up for within the last milliseconds of the move."""

SAMPLES = 512
"""Configurations at which the inertias of the axes are evaluated."""


@record
class LoopBandwidths:
    """Bandwidths of the loops of a cascade, one number per joint.

    Attributes:
        speed: crossover of the speed loop at the inertia for which it is designed [rad/s], shape (n,).
        position: bandwidth of the position loop [rad/s], shape (n,).
        integral: corner of the integral action of the speed loop [rad/s], shape (n,).
    """

    speed: Array
    position: Array
    integral: Array


def standard_bandwidths(robot: Mechanism, rates: Rates) -> LoopBandwidths:
    """Return the bandwidths that motors, control rate and couplings of an arm allow.

    Raises:
        NoControllerError: X861, the arm has no drives.
    """
    if not robot.drives:
        raise NoControllerError(robot.name)
    is_elastic = elastic_axes(robot)
    poles = np.array([chain_of(drive).motor.pole(drive.motor) for drive in robot.drives])
    design, free, swing = _inertias(robot)
    coupled = COUPLED_SHARE * rates.control_hz * free / design
    lag = np.where(
        is_elastic, free / design, 1.0
    )  # beyond its oscillation frequency the motor turns separately, with less inertia
    speed = np.minimum(np.minimum(ELECTRICAL_SHARE * poles * lag, CONTROL_SHARE * rates.control_hz), coupled)
    softer = np.sqrt(SOFTER * gear_stiffnesses(robot) / (POSITION_SHARE * design))  # kv·kp = 0.3·ω_s²·M
    speed = np.minimum(speed, np.minimum(ELASTIC_SHARE * swing, softer))  # both are inf for rigid gears
    return LoopBandwidths(frozen(speed), frozen(POSITION_SHARE * speed), frozen(INTEGRAL_SHARE * speed))


def standard_gains(robot: Mechanism, rates: Rates) -> CascadedGains:
    """Return gains with the standard bandwidths for an arm with drives.

    Below its electrical pole, the drive of a joint with inertia M takes u = ka·q̈ + ke·q̇; for a DC motor ka
    = R·M/(Kt·|G|) and ke = Ke·|G| + R·B·|G|/Kt, for an ideal one ka = M/|G| and ke = B·|G|. The speed gain
    sets the crossover ω_s, kv = ω_s·ka; the feed-forward gains are the two coefficients, so that the loops
    have to correct only deviations from the nominal drive: gravity, Coulomb friction, coupling of the joints.
    M is the geometric mean of the least and the greatest inertia of the axis over the range of the joints.
    Cascades with feed-forward of the reference: W. Leonhard, Control of Electrical Drives, 3rd ed., Springer
    2001.

    Raises:
        NoControllerError: X861, the arm has no drives.
    """
    return cascaded_gains(robot, standard_bandwidths(robot, rates))


def cascaded_gains(robot: Mechanism, bandwidths: LoopBandwidths) -> CascadedGains:
    """Return gains with given bandwidths for an arm with drives; see `standard_gains`."""
    inertia, _, _ = _inertias(robot)
    pairs = list(zip(robot.drives, robot.home.tolist(), strict=True))
    per_effort = np.array([steady_drive(drive, q, 0.0, 1.0).command for drive, q in pairs])
    viscous = [drive.ratio_at(q) ** 2 * drive.friction.viscous for drive, q in pairs]
    rows = zip(pairs, viscous, strict=True)
    per_speed = np.array([steady_drive(drive, q, 1.0, effort).command for (drive, q), effort in rows])
    per_acceleration = inertia * per_effort
    kv = bandwidths.speed * per_acceleration
    return CascadedGains(
        kp=bandwidths.position,
        kv=kv,
        ki=bandwidths.integral * kv,
        kf=np.ones(robot.n),
        ke=per_speed,
        ka=per_acceleration,
    )


@lru_cache(maxsize=16)
def _inertias(robot: Mechanism) -> tuple[Array, Array, Array]:
    """Return for which inertia each axis is designed, the least that it has, and how fast the arm swings.

    The least one is that while the other axes are free, behind an elastic gear that of the rotor alone; the
    arm swings on elastic gears with motors held, `elastic_frequencies` [rad/s].
    """
    Q = configurations(robot, SAMPLES)
    inertias = axis_inertias(robot, Q)
    free = np.where(elastic_axes(robot), rotor_inertias(robot, Q)[0], free_inertias(robot, Q).min(axis=0))
    design = np.sqrt(inertias.min(axis=0) * inertias.max(axis=0))
    return design, free, elastic_frequencies(robot, Q)


def cascade_statement(robot: Mechanism, rates: Rates) -> str:
    """Return how the gains come about."""
    bandwidths = standard_bandwidths(robot, rates)
    speed, position, integral = (
        span(values) for values in (bandwidths.speed, bandwidths.position, bandwidths.integral)
    )
    return (
        f"from masses, gears and motors of the model: speed loops {speed} rad/s, "
        f"position loops {position} rad/s, integral action {integral} rad/s; speed and acceleration "
        f"fed forward{elastic_words(_inertias(robot)[2])}"
    )
