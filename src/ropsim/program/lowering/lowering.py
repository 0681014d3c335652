"""Structured program (SIR) -> ICR: its procedures, put together."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace

from ropsim import icr
from ropsim.core import Diagnostic
from ropsim.program.calls import recursion
from ropsim.program.lowering.linking import (
    axes_of,
    axes_with_starts,
    declared_of,
    draft_of,
    findings_of,
    linked,
    placed_lines,
    started,
)
from ropsim.program.lowering.procedure import Lowered, lower_control, lower_task
from ropsim.program.lowering.usage import joint_usage
from ropsim.program.program import Program
from ropsim.program.scope import Known
from ropsim.program.source_map import SourceMap


def lower(program: Program, source: str) -> icr.Program:
    """Return the ICR of a structured program; see `lower_with_findings`."""
    return lower_with_findings(program, source)[0]


def lower_with_findings(program: Program, source: str) -> tuple[icr.Program, tuple[Diagnostic, ...]]:
    """Return the ICR of a structured program, which passes `icr.verify`, and findings for its author.

    The findings name variables that may be read before they have a value (T391, T392).
    Tasks that `main` does not reach are left out; the others stand in the order of their first call.
    Variables that could be read before they have a value start with the zero of their type.

    Args:
        program: a sound structured program without recursion.
        source: name of the text; statements whose span is in it record their line.

    Raises:
        LoweringError: the program contradicts itself.
    """
    known = Known.by(program)
    lowered = _lowered(program, known)
    if any(one.has_guessed_axes for one in lowered.values()):
        known = replace(known, axes=axes_of(lowered.values()) or 1)
        lowered = _lowered(program, known)
    places = SourceMap(source)
    drafts = {name: draft_of(one) for name, one in lowered.items()}
    is_sound = not recursion(program.tasks)
    needs = icr.unassigned(icr.Program(program.name, tuple(drafts.values()))) if is_sound else {}
    axes = axes_of(lowered.values())
    made = []
    findings: tuple[Diagnostic, ...] = ()
    for name, one in lowered.items():
        missing = needs.get(name, ())
        findings += findings_of(one, missing, known.globals, places)
        procedure = started(drafts[name], missing, known.globals, axes)
        made.append(replace(procedure, lines=placed_lines(one, procedure, places)))
    pairs = zip(lowered.values(), made, strict=True)
    axes = axes_with_starts(axes, (one.code[: len(one.code) - len(draft.code)] for draft, one in pairs))
    usage, variables = joint_usage(lowered.values()), declared_of(program.main_locals)
    return linked(program, usage, tuple(made), axes, variables, source), findings


def _lowered(program: Program, known: Known) -> dict[str, Lowered]:
    main = lower_control(known, program.main, program.frame, program.tool)
    tasks: dict[str, Lowered] = {}

    def callees(name: str) -> tuple[str, ...]:
        tasks[name] = lower_task(known, known.tasks[name])
        return tasks[name].callees

    return {one.name: one for one in (main, *(tasks[name] for name in reached(main.callees, callees)))}


def reached(first: Iterable[str], callees: Callable[[str], Sequence[str]]) -> Iterator[str]:
    """Yield the tasks that are called and their callees, depth first.

    Args:
        first: tasks that the control statements call.
        callees: returns the callees of a task, in order.
    """
    work = list(reversed(tuple(first)))
    seen = set()
    while work:
        name = work.pop()
        if name not in seen:
            seen.add(name)
            called = callees(name)
            yield name
            work += reversed(called)
