"""Warnings where the body of a task and its effects differ, at their places in the text."""

from collections.abc import Iterable, Iterator

from ropsim.core import Diagnostic, Span
from ropsim.tasks.base import KnowledgeBase
from ropsim.tasks.bodies.body_effects import Unmade, Unsaid, differences
from ropsim.tasks.bodies.body_walk import Lack
from ropsim.tasks.findings.text_diagnostics import EFFECT_UNMADE, EFFECT_UNSAID, STEP_LACKS
from ropsim.tasks.terms.clause_text import term_text
from ropsim.tasks.terms.known_task import KnownTask

MOST_TOLD = 20
"""Maximum number of differences reported for one task."""


def effect_findings(base: KnowledgeBase, tasks: Iterable[KnownTask]) -> tuple[Diagnostic, ...]:
    """Return a warning for each difference between bodies of tasks and their headers.

    Args:
        base: of the project.
        tasks: of the knowledge base.
    """
    always = base.always
    found = (one for task in tasks for one in _of_task(base, task, always))
    return tuple(sorted(found, key=_begin))


def _begin(finding: Diagnostic) -> tuple[str, int, int]:
    span = finding.span
    return (span.source, span.line, span.column) if span else ("", 0, 0)


def _of_task(
    base: KnowledgeBase, task: KnownTask, always: frozenset[tuple[str, int]]
) -> Iterator[Diagnostic]:
    for one in differences(task, base.task, always)[:MOST_TOLD]:
        match one:
            case Unmade():
                yield _unmade(base, task, one)
            case Unsaid():
                yield _unsaid(base, task, one)
            case Lack():
                yield _lack(base, task, one)


def _unmade(base: KnowledgeBase, task: KnownTask, one: Unmade) -> Diagnostic:
    effect = f"{one.sign}{term_text(one.fact)}"
    message = f"no step of the body of `{task.name}` brings about `{effect}`"
    hint = f"let the body do it, or take `{effect}` out of `eff`"
    return EFFECT_UNMADE.at(_place(base, task, one.sign, (one.number,)), message, hint=hint)


def _unsaid(base: KnowledgeBase, task: KnownTask, one: Unsaid) -> Diagnostic:
    effects = [f"{effect.name}{term_text(effect.arguments[0])}" for effect in one.effects]
    words = ", ".join(f"`{effect}`" for effect in effects)
    message = f"the body of `{task.name}` leaves {words} behind, and its effects do not say so"
    hint = f"write {words} in `eff`, or let the body undo it"
    return EFFECT_UNSAID.at(_place(base, task, "body", one.step), message, hint=hint)


def _lack(base: KnowledgeBase, task: KnownTask, one: Lack) -> Diagnostic:
    words = ", ".join(f"`{term_text(fact)}`" for fact in one.facts)
    message = (
        f"this step of `{task.name}` calls `{one.task}`, which needs {words}: nothing before it gives that"
    )
    hint = f"write {words} in `pre`, or let a step before bring it about"
    return STEP_LACKS.at(_place(base, task, "body", one.step), message, hint=hint)


def _place(base: KnowledgeBase, task: KnownTask, part: str, path: tuple[int, ...]) -> Span:
    return base.term_place(task.name, part, path) or task.span
