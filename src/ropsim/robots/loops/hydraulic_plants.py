"""Hydraulic axes about many rests and slow motions: how rods and forces answer to their valves, by frequency.

Each chamber has p' = β/V·(K_q·x - K_c·p ∓ A·v ∓ L·(p_a - p_b)), K_q and K_c being the slopes of the flow
into it over the opening and the pressure (H. E. Merritt: Hydraulic Control Systems, Wiley 1967, chapter 6),
and the masses of the arm couple the axes. Dry friction is left out: it would damp loops at rest only.
"""

from dataclasses import replace

import numpy as np
import numpy.typing as npt

from ropsim.dynamics import flow_into, gravity_loads, mass_matrices, steady_drive
from ropsim.model import Drive, Hydraulic, HydraulicCylinder, HydraulicVane, Linkage, Mechanism
from ropsim.spatial import Array, record

Complex = npt.NDArray[np.complex128]

SLOW = 0.05
"""Speed of slow motions over that at the rated flow: beyond speeds at which leak and motion cancel."""
_SMALL = 1e-4
"""Half of a difference of openings; over the supply, of pressures."""
_NEWTON, _MOST_STEP = 12, 0.2
"""Steps to a steady state, and the most of one, in supply pressures and openings."""
_ROWS = ("area_a", "area_b", "soft_a", "soft_b", "leak", "open_a", "open_b", "close_a", "close_b")


@record
class HydraulicPlants:
    """Plants about k rests and slow motions, at f frequencies, of n axes.

    Those of a place stand together: at rest, then all axes forward, then all back, then others.

    Attributes:
        s: i·ω [rad/s], shape (f,), complex.
        rods: places of rods or motors over the openings [m | rad], shape (k, f, n, n), complex.
        forces: of them [N | N·m], the same.
        gains: speed that an opening of 1 gives, steadily [m/s | rad/s], shape (k, n).
        springs: of the oil at the rods [N/m | N·m/rad], shape (k, n).
        ratios: of the transmissions, shape (k, n).
        swings: frequencies at which each axis alone swings on its oil [rad/s], shape (k, n).
        ways: plants of a place.
    """

    s: Complex
    rods: Complex
    forces: Complex
    gains: Array
    springs: Array
    ratios: Array
    swings: Array
    ways: int

    def chosen(self, which: Array) -> "HydraulicPlants":
        """Return some of the plants, by number."""
        names = ("rods", "forces", "gains", "springs", "ratios", "swings")
        return replace(self, **{name: getattr(self, name)[which] for name in names})


def hydraulic_plants(robot: Mechanism, Q: Array, hz: Array, period: float) -> HydraulicPlants:
    """Return the plants of an arm whose axes are all hydraulic, at rest and in slow motion.

    Outputs of a law hold over a control tick.

    Args:
        robot: the arm.
        Q: its places [rad | m], shape (k, n).
        hz: frequencies [Hz], shape (f,).
        period: control period [s].
    """
    n, ways = robot.n, _ways(robot.n)
    masses, weights = mass_matrices(robot, Q), gravity_loads(robot, Q)
    made = [
        [_axis(*one) for one in zip(robot.drives, place.tolist(), load.tolist(), way, strict=True)]
        for place, load in zip(Q, weights, strict=True)
        for way in ways
    ]
    rows = np.array([[one[:-2] for one in axes] for axes in made])
    ratios, viscous = (np.array([[one[k] for one in axes] for axes in made]) for k in (-2, -1))
    numbers = dict(zip(_ROWS, np.moveaxis(rows, -1, 0), strict=True))
    s = np.asarray(2j * np.pi * hz)
    chambers = {name: value[:, np.newaxis, :] for name, value in numbers.items()}
    by_opening, by_speed = _forces(chambers, s[np.newaxis, :, np.newaxis])
    valves = np.array([_valve(drive.motor, s) for drive in robot.drives]).T * _held(s, period)[:, np.newaxis]
    G = ratios[:, np.newaxis, :]
    inertia = np.repeat(masses, len(ways), axis=0)[:, np.newaxis]
    damping = (G * G * (by_speed + viscous[:, np.newaxis, :]))[..., np.newaxis] * np.eye(n)
    system = inertia * (s * s)[:, np.newaxis, np.newaxis] + damping * s[:, np.newaxis, np.newaxis]
    push = (by_opening * valves)[..., np.newaxis] * np.eye(n)
    rods = G[..., np.newaxis] * np.linalg.solve(system, G[..., np.newaxis] * push)
    forces = push - (by_speed * s[:, np.newaxis])[..., np.newaxis] * rods
    springs = numbers["soft_a"] * numbers["area_a"] ** 2 + numbers["soft_b"] * numbers["area_b"] ** 2
    of_a = numbers["soft_a"] * numbers["area_a"] * numbers["open_a"]
    of_b = numbers["soft_b"] * numbers["area_b"] * numbers["open_b"]
    swings = np.abs(ratios) * np.sqrt(springs / np.einsum("kii->ki", inertia[:, 0]))
    return HydraulicPlants(s, rods, forces, (of_a - of_b) / springs, springs, ratios, swings, len(ways))


def _ways(n: int) -> list[tuple[float, ...]]:
    """Return the ways in which axes move: 0 at rest, 1 forward, -1 back."""
    alike, turned = [(0.0,) * n, (1.0,) * n, (-1.0,) * n], tuple((-1.0) ** k for k in range(n))
    return alike if n == 1 else [*alike, turned, tuple(-one for one in turned)]


def _forces(c: dict[str, Array], s: Complex) -> tuple[Complex, Complex]:
    """Return the force over the opening, and over minus the speed, of both chambers."""
    aa, ab = s + c["soft_a"] * (c["close_a"] + c["leak"]), -c["soft_a"] * c["leak"]
    ba, bb = -c["soft_b"] * c["leak"], s + c["soft_b"] * (c["close_b"] + c["leak"])
    det = aa * bb - ab * ba

    def force(into_a: Array, into_b: Array) -> Complex:
        a, b = (bb * into_a - ab * into_b) / det, (aa * into_b - ba * into_a) / det
        return np.asarray(c["area_a"] * a - c["area_b"] * b)

    opened = force(c["soft_a"] * c["open_a"], c["soft_b"] * c["open_b"])
    return opened, force(c["soft_a"] * c["area_a"], -c["soft_b"] * c["area_b"])


def _axis(drive: Drive, q: float, weight: float, way: float) -> tuple[float, ...]:
    """Return the numbers of `_ROWS`, the ratio, and viscous friction at the rod."""
    motor, gear = drive.motor, drive.transmission
    assert isinstance(motor, Hydraulic)
    motor = replace(motor, overlap=0.0)
    ratio, viscous = drive.ratio_at(q), float(drive.friction.viscous)
    if isinstance(motor, HydraulicCylinder):
        area_a, area_b = motor.area_a, motor.area_b
        out = gear.out_at(q) if isinstance(gear, Linkage) else ratio * q
        volumes = motor.volumes(min(max(out, 0.0), motor.stroke))
    else:
        area_a = area_b = motor.displacement
        volumes = (
            motor.volumes(ratio * q) if isinstance(motor, HydraulicVane) else (motor.chamber_volume,) * 2
        )
    speed = way * SLOW * motor.rated_flow / area_a
    tight = replace(drive, motor=replace(motor, null_flow=0.0))
    a, b, opening = steady_drive(tight, q, speed / ratio, weight).states[:3]
    if motor.null_flow:
        a, b, opening = _leaking(motor, (area_a, area_b), weight / ratio, speed, (b, opening))
    h, dp = _SMALL, _SMALL * motor.supply_pressure
    if opening:
        h = min(h, 0.5 * abs(opening)) if not motor.null_flow else h
    open_a = (flow_into(motor, a, opening + h) - flow_into(motor, a, opening - h)) / (2.0 * h)
    open_b = (flow_into(motor, b, -opening - h) - flow_into(motor, b, -opening + h)) / (2.0 * h)
    close_a = (flow_into(motor, a - dp, opening) - flow_into(motor, a + dp, opening)) / (2.0 * dp)
    close_b = (flow_into(motor, b - dp, -opening) - flow_into(motor, b + dp, -opening)) / (2.0 * dp)
    soft_a, soft_b = (motor.bulk_modulus / volume for volume in volumes)
    numbers = (area_a, area_b, soft_a, soft_b, motor.leakage, open_a, open_b, close_a, close_b)
    return (*numbers, ratio, viscous)


def _leaking(
    motor: Hydraulic, areas: tuple[float, float], force: float, speed: float, start: tuple[float, float]
) -> tuple[float, float, float]:
    """Return pressures and opening in steady motion with edges that leak, by Newton's method.

    Args:
        motor: with its valve.
        areas: of both chambers.
        force: that it gives.
        speed: of rod or shaft.
        start: pressure of chamber b, and opening, without leaks.
    """
    area_a, area_b = areas

    def left(b: float, x: float) -> Array:
        a = (force + area_b * b) / area_a
        leak = motor.leakage * (a - b)
        into_a = flow_into(motor, a, x) - leak - area_a * speed
        return np.array([into_a, flow_into(motor, b, -x) + leak + area_b * speed])

    unit = np.array([motor.supply_pressure, 1.0])
    found = np.array(start) / unit
    for _ in range(_NEWTON):
        b, x = (found * unit).tolist()
        now = left(b, x)
        slopes = np.column_stack(
            [(left(b + _SMALL * unit[0], x) - now) / _SMALL, (left(b, x + _SMALL) - now) / _SMALL]
        )
        found = found - np.clip(np.linalg.solve(slopes, now), -_MOST_STEP, _MOST_STEP)
    b, x = (found * unit).tolist()
    return (force + area_b * b) / area_a, b, x


def _valve(motor: object, s: Complex) -> Complex:
    assert isinstance(motor, Hydraulic)
    natural = motor.natural_frequency
    return np.asarray(natural**2 / (s * s + 2.0 * motor.damping_ratio * natural * s + natural**2))


def _held(s: Complex, period: float) -> Complex:
    """Return how an output that holds over a tick acts."""
    return np.asarray((1.0 - np.exp(-s * period)) / (s * period))
