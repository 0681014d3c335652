"""Entities of a user that fail: told as a refusal of the move, at its line."""

from collections.abc import Callable
from pathlib import Path
from traceback import extract_tb
from typing import TypeVar

import numpy as np

from ropsim.controller.entities import Refusal
from ropsim.core import Diagnostic, Severity, define
from ropsim.flow import JointReference, MoveInstruction
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


def unusable(
    entity: object, reference: JointReference, q_start: Array, move: MoveInstruction
) -> Refusal | None:
    """Return why what came out of the chain cannot be followed, None where it can.

    Args:
        entity: the last one of the chain.
        reference: what it returned.
        q_start: where the arm stands, shape (n,).
        move: what it is for.
    """
    shape = (reference.ticks, len(q_start))
    for name in ("q", "qd", "qdd"):
        array = getattr(reference, name)
        if array.shape != shape:
            return _refused(entity, f"returned `{name}` of shape {array.shape} instead of {shape}", move)
        if not np.isfinite(array).all():
            return _refused(entity, f"returned `{name}` with numbers that are not finite", move)
    return None


def _refused(entity: object, found: str, move: MoveInstruction) -> Refusal:
    message = f"`{type(entity).__name__}` {found}"
    diagnostic: Diagnostic = ENTITY_FAILS.at(move.origin.span, message, hint=_HINT)
    return Refusal((diagnostic,))
