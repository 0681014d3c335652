"""Linear blocks in discrete time: transfer functions of s converted to z, with their steady state."""

from math import tan

import numpy as np
from numpy.typing import ArrayLike

from ropsim.blockdiagram.blocks import Method, Notch, TransferFunction
from ropsim.core import frozen_dataclass
from ropsim.spatial import Array

_HALVINGS = 1.0 / 8.0
"""Norm of a matrix whose exponential series of 20 terms is exact to rounding."""
_NO_GAIN = 1e-12
"""Sum of the denominator over its largest coefficient: below it there is a pole at z = 1."""


@frozen_dataclass
class Filter:
    """A transfer function of z by its coefficients, the denominator beginning with 1; both of equal length.

    Attributes:
        b: of the numerator, the present input first.
        a: of the denominator.
        steady_gain: output over a constant input; None with a pole at z = 1.
    """

    b: tuple[float, ...]
    a: tuple[float, ...]
    steady_gain: float | None

    @property
    def order(self) -> int:
        """Return the number of its states."""
        return len(self.a) - 1


def notch_filter(block: Notch) -> Filter:
    """Return a notch in discrete time; its frequency is kept."""
    w, z = block.frequency, block.damping
    numerator, denominator = (1.0, 2.0 * block.depth * z * w, w * w), (1.0, 2.0 * z * w, w * w)
    return tustin_filter(numerator, denominator, w / tan(0.5 * w * block.sample_time))


def transfer_filter(block: TransferFunction) -> Filter:
    """Return a transfer function that is proper in discrete time."""
    denominator = np.array(block.denominator)
    numerator = np.concatenate((np.zeros(len(denominator) - len(block.numerator)), block.numerator))
    if block.method is Method.DISCRETE:
        return _filter(numerator, denominator)
    if block.method is Method.TUSTIN:
        return tustin_filter(numerator, denominator, 2.0 / block.sample_time)
    return _filter(*_held(numerator, denominator, block.sample_time))


def tustin_filter(numerator: ArrayLike, denominator: ArrayLike, rate: float) -> Filter:
    """Return a transfer function of s as one of z, with s = rate·(z - 1)/(z + 1).

    Args:
        numerator: coefficients of s, the highest power first, as many as those of the denominator.
        denominator: coefficients of s.
        rate: 2/T, or another one that keeps a certain frequency [1/s].
    """
    return _filter(_bilinear(np.array(numerator), rate), _bilinear(np.array(denominator), rate))


def _filter(b: Array, a: Array) -> Filter:
    b, a = b / a[0], a / a[0]
    total = float(a.sum())
    steady = float(b.sum()) / total if abs(total) > _NO_GAIN * float(np.abs(a).max()) else None
    return Filter(tuple(b.tolist()), tuple(a.tolist()), steady)


def _bilinear(polynomial: Array, rate: float) -> Array:
    order = len(polynomial) - 1
    made = np.zeros(order + 1)
    for power, coefficient in enumerate(polynomial[::-1].tolist()):
        term = np.array([coefficient * rate**power])
        for k in range(order):
            term = np.convolve(term, [1.0, -1.0] if k < power else [1.0, 1.0])
        made += term
    return made


def _held(numerator: Array, denominator: Array, period: float) -> tuple[Array, Array]:
    """Return the polynomials of z of a system whose input is held over each period.

    Its controllable canonical form is integrated exactly, and made a transfer function again by the
    characteristic polynomials of A and A - B·C.
    """
    a, b = denominator / denominator[0], numerator / denominator[0]
    order = len(a) - 1
    if order == 0:
        return b, np.ones(1)
    A, B = np.eye(order, k=-1), np.zeros((order, 1))
    A[0], B[0, 0] = -a[1:], 1.0
    C, through = (b[1:] - b[0] * a[1:])[None, :], float(b[0])
    whole = np.zeros((order + 1, order + 1))
    whole[:order, :order], whole[:order, order:] = A * period, B * period
    moved = exponential(whole)
    F, G = moved[:order, :order], moved[:order, order:]
    poles = np.real(np.poly(F))
    return np.real(np.poly(F - G @ C)) + (through - 1.0) * poles, poles


def exponential(matrix: Array) -> Array:
    """Return the exponential of a square matrix, by its series and repeated squaring."""
    norm = float(np.abs(matrix).sum(axis=1).max(initial=0.0))
    halvings = max(0, int(np.ceil(np.log2(norm / _HALVINGS)))) if norm > _HALVINGS else 0
    small = matrix / 2.0**halvings
    term = total = np.eye(len(matrix))
    for k in range(1, 21):
        term = term @ small / k
        total = total + term
    for _ in range(halvings):
        total = total @ total
    return total
