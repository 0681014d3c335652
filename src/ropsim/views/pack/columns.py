"""Columns of a pack: how one quantity over time becomes a few bytes.

Three codes: a constant; steps, which hold from exact times on; and a smooth column, rounded to whole
multiples of a step of which only the second differences are kept, because they are small for a mechanism.
"""

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array

LEVELS = 4096
"""A smooth column has at least this many levels between its extremes."""

_LEAST = float(np.finfo(np.float64).tiny)
"""Finest step, so that nothing is divided by 0."""

STILL = 1e-3
"""A column that moves by less than this share of its unit's step is a constant: that is rounding."""

GREATEST = 2.0**40
"""Largest whole number that a column may reach; a coarser step is taken beyond."""

Code = dict[str, object]
Whole = npt.NDArray[np.int64]


@dataclass(slots=True)
class Body:
    """The bytes after the header of a pack, growing; equal columns are kept once."""

    parts: list[bytes] = field(default_factory=list)
    length: int = 0
    known: dict[bytes, int] = field(default_factory=dict)

    def add(self, content: bytes) -> int:
        """Return the offset at which the content stands."""
        if content not in self.known:
            self.known[content] = self.length
            self.parts.append(content)
            self.length += len(content)
        return self.known[content]

    def content(self) -> bytes:
        """Return all bytes."""
        return b"".join(self.parts)


def steps(times: Array, values: Array) -> Code:
    """Return the code of a column that holds its value from each change until the next one.

    Args:
        times: of the changes [s], shape (m,), ascending.
        values: from each one on, shape (m,), in the unit of the column; infinite and NaN values become gaps.
    """
    held = [float(value) if np.isfinite(value) else None for value in values]
    if len(held) == 1:
        return {"kind": "constant", "value": held[0]}
    return {"kind": "steps", "times": times.tolist(), "values": held}


def smooth(values: Array, step: float, body: Body) -> Code:
    """Return the code of a column that is linear between its samples.

    The error is at most half the step that is taken: `step`, or a finer one where the column would have
    fewer than `LEVELS` levels.

    Args:
        values: shape (n,), in the unit of the column; infinite and NaN values become gaps.
        step: coarsest rounding, in that unit.
        body: gets the bytes.
    """
    known = np.isfinite(values)
    if not known.any():
        return {"kind": "constant", "value": None}
    low, high = float(values[known].min()), float(values[known].max())
    if known.all() and high - low <= STILL * step:
        return {"kind": "constant", "value": low if low == high else (low + high) / 2.0}
    if high > low:
        step = min(step, (high - low) / LEVELS)
    step = max(step, max(abs(low), abs(high)) / GREATEST, _LEAST)
    whole = np.round(_held(values, known) / step).astype(np.int64)
    content = varints(zigzag(second_differences(whole)))
    return {
        "kind": "smooth",
        "step": step,
        "offset": body.add(content),
        "length": len(content),
        "gaps": _gaps(known),
    }


def second_differences(whole: Whole) -> Whole:
    """Return the second differences of a sequence that stood at 0 before; shape (n,)."""
    return np.diff(whole, n=2, prepend=np.zeros(2, np.int64))


def zigzag(whole: Whole) -> npt.NDArray[np.uint64]:
    """Return 0, -1, 1, -2 … as 0, 1, 2, 3 …, so that small numbers of either sign are short."""
    return ((whole << 1) ^ (whole >> 63)).view(np.uint64)


def varints(numbers: npt.NDArray[np.uint64]) -> bytes:
    """Return the numbers as LEB128: seven bits a byte, the lowest first, the high bit set but in the last."""
    width = np.ones(len(numbers), np.int64)
    for k in range(1, 10):
        width += numbers >= np.uint64(1 << (7 * k))
    ends = np.cumsum(width)
    out = np.zeros(int(ends[-1]) if len(ends) else 0, np.uint8)
    for k in range(int(width.max(initial=0))):
        has = width > k
        seven = (numbers[has] >> np.uint64(7 * k)) & np.uint64(0x7F)
        more = np.where(width[has] > k + 1, 0x80, 0)
        out[(ends - width)[has] + k] = seven.astype(np.uint8) | more.astype(np.uint8)
    return out.tobytes()


def _held(values: Array, known: npt.NDArray[np.bool_]) -> Array:
    """Return the values with gaps filled by the value before; before the first value by that one."""
    last = np.maximum.accumulate(np.where(known, np.arange(len(values)), -1))
    return np.asarray(values[np.where(last < 0, int(np.argmax(known)), last)])


def _gaps(known: npt.NDArray[np.bool_]) -> list[list[int]]:
    """Return the ranges [i, j) that have no value."""
    edges = np.flatnonzero(np.diff(np.concatenate([[True], known, [True]])))
    return [[int(i), int(j)] for i, j in edges.reshape(-1, 2)]
