"""Zeros of joints: whether an axis has the same offset from the program at all stops."""

import math
from collections.abc import Sequence

import numpy as np

from ropsim.calibration.diagnostics import ZERO_BESIDE
from ropsim.calibration.trace.matching import Passage
from ropsim.calibration.trace.rests import Rests
from ropsim.core import Diagnostic
from ropsim.model import Joint, JointType
from ropsim.spatial import Array

_LEAST_TURN, _LEAST_SLIDE = math.radians(0.1), 1e-3
"""Amount from which an offset is reported [rad], [m]: encoders and tools always differ a little."""
_NOISE = 6.0
"""The same in steps of the encoders."""
_ALIKE = 0.25
"""Share of the amount by which half of the stops may differ from it."""


def zeros_beside(
    rests: Rests, ends: Array, passages: Sequence[Passage], joints: Sequence[Joint]
) -> tuple[Diagnostic, ...]:
    """Return X800 for each joint that is off by the same amount at most stops.

    The amount is the median over the stops, and half of these are within a quarter of it (median absolute
    deviation): a single point that was corrected on the robot is no zero.

    Args:
        rests: of the trace.
        ends: where the program stands, at its start and at the end of each sequence [rad | m], (k + 1, n).
        passages: which stops of the trace belong to sequences.
        joints: of the axes, n of them.
    """
    pairs = {one.start: one.sequence for one in passages} | {one.end: one.sequence + 1 for one in passages}
    off = rests.q[list(pairs)] - ends[list(pairs.values())]
    amounts = np.median(off, axis=0)
    apart = np.median(np.abs(off - amounts), axis=0)
    found = []
    for joint, amount, differs, noise in zip(joints, amounts, apart, rests.noise, strict=True):
        turns = joint.measure is JointType.REVOLUTE
        least = max(_LEAST_TURN if turns else _LEAST_SLIDE, _NOISE * noise)
        if abs(amount) < least or differs > _ALIKE * abs(amount):
            continue
        shown = f"{math.degrees(amount):+.2f}°" if turns else f"{amount * 1e3:+.2f} mm"
        found.append(
            ZERO_BESIDE.at(
                None,
                f"joint `{joint.name}` stands {shown} beside the program at {len(off)} stops of the trace",
                hint="adjust its zero in robot or model, or give the points as they are on the robot",
                data={"joint": joint.name, "offset": float(amount), "stops": len(off)},
            )
        )
    return tuple(found)
