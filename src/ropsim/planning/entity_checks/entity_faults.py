"""Entities of a user that fail: reported as a refusal of the move, at its line."""

from collections.abc import Callable
from pathlib import Path
from traceback import extract_tb
from typing import TypeVar

from ropsim.core import Diagnostic, Severity, Span, define
from ropsim.flow import MoveInstruction
from ropsim.planning.records.entities import Refusal

ENTITY_FAILS = define(
    "C603",
    "entity-fails",
    Severity.ERROR,
    "a planner, interpolator, inverse transform, path corrector or sensor of your own does not do its work",
    """
An entity of the controller that you have put into the chain, or a path of your own, raised an exception or
returned what nobody can follow: arrays of another shape, numbers that are not finite, a path that begins or
ends elsewhere, derivatives that are not those of its poses. The move is skipped and the program goes on, so
that one run shows every such line. Where a path corrector fails, the move goes on with the shift that it has;
where a sensor fails, its reading counts as not valid, and this is reported once for each channel and line.

The message names the entity and what it did. docs/how-to/own-planner.md says what each entity is given and
has to return.
""",
)

T = TypeVar("T")
_HINT = "docs/how-to/own-planner.md says what each entity is given and has to return"


def guarded(
    entity: object, work: Callable[[], T], kinds: tuple[type, ...], move: MoveInstruction
) -> T | Refusal:
    """Return the result of an entity, or its failure; exceptions of built-in entities are not caught.

    Args:
        entity: who works.
        work: calls it.
        kinds: allowed results other than a refusal.
        move: the move in hand.
    """
    try:
        answer = work()
        if isinstance(answer, Refusal):
            return with_reason(entity, answer, move)
        if isinstance(answer, kinds):
            return answer
        wanted = " or ".join(kind.__name__ for kind in kinds)
        return refused(entity, f"returned a `{type(answer).__name__}` instead of a {wanted}", move)
    except Exception as error:  # any exception of a user's code is reported
        if is_our_own(entity):
            raise
        return refused(entity, raised(error), move)


def raised(error: Exception) -> str:
    """Return the description of an exception, with its place."""
    frames = extract_tb(error.__traceback__)
    location = f" ({Path(frames[-1].filename).name}, line {frames[-1].lineno})"
    return f"raised {type(error).__name__}: {error}{location}"


def with_reason(entity: object, refusal: Refusal, move: MoveInstruction) -> Refusal:
    """Return a refusal; C603 at the line of the move in the place of one that says nothing.

    Args:
        entity: who refused.
        refusal: its answer.
        move: that it refused.
    """
    if refusal.diagnostics and are_findings(refusal.diagnostics):
        return refusal
    return refused(entity, "refused the move without a Diagnostic that says why", move)


def are_findings(found: object) -> bool:
    """Return whether something is a tuple of diagnostics."""
    return isinstance(found, tuple) and all(isinstance(one, Diagnostic) for one in found)


def is_our_own(entity: object) -> bool:
    """Return whether the code of an entity, function or path is that of the package."""
    module = getattr(entity, "__module__", None) or type(entity).__module__
    return module.partition(".")[0] == "ropsim"


def foreign_of(maker: object, path: object) -> object | None:
    """Return the object responsible for a path: the path or its maker; None if both are built in.

    Args:
        maker: who made it.
        path: its result.
    """
    return next((one for one in (path, maker) if not is_our_own(one)), None)


def refused(entity: object, found: str, move: MoveInstruction) -> Refusal:
    """Return C603 at the line of a move.

    Args:
        entity: who did it.
        found: description of the fault.
        move: the move in hand.
    """
    return Refusal((entity_fails(entity, found, move.origin.span),))


def entity_fails(entity: object, found: str, span: Span | None) -> Diagnostic:
    """Return C603 at a line.

    Args:
        entity: who did it.
        found: description of the fault.
        span: of the line at which it worked.
    """
    message = f"`{getattr(entity, '__name__', type(entity).__name__)}` {found}"
    return ENTITY_FAILS.at(span, message, hint=_HINT)
