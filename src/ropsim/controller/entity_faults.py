"""Entities of a user that fail: told as a refusal of the move, at its line."""

import math
from collections.abc import Callable
from pathlib import Path
from traceback import extract_tb
from typing import TypeVar

import numpy as np

from ropsim.controller.entities import Refusal
from ropsim.core import Diagnostic, Severity, define
from ropsim.flow import JointSamples, MoveInstruction
from ropsim.motion import JointPath, JointPoints
from ropsim.spatial import Array

ENTITY_FAILS = define(
    "C603",
    "entity-fails",
    Severity.ERROR,
    "a path planner, interpolator or inverse transform of your own does not do its work",
    """
An entity of the controller that you have put into the chain raised an exception, or what came out of the
chain is no reference for this arm: three arrays of the same shape (ticks, n) with finite numbers. The move is
skipped and the program goes on, so that one run shows every such line.

The message names the entity and what it did. docs/how-to/own-planner.md says what each entity is given and
has to return.
""",
)

T = TypeVar("T")
_LOOKS = 9
"""Places at which a path is looked at before it is used."""
_JUMP = 1e-6
"""Largest distance of the start of a path from where the arm is [rad | m]."""
_HINT = "docs/how-to/own-planner.md says what each entity is given and has to return"


def guarded(
    entity: object, work: Callable[[], T], kinds: tuple[type, ...], move: MoveInstruction
) -> T | Refusal:
    """Return what an entity answers, or that it failed; a fault of our own entities is not caught.

    Args:
        entity: who works.
        work: asks it.
        kinds: what it may answer beside a refusal.
        move: what it works on.
    """
    try:
        answer = work()
        if isinstance(answer, (*kinds, Refusal)):
            return answer
        wanted = " or ".join(kind.__name__ for kind in kinds)
        return _refused(entity, f"returned a `{type(answer).__name__}` instead of a {wanted}", move)
    except Exception as error:  # whatever the code of a user raises is told
        if type(entity).__module__.partition(".")[0] == "ropsim":
            raise
        frames = extract_tb(error.__traceback__)
        place = f" ({Path(frames[-1].filename).name}, line {frames[-1].lineno})"
        return _refused(entity, f"raised {type(error).__name__}: {error}{place}", move)


def unusable_samples(
    entity: object, samples: JointSamples, q_start: Array, move: MoveInstruction
) -> Refusal | None:
    """Return why joint samples cannot be followed, None where they can.

    Args:
        entity: who returned them.
        samples: what it returned.
        q_start: where the arm stands, shape (n,).
        move: what it is for.
    """
    q, n = np.asarray(samples.q), len(q_start)
    if q.ndim != 2 or q.shape[1] != n or len(q) < 2:
        return _refused(entity, f"returned `q` of shape {q.shape} instead of (2 or more, {n})", move)
    if not np.isfinite(q).all():
        return _refused(entity, "returned `q` with numbers that are not finite", move)
    return None


def unusable_path(entity: object, path: JointPath, q_start: Array, move: MoveInstruction) -> Refusal | None:
    """Return why a path of the joints cannot be followed, None where it can.

    Args:
        entity: who returned it.
        path: what it returned.
        q_start: where the arm stands, shape (n,).
        move: what it is for.
    """
    length = float(path.length)
    if not (math.isfinite(length) and length > 0.0):
        return _refused(entity, f"returned a path of length {length:g}, allowed are numbers above 0", move)
    points = guarded(entity, lambda: path.joints(np.linspace(0.0, length, _LOOKS)), (JointPoints,), move)
    if isinstance(points, Refusal):
        return points
    shape = (_LOOKS, len(q_start))
    for name in ("q", "d1", "d2"):
        array = getattr(points, name)
        if array.shape != shape:
            return _refused(entity, f"returned `{name}` of shape {array.shape} instead of {shape}", move)
        if not np.isfinite(array).all():
            return _refused(entity, f"returned `{name}` with numbers that are not finite", move)
    jump = float(np.abs(points.q[0] - q_start).max())
    if jump > _JUMP:
        return _refused(entity, f"returned a path that begins {jump:.3g} rad | m from where the arm is", move)
    return None


def _refused(entity: object, found: str, move: MoveInstruction) -> Refusal:
    message = f"`{type(entity).__name__}` {found}"
    diagnostic: Diagnostic = ENTITY_FAILS.at(move.origin.span, message, hint=_HINT)
    return Refusal((diagnostic,))
