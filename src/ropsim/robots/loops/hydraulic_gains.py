"""Gains of hydraulic axes by a rule: as large as the margins of the loops allow, wherever the arm stands.

The loops are those of `hydraulic_plants`, at many places, at rest and in slow motion; of each axis the
margins are taken with the loops of all others closed (K. J. Åström, R. M. Murray: Feedback Systems, 2nd ed.,
Princeton 2021, section 10.3). Gains grow from nearly none, where loops are stable, until a margin is used up.
"""

from collections.abc import Callable
from functools import lru_cache
from itertools import product
from math import inf

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.kinematics import configurations, jacobian
from ropsim.model import FlowGains, Hydraulic, Mechanism, PiGains, Rates
from ropsim.robots.loops.elastic_gears import span
from ropsim.robots.loops.hydraulic_plants import Complex, HydraulicPlants, hydraulic_plants
from ropsim.spatial import Array

PLACES = 25
"""Configurations of the arm."""
_HARDEST = 5
"""Plants at each look of which gains are found; all are looked at in the end."""


@frozen_dataclass
class LoopMargins:
    """The least margins of some loops.

    Attributes:
        gain: least factor on the gain of an axis by which it oscillates.
        sensitivity: largest magnitude of 1/(1 + L), Ms.
        peak: largest amplitude of an axis over that of a sine of its reference.
    """

    gain: float
    sensitivity: float
    peak: float = inf

    def suffice(self, needed: "LoopMargins") -> bool:
        """Return whether they are as good as others."""
        is_far = self.gain >= needed.gain and self.sensitivity <= needed.sensitivity
        return is_far and self.peak <= needed.peak


FLOW_NEEDS = LoopMargins(3.0, 1.5, 1.15)
"""Of the law of flow, load and damping: room for a model that is wrong, for a load, and little overshoot."""
PI_NEEDS = LoopMargins(2.4, 1.7)
"""Of parallel PI loops."""
INTEGRAL = 0.1
"""Corner of the integral action over kp, or over the mean crossover of PI loops: less lets an axis creep home
after a stop, more lets it overshoot."""
CORNER = 1.0 / 6.0
"""Corner of the low pass of the force over kp."""
_SHARES = (0.3, 0.4, 0.55)
"""Tried values of kp over the rate of damping."""
_SWINGS = (0.2, 0.25, 0.33, 0.42)
"""Tried values of kp over the frequency at which an axis swings."""
_MOST_ENDS, _INSIDE = 4, 0.98
"""Axes whose ranges have all their ends combined, and how far out, over half of a range."""
_LESS = 0.95
"""Gains are lowered by this until all plants have their margins."""
_SINGULAR = 0.1
"""Directions in which a tip moves less, over that in which it moves most, are no ways of a path."""
_LEAST, _MOST = 0.1, 1000.0
"""Rates between which gains are looked for [1/s]."""
_RATES: tuple[float, ...] = tuple(np.geomspace(_LEAST, _MOST, 41).tolist())
_HALVINGS = 4
"""Of the way between two of them."""
_LOOKS = (2.0, 8.0, 32.0)
"""Rates at which the hardest plants are looked for [1/s]."""
_LOWEST, _FREQUENCIES = 0.1, 100
"""Lowest frequency [Hz], and how many up to half of the control rate."""


Loops = Callable[[HydraulicPlants, float], tuple[Complex, Complex]]
"""Gains at a rate to what opens the valves for each rod, and for each force, shape (k, f, n)."""


def flow_gains(robot: Mechanism, rates: Rates) -> FlowGains:
    """Return the gains of the law of flow, load and damping for an arm whose axes are all hydraulic.

    kp, and the share of the frequency of the swing to which it is bound, are the largest over the work space
    that leave a gain margin of 3, Ms <= 1.5 and a peak of 1.15, with the damping that helps them most.
    """
    kp, kd, swing = _flow_rates(robot, rates)
    ones, lag = np.ones(robot.n), np.array([_lag(drive.motor) for drive in robot.drives])
    return FlowGains(
        kp=kp * ones,
        ki=INTEGRAL * kp**2 * ones,
        kd=kd * ones,
        corner=CORNER * kp * ones,
        lead=lag + 0.5 * rates.control_period,
        swing=swing * ones,
    )


def parallel_pi_gains(robot: Mechanism, rates: Rates, places: Array | None = None) -> PiGains:
    """Return the gains of parallel PI loops for an arm whose axes are all hydraulic.

    They let the axes lag as nearly alike as they can, so that a tip that moves in any direction is late and
    little beside its path, and are the largest such gains with a gain margin of 2.4 and Ms <= 1.7.

    Args:
        robot: the arm.
        rates: of its controller.
        places: where it works [rad | m], shape (k, n); None for all of its range.
    """
    Q = _places(robot) if places is None else places
    plants = _plants(robot, rates, Q)
    speeds = np.abs(plants.gains / plants.ratios).reshape(len(Q), plants.ways, robot.n)
    mean = np.exp(np.log(speeds).mean(axis=(0, 1)))  # rad/s at an opening of 1
    shares = _alike(robot, Q, speeds[:, 1:3] / mean, plants.ratios[:: plants.ways])

    def loops(some: HydraulicPlants, rate: float) -> tuple[Complex, Complex]:
        corners = 1.0 + INTEGRAL * rate * shares / some.s[:, np.newaxis]
        by_rod = corners * (rate * shares / mean) / np.abs(some.ratios)[:, np.newaxis, :]
        return by_rod, np.zeros_like(by_rod)

    rate = _largest(_hardest(plants, loops), loops, PI_NEEDS)
    while not _margins(plants, loops, rate).suffice(PI_NEEDS) and rate > _LEAST:
        rate *= _LESS
    motors = [drive.motor for drive in robot.drives]
    rated = np.array([motor.rated_input for motor in motors if isinstance(motor, Hydraulic)])
    kp = rate * shares / mean * rated
    return PiGains(kp, INTEGRAL * rate * shares * kp)


def _alike(robot: Mechanism, Q: Array, speeds: Array, ratios: Array) -> Array:
    """Return shares of the crossover with which lags push the tip least off its way, shape (n,).

    An axis at q̇ lags by q̇/(c·v) under a P loop; what these lags of all axes do to the tip beside its way, at
    all places and in many directions, has the least mean square.

    Args:
        robot: the arm.
        Q: places, shape (k, n).
        speeds: v of each axis forward and back, over its mean, shape (k, 2, n).
        ratios: of the transmissions, shape (k, n).
    """
    ways, found = list[tuple[Array, Array]](), np.ones(robot.n)
    for q, v, G in zip(Q, speeds, ratios, strict=True):
        J = jacobian(robot, q)[:3]
        for t in _directions(J):
            qd = np.linalg.pinv(J, rcond=_SINGULAR) @ t
            lags = qd / np.where(qd * G > 0.0, v[0], v[1])
            ways.append((J - np.outer(t, t @ J), lags))

    def beside(shares: Array) -> float:
        return float(sum(np.sum((across @ (lags / shares)) ** 2) for across, lags in ways))

    for step in (1.2, 1.05, 1.01) if len(ways) else ():
        for axis in [*range(1, robot.n)] * 3:
            tries = [found * np.where(np.arange(robot.n) == axis, step**k, 1.0) for k in range(-4, 5)]
            found = min(tries, key=lambda shares: beside(shares / shares.max()))
    return np.asarray(found / np.exp(np.log(found).mean()))


def _directions(J: Array) -> list[Array]:
    """Return directions into which a tip can move."""
    U, sizes, _ = np.linalg.svd(J)
    basis = U[:, : int((sizes > _SINGULAR * sizes[0]).sum())] if sizes[0] > 0.0 else U[:, :0]
    signs = [np.array(one) for one in product((-1.0, 0.0, 1.0), repeat=basis.shape[1]) if any(one)]
    return [basis @ one / np.linalg.norm(one) for one in signs] if basis.shape[1] > 1 else []


def pi_statement(gains: PiGains) -> str:
    """Return how the gains come about."""
    return (
        "parallel PI loops of hydraulic axes that lag as nearly alike as they can, as quick as a gain margin "
        f"of {PI_NEEDS.gain:g} and Ms <= {PI_NEEDS.sensitivity:g} allow over the work space: "
        f"{span(gains.kp)} A/rad"
    )


def flow_statement(gains: FlowGains) -> str:
    """Return how the gains come about."""
    return (
        "flow, load and damping of hydraulic axes by their model; loops as quick as a gain margin of "
        f"{FLOW_NEEDS.gain:g}, Ms <= {FLOW_NEEDS.sensitivity:g} and a peak of {FLOW_NEEDS.peak:g} allow over "
        f"the work space: {gains.kp[0]:.3g} rad/s, at most {gains.swing[0]:g} of the swing of an axis on its "
        f"oil, which is damped at {gains.kd[0]:.3g}/s"
    )


@lru_cache(maxsize=16)
def _flow_rates(robot: Mechanism, rates: Rates) -> tuple[float, float, float]:
    """Return kp and kd [1/s], and the share of the frequency of the swing."""
    plants, best, most = _plants(robot, rates, _places(robot)), (_LEAST, 0.0, 1.0), 0.0
    pairs = [(0.0, 1.0), *product((1.0 / share for share in _SHARES), _SWINGS)]
    hard = _hardest(plants, *(_flow_loops(*pairs[k]) for k in (0, 1, -1)))
    for damping, swing in pairs:
        loops = _flow_loops(damping, swing)
        better = [one for one in _RATES if _mean(plants, one, swing) > most]
        if not (better and _margins(hard, loops, better[0]).suffice(FLOW_NEEDS)):
            continue
        rate = _largest(hard, loops, FLOW_NEEDS)
        while not _margins(plants, loops, rate).suffice(FLOW_NEEDS) and rate > _LEAST:
            rate *= _LESS
        mean = _mean(plants, rate, swing)
        if mean > most and rate > _LEAST:
            rate = min(rate, float(swing * plants.swings.max()))
            best, most = (rate, damping * rate, swing), mean
    return best


def _mean(plants: HydraulicPlants, rate: float, swing: float) -> float:
    """Return the mean of kp over all plants, bound by the swing of an axis."""
    return float(np.minimum(rate, swing * plants.swings).mean())


def _places(robot: Mechanism) -> Array:
    """Return configurations over the range of an arm, and where axes are near the ends of their ranges."""
    found, low, high = configurations(robot, PLACES), robot.lower_limits, robot.upper_limits
    if not np.isfinite(high - low).all():
        return found
    signs = np.array(list(product((-1.0, 1.0), repeat=min(robot.n, _MOST_ENDS))))
    ends = np.ones((len(signs), robot.n))
    ends[:, : signs.shape[1]] = signs
    return np.vstack((found, 0.5 * (high + low) + _INSIDE * 0.5 * (high - low) * ends))


def _flow_loops(damping: float, swing: float) -> Loops:
    """Return the loops of the law with kp = rate and kd = damping·rate, bound by the swing of an axis."""

    def at(some: HydraulicPlants, rate: float) -> tuple[Complex, Complex]:
        s, kp = some.s[:, np.newaxis], np.minimum(rate, swing * some.swings)[:, np.newaxis, :]
        per_speed = 1.0 / some.gains[:, np.newaxis, :]
        by_rod = (kp + INTEGRAL * kp**2 / s) * per_speed
        passed = s / (s + CORNER * kp)
        return by_rod, damping * kp / some.springs[:, np.newaxis, :] * passed * per_speed

    return at


def _plants(robot: Mechanism, rates: Rates, Q: Array) -> HydraulicPlants:
    hz = np.geomspace(_LOWEST, 0.5 * rates.control_hz, _FREQUENCIES)
    return hydraulic_plants(robot, Q, hz, rates.control_period)


def _lag(motor: object) -> float:
    assert isinstance(motor, Hydraulic)
    return 2.0 * motor.damping_ratio / motor.natural_frequency


def _hardest(plants: HydraulicPlants, *kinds: Loops) -> HydraulicPlants:
    """Return the plants that bear least under some loops, at some rates."""
    found = set[int]()
    for loops in kinds:
        for rate in _LOOKS:
            gain, *peaks = _of_each(plants, loops, rate)
            for order in (np.argsort(gain), *(np.argsort(-one) for one in peaks)):
                found |= {*order[:_HARDEST].tolist()}
    return plants.chosen(np.array(sorted(found)))


def _largest(plants: HydraulicPlants, loops: Loops, needed: LoopMargins) -> float:
    """Return the largest rate up to which margins suffice."""
    last, beyond = _LEAST, _MOST
    for rate in _RATES:
        if not _margins(plants, loops, rate).suffice(needed):
            beyond = rate
            break
        last = rate
    for _ in range(_HALVINGS):
        between = (last * beyond) ** 0.5
        last, beyond = (
            (between, beyond) if _margins(plants, loops, between).suffice(needed) else (last, between)
        )
    return float(last)


def _margins(plants: HydraulicPlants, loops: Loops, rate: float) -> LoopMargins:
    gain, sensitivity, peak = _of_each(plants, loops, rate)
    return LoopMargins(float(gain.min()), float(sensitivity.max()), float(peak.max()))


def _of_each(plants: HydraulicPlants, loops: Loops, rate: float) -> tuple[Array, Array, Array]:
    """Return gain margin, Ms and peak of each plant, the worst of its axes."""
    by_rod, by_force = loops(plants, rate)
    opened = by_rod[..., np.newaxis] * plants.rods + by_force[..., np.newaxis] * plants.forces
    n = opened.shape[-1]
    inverse = np.linalg.inv(np.eye(n) + opened)
    closed = inverse[..., range(n), range(n)]  # 1/(1 + L) of each axis, the others closed
    sensitivity = np.abs(closed).max(axis=(1, 2))
    alone = 1.0 / closed - 1.0
    real, side = alone.real, alone.imag
    cross = (side[:, 1:] * side[:, :-1] <= 0.0) & (real[:, 1:] < 0.0) & (real[:, :-1] < 0.0)
    share = side[:, :-1] / np.where(side[:, :-1] == side[:, 1:], 1.0, side[:, :-1] - side[:, 1:])
    there = -(real[:, :-1] + share * (real[:, 1:] - real[:, :-1]))
    factors = np.where(cross, 1.0 / np.maximum(there, 1e-12), np.inf)
    worst = np.where(factors < 1.0, 1.0 / np.maximum(factors, 1e-12), factors)  # how far off either way
    through = np.einsum("kfij,kfji->kfi", plants.rods, inverse) * by_rod
    peak = np.abs(through).max(axis=(1, 2))
    return worst.min(axis=(1, 2)), sensitivity, peak
