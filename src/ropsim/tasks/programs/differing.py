"""Tasks that a program has of its own, and a knowledge base under the same name otherwise."""

from collections.abc import Mapping

from ropsim.core import Diagnostic, SourceText, Span
from ropsim.language import formatted
from ropsim.tasks.base import KnowledgeBase
from ropsim.tasks.findings.text_diagnostics import DIFFERS
from ropsim.tasks.kinds import TaskError
from ropsim.tasks.programs.compiling import place_of
from ropsim.tasks.programs.task_text import task_text


def differing_tasks(
    base: KnowledgeBase, program: SourceText, own: Mapping[str, Span]
) -> tuple[Diagnostic, ...]:
    """Return a finding for each task of a program that is another one in the knowledge base.

    A generated program holds copies of tasks; differences are reported as soon as the knowledge base changes.
    Tasks of the library that comes with ropsim do not count: Fig. 5 of the task-language paper has three of
    its own.

    Args:
        base: of the project.
        program: the text.
        own: where its tasks stand, by their names.
    """
    found: list[Diagnostic] = []
    for name, span in own.items():
        known = base.task(name)
        if known is None or known.is_built_in:
            continue
        try:
            same = _form(task_text(known)) == _form(_lines(program, span))
        except TaskError:
            same = False
        if not same:
            there = place_of(known)
            message = f"the task `{name}` of the program hides the one of {there}, which is another one"
            hint = "leave it out to call that one, or give it another name"
            found.append(DIFFERS.at(Span.whole_line(program.name, span.line), message, hint=hint))
    return tuple(found)


def _lines(text: SourceText, span: Span) -> str:
    return "\n".join(text.lines[span.line - 1 : span.end_line])


def _form(text: str) -> list[str]:
    """Return the statements of a task in the one form of a text, without comments."""
    lines = (line.partition("#")[0].rstrip() for line in formatted(text).splitlines())
    return [line for line in lines if line]
