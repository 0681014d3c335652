"""Coarse and fine interpolation: lines or cubics of the joints between the interpolation ticks."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt

from ropsim.flow import JointReference
from ropsim.model import Rates
from ropsim.planning.records.entities import FineInterpolation
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.spatial import Array, record


@record
class _Spans:
    """A motion in k spans between interpolation ticks, with the place of each of m control ticks in them.

    Attributes:
        of: number of the span of each control tick, shape (m,).
        u: share of the span that is over at each control tick, in (0, 1], shape (m, 1).
        T: times of the spans [s], shape (k, 1).
        q: coordinates at their begins [rad | m], shape (k, n).
        qd: speeds there, shape (k, n).
        change: of the coordinates on them, shape (k, n).
        qd_end: speeds at their ends, shape (k, n).
    """

    of: npt.NDArray[np.intp]
    u: Array
    T: Array
    q: Array
    qd: Array
    change: Array
    qd_end: Array


def fine_by(fine: FineInterpolation, chain: MotionChain) -> MotionChain:
    """Return a chain whose joint interpolator takes the path at interpolation ticks only.

    Args:
        fine: what it puts between them.
        chain: the entities.
    """
    return replace(chain, fine=fine)


def lines(reference: JointReference, q_start: Array, rates: Rates) -> JointReference:
    """Return the references of a motion with lines between its interpolation ticks.

    They are off the trajectory by at most a·T²/8 with the interpolation period T; their speed goes in steps,
    and the acceleration that is fed forward is the second difference of the coordinates, held for a period.

    Args:
        reference: at the control ticks 1, 2, … of the motion, at rest with the last one.
        q_start: joint coordinates at its start [rad | m], shape (n,).
        rates: of the controller.

    References:
        de Boor 1978, A Practical Guide to Splines, chapter III, for the bound.
    """
    spans = _spans(reference, q_start, rates)
    if spans is None:
        return reference
    of, change = spans.of, spans.change
    speed = change / spans.T
    acceleration = np.diff(speed, axis=0, prepend=np.zeros((1, speed.shape[1]))) / spans.T
    return _at_rest(reference, spans.q[of] + spans.u * change[of], speed[of], acceleration[of])


def cubics(reference: JointReference, q_start: Array, rates: Rates) -> JointReference:
    """Return the references of a motion with cubics between its interpolation ticks.

    They have coordinates and speeds of the trajectory at their ends, and are off it by at most T⁴/384 times
    its fourth derivative, with the interpolation period T.

    Args:
        reference: at the control ticks 1, 2, … of the motion, at rest with the last one.
        q_start: joint coordinates at its start [rad | m], shape (n,).
        rates: of the controller.

    References:
        de Boor 1978, A Practical Guide to Splines, chapter IV, for the bound.
    """
    spans = _spans(reference, q_start, rates)
    if spans is None:
        return reference
    of, u, T, change = spans.of, spans.u, spans.T, spans.change
    a, b = spans.qd * T, spans.qd_end * T
    c2, c3 = 3.0 * change - 2.0 * a - b, a + b - 2.0 * change
    q = spans.q[of] + u * (a[of] + u * (c2[of] + u * c3[of]))
    qd = (a[of] + u * (2.0 * c2[of] + u * 3.0 * c3[of])) / T[of]
    return _at_rest(reference, q, qd, (2.0 * c2[of] + 6.0 * u * c3[of]) / T[of] ** 2)


def _spans(reference: JointReference, q_start: Array, rates: Rates) -> _Spans | None:
    """Return the spans of a motion; None where each control tick ends one, or nothing moves."""
    every = rates.interpolation_ticks
    if every == 1 or reference.ticks == 0:
        return None
    ends = np.append(np.arange(every, reference.ticks, every), reference.ticks)
    ticks = np.diff(ends, prepend=0)
    of = np.repeat(np.arange(len(ends)), ticks)
    u = ((np.arange(reference.ticks) + 1 - (ends - ticks)[of]) / ticks[of])[:, None]
    q_to, qd_to = reference.q[ends - 1], reference.qd[ends - 1]
    q_from, qd_from = np.vstack((q_start, q_to[:-1])), np.vstack((np.zeros_like(q_start), qd_to[:-1]))
    return _Spans(of, u, (ticks * rates.control_period)[:, None], q_from, qd_from, q_to - q_from, qd_to)


def _at_rest(reference: JointReference, *rows: Array) -> JointReference:
    """Return references that end as the motion does; q, qd and qdd are given, each of shape (m, n)."""
    q, qd, qdd = (np.ascontiguousarray(one) for one in rows)
    q[-1], qd[-1], qdd[-1] = reference.q[-1], 0.0, 0.0
    return JointReference(q, qd, qdd)
