"""Stability margins of an axis, and how its loop follows sines."""

from math import inf, nan, pi

import numpy as np

from ropsim.simulation.response.linear_loop import LinearLoop
from ropsim.spatial import Array, frozen, record

LOWEST = 0.05
"""Least frequency at which a loop is looked at [Hz]."""
FREQUENCIES = 3000
"""Between that and half of the control rate, evenly by their logarithms."""
_HALF_POWER = 0.5**0.5
_DEPENDENT = 1e9
"""Condition of eigenvectors from which on they are nearly dependent: half of the digits are left."""


@record
class Margins:
    """What a loop bears until it oscillates, with the loop open at the drive of one axis.

    K. J. Åström, R. M. Murray: Feedback Systems, 2nd ed., Princeton 2021, section 10.3.

    Attributes:
        stable: whether the closed loop is; the margins of one that is not mean nothing and are NaN.
        gain: least factor by which a greater gain makes it oscillate; inf where none does.
        gain_hz: at this frequency [Hz]; NaN where none does.
        lower_gain: greatest factor below 1 by which a smaller gain makes it oscillate; 0 where none does.
        phase: least further lag at which it oscillates [rad]; inf where the gain is nowhere 1.
        phase_hz: at this frequency [Hz]; NaN where the gain is nowhere 1.
        delay: time by which the output may act later [s]; inf where the gain is nowhere 1.
        sensitivity: largest magnitude of 1/(1 + L), Ms.
        sensitivity_hz: at this frequency [Hz].
    """

    stable: bool
    gain: float
    gain_hz: float
    lower_gain: float
    phase: float
    phase_hz: float
    delay: float
    sensitivity: float
    sensitivity_hz: float


UNSTABLE = Margins(
    stable=False,
    gain=nan,
    gain_hz=nan,
    lower_gain=nan,
    phase=nan,
    phase_hz=nan,
    delay=nan,
    sensitivity=nan,
    sensitivity_hz=nan,
)


@record
class FrequencyResponse:
    """How an axis follows a sine of its reference coordinate.

    Attributes:
        hz: frequencies [Hz], shape (k,).
        gain: amplitude over that of the reference, shape (k,).
        phase: lead over the reference [rad], continuous, shape (k,).
    """

    hz: Array
    gain: Array
    phase: Array

    @property
    def bandwidth(self) -> float:
        """Return the lowest frequency with an amplitude 3 dB below the reference [Hz]; NaN for none."""
        below = np.flatnonzero(self.gain < _HALF_POWER)
        if not len(below):
            return nan
        last = int(below[0])
        if last == 0:
            return float(self.hz[0])
        x, y = np.log(self.hz[last - 1 : last + 1]), self.gain[last - 1 : last + 1]
        return float(np.exp(x[0] + (_HALF_POWER - y[0]) * (x[1] - x[0]) / (y[1] - y[0])))


def natural_modes(loop: LinearLoop) -> tuple[Array, Array]:
    """Return frequencies [Hz] and damping ratios of the closed loop that oscillate, the slowest first."""
    return _modes(loop.closed()[0], loop.period)


def plant_modes(loop: LinearLoop) -> tuple[Array, Array]:
    """Return frequencies [Hz] and damping ratios at which an arm and its drives swing without a law."""
    return _modes(loop.F, loop.period)


def _modes(A: Array, period: float) -> tuple[Array, Array]:
    """Return frequencies and damping ratios of x⁺ = A·x that oscillate, the slowest first."""
    poles = np.linalg.eigvals(A)
    rates = np.log(poles[(np.abs(poles) > 0.0) & (poles.imag > 0.0)]) / period
    rates = rates[np.argsort(np.abs(rates))]
    return frozen(np.abs(rates) / (2.0 * pi)), frozen(-rates.real / np.abs(rates))


def is_stable(loop: LinearLoop) -> bool:
    """Return whether all poles of the closed loop decay."""
    return float(np.abs(np.linalg.eigvals(loop.closed()[0])).max()) < 1.0


def frequency_response(loop: LinearLoop, axis: int, hz: Array | None = None) -> FrequencyResponse:
    """Return how an axis follows sines of its reference coordinate, all others held.

    Reference speed and acceleration are 0, as in a step: what is fed forward for them has no part in it.

    Args:
        loop: about a rest.
        axis: its number, from 0.
        hz: frequencies [Hz], shape (k,), rising; None for those of `Margins`.
    """
    chosen = _frequencies(loop.period) if hz is None else hz
    A, B = loop.closed()
    c = np.zeros(len(A))
    c[axis] = 1.0
    values = _transfer(A, B[:, axis], c, _on_circle(chosen, loop.period))
    return FrequencyResponse(frozen(chosen), frozen(np.abs(values)), frozen(np.unwrap(np.angle(values))))


def margins(loop: LinearLoop, axis: int) -> Margins:
    """Return the margins of the loop of an axis, the loops of all others closed.

    Args:
        loop: about a rest.
        axis: its number, from 0.
    """
    if not is_stable(loop):
        return UNSTABLE
    hz = _frequencies(loop.period)
    z = _on_circle(hz, loop.period)
    A, b, c = loop.broken(axis)
    return _judged(-_transfer(A, b, c, z) * z**-loop.delay, hz)


def margins_of_all(loop: LinearLoop) -> tuple[Margins, ...]:
    """Return the margins of the loops of all axes, each as `margins` does, from their sensitivities.

    A value added to the input of a drive while all loops are closed arrives there 1/(1 + L)-fold, with the
    loop L that is open there alone. In the eigenvectors of the closed loop that takes no equations; where
    these are nearly dependent each axis is treated separately.

    Args:
        loop: about a rest.
    """
    A, _ = loop.closed()
    if not np.abs(np.linalg.eigvals(A)).max() < 1.0:
        return (UNSTABLE,) * loop.n
    inputs, outputs = np.zeros((len(A), loop.n)), loop.given()
    inputs[: len(loop.F)] = loop.G
    A, inputs, outputs = _between(A, inputs, outputs)
    poles, V = np.linalg.eig(A)
    sizes = np.abs(V).max(axis=1)
    if not (sizes.min() and np.linalg.cond(V / sizes[:, np.newaxis]) <= _DEPENDENT):
        return tuple(margins(loop, axis) for axis in range(loop.n))
    residues = (outputs @ V) * np.linalg.solve(V / sizes[:, np.newaxis], inputs / sizes[:, np.newaxis]).T
    hz = _frequencies(loop.period)
    reached = 1.0 + residues @ (1.0 / (_on_circle(hz, loop.period) - poles[:, np.newaxis]))
    return tuple(_judged(one, hz) for one in 1.0 / reached - 1.0)


def _between(A: Array, B: Array, C: Array) -> tuple[Array, Array, Array]:
    """Return the part of z⁺ = A·z + B·v that v reaches and C·z sees.

    A law remembers much that follows from its reference alone, in chains of ticks without eigenvectors.
    """
    on = np.asarray(A != 0.0) | np.eye(len(A), dtype=np.bool_)
    reached, seen = np.any(B != 0.0, axis=1), np.any(C != 0.0, axis=0)
    for _ in range(len(A)):
        reached, seen = np.any(on[:, reached], axis=1), np.any(on[seen], axis=0)
    kept = reached & seen
    return A[np.ix_(kept, kept)], B[kept], C[:, kept]


def _judged(opened: Array, hz: Array) -> Margins:
    """Return the margins of an open loop at frequencies [Hz], the closed one being stable."""
    inverse = 1.0 / np.abs(1.0 + opened)
    most = int(inverse.argmax())
    factors, at = _crossings(opened, hz)
    more, fewer = factors > 1.0, factors < 1.0
    gain = float(factors[more].min()) if more.any() else inf
    lags, places = _lags(opened, hz)
    least = int(lags.argmin()) if len(lags) else -1
    return Margins(
        stable=True,
        gain=gain,
        gain_hz=float(at[more][factors[more].argmin()]) if more.any() else nan,
        lower_gain=float(factors[fewer].max()) if fewer.any() else 0.0,
        phase=float(lags[least]) if len(lags) else inf,
        phase_hz=float(places[least]) if len(lags) else nan,
        delay=float((lags / (2.0 * pi * places)).min()) if len(lags) else inf,
        sensitivity=float(inverse[most]),
        sensitivity_hz=float(hz[most]),
    )


def _frequencies(period: float) -> Array:
    return np.geomspace(LOWEST, 0.5 / period, FREQUENCIES)


def _on_circle(hz: Array, period: float) -> Array:
    return np.asarray(np.exp(2j * pi * hz * period))


def _transfer(A: Array, b: Array, c: Array, z: Array) -> Array:
    """Return c·(z·I - A)⁻¹·b at each z, shape (k,), complex."""
    systems = z[:, np.newaxis, np.newaxis] * np.eye(len(A)) - A
    right = np.broadcast_to(b.astype(complex)[:, np.newaxis], (len(z), len(b), 1))
    return np.asarray(np.linalg.solve(systems, right)[:, :, 0] @ c)


def _crossings(opened: Array, hz: Array) -> tuple[Array, Array]:
    """Return the factors on the gain with which a loop passes through -1, and their frequencies [Hz]."""
    side = opened.imag.copy()
    side[-1] = 0.0  # half of the control rate: the loop is real there
    places = np.flatnonzero(
        (side[:-1] * side[1:] <= 0.0) & (opened.real[:-1] < 0.0) & (opened.real[1:] < 0.0)
    )
    share = _share(side[places], side[places + 1])
    real = opened.real[places] + share * (opened.real[places + 1] - opened.real[places])
    return np.asarray(-1.0 / real), np.asarray(hz[places] + share * (hz[places + 1] - hz[places]))


def _lags(opened: Array, hz: Array) -> tuple[Array, Array]:
    """Return the further lags with which a loop passes through -1 [rad], and their frequencies [Hz]."""
    size = np.log(np.abs(opened))
    places = np.flatnonzero(size[:-1] * size[1:] <= 0.0)
    share = _share(size[places], size[places + 1])
    values = opened[places] + share * (opened[places + 1] - opened[places])
    lags = np.mod(np.angle(values) + pi, 2.0 * pi)
    return np.asarray(lags), np.asarray(hz[places] + share * (hz[places + 1] - hz[places]))


def _share(before: Array, behind: Array) -> Array:
    """Return at which share of the way between two values that have not the same sign they are 0."""
    way = before - behind
    return np.asarray(np.divide(before, way, out=np.zeros_like(before), where=way != 0.0))
