"""Whether the bodies of a knowledge base compile in a cell: what the language says, at their clauses."""

from collections.abc import Iterator, Mapping

from ropsim.core import Diagnostic, Span
from ropsim.language import Environment, TaskForm, TaskSignature, compile
from ropsim.tasks.base import KnowledgeBase
from ropsim.tasks.diagnostics import NO_COMPILING
from ropsim.tasks.errors import TaskError
from ropsim.tasks.kinds import UNITS as UNITS_OF
from ropsim.tasks.known_task import KnownTask
from ropsim.tasks.program_text import UNITS, needed
from ropsim.tasks.task_text import task_text


def body_findings(base: KnowledgeBase, environment: Environment) -> tuple[Diagnostic, ...]:
    """Return a finding for each error of the bodies of a project, and of the library as far as these call it.

    Args:
        base: of the project.
        environment: the cell for which the bodies are compiled.
    """
    findings: list[Diagnostic] = []
    lines: list[str] = ["program bodies", f"units {UNITS}"]
    owners: list[KnownTask | None] = [None, None]
    own = [task.name for task in base.tasks() if not task.is_built_in]
    for task in _reached(base, own):
        try:
            text = task_text(task).splitlines()
        except TaskError as error:
            findings.append(error.diagnostic)
            continue
        lines += text
        owners += [task] * len(text)
    compiled = compile("\n".join(lines), environment) if own else None
    for found in compiled.diagnostics if compiled else ():
        line = found.span.line - 1 if found.span else 0
        task_there = owners[line] if line < len(owners) else None
        if found.is_error and task_there is not None and not _is_untold(found, findings):
            message = f"the body of `{task_there.name}` does not compile: {found.message}"
            notes = (f"its text there: {lines[line].strip()}",)
            findings.append(NO_COMPILING.at(_begin(task_there), message, notes=notes, hint=found.hint))
    return tuple(findings)


def signatures(base: KnowledgeBase, environment: Environment) -> Mapping[str, TaskSignature]:
    """Return all tasks that compile in a cell, as `Environment.tasks` has them: programs call them by name.

    Args:
        base: of the project.
        environment: the cell for which the bodies are compiled.
    """
    found: dict[str, TaskSignature] = {}
    for name in base.names:
        try:
            reached = needed(base.task, [name])
            text = "\n\n".join([f"program bodies\nunits {UNITS}", *map(task_text, reached)])
        except TaskError:
            continue
        compiled = compile(text, environment)
        if compiled.ok and compiled.program is not None:
            made = {task.name: task for task in compiled.program.tasks}
            found[name] = TaskSignature(made[name], _dimensions(compiled.tasks[name]))
    return found


def _dimensions(form: TaskForm) -> Mapping[str, str]:
    """Return what a bare number means for each parameter that has a dimension."""
    return {one.name: one.type for one in form.parameters if one.type in UNITS_OF}


def _begin(task: KnownTask) -> Span:
    """Return where the clause of a task begins, as far as its name."""
    span = task.span
    return Span.on_line(span.source, span.line, span.column, len(f"task({task.name}"))


def _is_untold(found: Diagnostic, findings: list[Diagnostic]) -> bool:
    """Return whether an error only says that a task is missing whose own finding stands already."""
    return found.code == "N201" and bool(findings)


def _reached(base: KnowledgeBase, names: list[str]) -> Iterator[KnownTask]:
    """Yield the tasks of these names and all that they call; calls of nothing have their finding already."""
    seen: set[str] = set()
    for name in names:
        try:
            reached = needed(base.task, [name])
        except TaskError:
            task = base.task(name)
            reached = (task,) if task is not None else ()
        for one in reached:
            if one.name not in seen:
                seen.add(one.name)
                yield one
