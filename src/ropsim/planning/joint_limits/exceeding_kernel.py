"""Control ticks at which limits are exceeded, and what a motion does there, in loops for numba."""

from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.motion import rows_at
from ropsim.spatial import Array


@kernel
def exceeding(
    used: Array2, allowed: float, phi: Array1, spans: Array2, ticks: Array1, result: Array2
) -> None:
    """Write the ticks, without 0, at which a limit is exceeded, and which of them lie in spans.

    Args:
        used: of the limits, shape (4, k).
        allowed: what may be used, 1 and rounding.
        phi: nominal times of the ticks, rising [s], shape (k,).
        spans: nominal times behind which a span begins and up to which it goes [s], shape (r, 2 or more).
        ticks: where the numbers of the ticks go, shape (k,).
        result: becomes the index in `ticks` of the first one in each span and that after the last, (r, 2).
    """
    count = 0
    for k in range(1, phi.shape[0]):
        if max(used[0, k], used[1, k], used[2, k], used[3, k]) > allowed:
            ticks[count] = k
            count += 1
    for span in range(spans.shape[0]):
        for end in range(2):
            low, high = 0, count
            while low < high:
                middle = (low + high) // 2
                if phi[int(ticks[middle])] <= spans[span, end]:
                    low = middle + 1
                else:
                    high = middle
            result[span, end] = low


class SectionLaw(NamedTuple):
    """Time law of a section.

    Attributes:
        segments: see `TimeLaw`, shape (8, m).
        duration: of it [s].
        start: nominal time at which it begins [s].
        begins: path parameters at which its path segments begin, shape (p or more,).
    """

    segments: Array2
    duration: float
    start: float
    begins: Array1


class ReferenceRows(NamedTuple):
    """References of the joints at k control ticks.

    Attributes:
        phi: nominal times, rising [s], shape (k,).
        q: joint coordinates [rad | m], shape (k, n).
        qd: speeds [rad/s | m/s], of the same shape.
        qdd: accelerations [rad/s² | m/s²], of the same shape.
    """

    phi: Array1
    q: Array2
    qd: Array2
    qdd: Array2


class AtTicks(NamedTuple):
    """Results of `evaluate_section` for b ticks.

    Attributes:
        law: rows of the time law, those of the ticks before first, and below them the jerk behind each of
            these times, shape (5, 2·b).
        parameters: path parameters on the whole section, shape (2, b).
        motion: coordinates and speeds at the ticks, shape (2, b, n).
        accelerations: at the ticks before and at the ticks, shape (2, b, n).
    """

    law: Array2
    parameters: Array2
    motion: Array3
    accelerations: Array3


@kernel
def evaluate_section(
    section: SectionLaw, reference: ReferenceRows, ticks: Array1, times: Array1, out: AtTicks
) -> None:
    """Write the path parameter of a section and the references of the joints at ticks and the ticks before.

    Args:
        section: the time law.
        reference: at all control ticks.
        ticks: numbers of b of them, none of them 0, shape (b,).
        times: work, shape (2·b,).
        out: the results.
    """
    b, law = ticks.shape[0], out.law
    for k in range(b):
        tick = int(ticks[k])
        times[k] = reference.phi[tick - 1] - section.start
        times[b + k] = reference.phi[tick] - section.start
        for j in range(reference.q.shape[1]):
            out.motion[0, k, j], out.motion[1, k, j] = reference.q[tick, j], reference.qd[tick, j]
            out.accelerations[0, k, j] = reference.qdd[tick - 1, j]
            out.accelerations[1, k, j] = reference.qdd[tick, j]
    rows_at(section.segments, section.duration, times, law)
    _jerks_at(section.segments, section.duration, times, law[4])
    for k in range(b):
        out.parameters[0, k] = section.begins[int(law[0, k])] + law[1, k]
        out.parameters[1, k] = section.begins[int(law[0, b + k])] + law[1, b + k]


def _jerks_at(segments: Array, duration: float, times: Array, jerks: Array) -> None:
    """Write the jerk behind each time, 0 outside of the motion."""
    row, last = 0, segments.shape[1] - 1
    for k in range(times.shape[0]):
        while row > 0 and segments[1, row] > times[k]:
            row -= 1
        while row < last and segments[1, row + 1] <= times[k]:
            row += 1
        jerks[k] = segments[5, row] if 0.0 <= times[k] < duration else 0.0
