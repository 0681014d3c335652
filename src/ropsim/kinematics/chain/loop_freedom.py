"""Whether the closed chains of a mechanism leave its axes, and only these, free.

A mechanism has as many axes as freedoms: each coordinate is an axis, follows axes by a coupling, or is
determined by a closed chain. The last is a question of rank: of the slopes of the residuals between the
frames of the cuts, at the home position, by the coordinates that the chains are to determine. Counting
directions that are held (Grübler, Kutzbach) does not answer it: it takes a planar linkage in space for stiff.
"""

from collections.abc import Iterator

import numpy as np

from ropsim.core import Diagnostic, plural
from ropsim.kinematics.chain.closed_arrays import NUDGE, ClosedArrays
from ropsim.kinematics.chain.closure import APART, closure
from ropsim.kinematics.chain.tree_arrays import tree_arrays
from ropsim.kinematics.diagnostics import LOOP_LOOSE, LOOP_OPEN, LOOP_STUCK
from ropsim.model import Mechanism
from ropsim.spatial import Array

LEAST = 1e-7
"""Slopes whose singular value is below this share of the largest one count as none."""


def loop_freedom(mechanism: Mechanism) -> tuple[Diagnostic, ...]:
    """Return the reasons why closed chains do not follow the axes, at the home position.

    Args:
        mechanism: without contradictions (`ropsim.model.mechanism_findings`).

    Returns:
        M553 where the chains cannot be closed at home, M554 for each axis that they hold, M555 where they
        leave coordinates free that no axis moves. Nothing without closed chains.
    """
    tree = tree_arrays(mechanism)
    return tuple(_found(mechanism, tree.loops)) if tree.loops is not None else ()


def _found(mechanism: Mechanism, loops: ClosedArrays) -> Iterator[Diagnostic]:
    left, slopes = closure(loops, mechanism.home)
    apart, rank = _most(left), _rank(slopes)
    if apart > APART:
        yield LOOP_OPEN.at(
            None,
            f"closed chains of `{mechanism.name}` stay {apart:.3g} (m, rad) apart in the home position",
            hint="correct the frames of the cut, or the home position",
        )
        return
    for number, joint in enumerate(mechanism.axis_joints):
        nudge = NUDGE * np.eye(mechanism.n)[number]
        beside = [closure(loops, mechanism.home + way * nudge) for way in (1.0, -1.0)]
        rank = max(rank, *(_rank(other) for _, other in beside))  # the home position may be a dead centre
        if min(_most(rest) for rest, _ in beside) > APART:
            yield LOOP_STUCK.at(
                None,
                f"axis `{joint.name}` of `{mechanism.name}` cannot move: closed chains hold it",
                hint="a cut may hold directions that its joint leaves free",
            )
    loose = loops.p - rank
    if loose:
        free = plural(loose, "coordinate")
        yield LOOP_LOOSE.at(
            None,
            f"closed chains of `{mechanism.name}` leave {free} free that no axis moves",
            hint="make them axes, couple them, or let the cut hold more directions",
        )


def _most(left: Array) -> float:
    return float(np.abs(left).max(initial=0.0))


def _rank(slopes: Array) -> int:
    values = np.linalg.svd(slopes, compute_uv=False)
    return int((values > LEAST * max(values.max(initial=0.0), 1.0)).sum())
