"""`ropsim task`: the knowledge base of a project on the command line."""

import argparse
import math
import textwrap
from collections.abc import Iterator, Mapping, Sequence

from ropsim.cli.terminal.output import Output
from ropsim.cli.terminal.progress import Progress
from ropsim.core import Diagnostic
from ropsim.prolog import Prolog
from ropsim.records import diagnostic_document
from ropsim.tasks import (
    SHORT,
    CallReport,
    KnownTask,
    Parameter,
    TaskCall,
    WorldState,
    default_text,
    group_of,
    grouped,
    not_defined,
    program_text,
    task_text,
    term_text,
    title_of,
    unchecked_text,
    version_of,
)
from ropsim.workbench import Knowledge, open_knowledge

COLUMNS = 80
"""Width to which descriptions are wrapped."""


def list_(options: argparse.Namespace, output: Output) -> int:
    """List the tasks of a project, of the user and of the library, in groups."""
    known = open_knowledge(options.path, Prolog(options.prolog))
    tasks = known.base.tasks()
    code = output.findings(known.findings, known.texts)
    width = max(len(_head(one)) for one in tasks)
    groups = grouped(tasks)
    for group, some in groups.items():
        output.text(title_of(group))
        for one in some:
            place = "library" if one.is_built_in else one.span
            output.text(f"  {_head(one):{width}}  {version_of(one)[:SHORT]:{SHORT}}  {place}")
    entries = [_entry(one) for some in groups.values() for one in some]
    output.document({"ok": code == 0, "tasks": entries, **diagnostic_document(known.findings)})
    return code


def show(options: argparse.Namespace, output: Output) -> int:
    """Print a task."""
    known = open_knowledge(options.path, Prolog(options.prolog))
    task = known.base.task(options.name)
    if task is None:
        found = (*known.findings, not_defined(options.name, known.base.names))
        code = output.findings(found, known.texts)
        output.document({"ok": False, **diagnostic_document(found)})
        return code
    text = task_text(task)
    lines = [_head(task), *textwrap.wrap(task.doc, COLUMNS), "", *_parameters(task)]
    lines += [f"{'version':8} {version_of(task)[:SHORT]}"]
    for word, terms in (("needs", task.needs), ("adds", task.adds), ("removes", task.removes)):
        lines += [f"{word:8} {term_text(one)}" for one in terms]
    lines += [f"{'geometry':8} {term_text(one)}" for one in task.geometry]
    body = [line for line in text.splitlines() if not line.startswith("#")]
    output.text("\n".join([*lines, "", *body]))
    output.document({**_entry(task), "text": text})
    return 0


def check(options: argparse.Namespace, output: Output) -> int:
    """Say of each call whether it is possible."""
    known = open_knowledge(options.path, Prolog(options.prolog))
    reports = known.base.check_all(options.calls, _state(options, known), options.seconds)
    width = max(len(str(one.call)) for one in reports)
    for one in reports:
        output.text("\n".join(_answer(one, width)))
    unchecked = tuple(dict.fromkeys(word for one in reports for word in one.unchecked))
    output.text(unchecked_text(unchecked))
    found = tuple(finding for one in reports for finding in (*one.findings, *one.warnings))
    output.findings((one for one in known.findings if one.is_error), known.texts)
    is_good = all(one.ok for one in reports)
    output.document(
        {
            "ok": is_good,
            "calls": [_report(one) for one in reports],
            "unchecked": unchecked,
            "state": [term_text(fact) for fact in reports[-1].state.facts],
            **diagnostic_document((*known.findings, *found)),
        }
    )
    return 0 if is_good else 1


NOT_SHOWN = "not shown: that no fewer tasks reach the goal"


def plan(options: argparse.Namespace, output: Output) -> int:
    """Print the fewest tasks that reach a goal."""
    known = open_knowledge(options.path, Prolog(options.prolog))
    state = _state(options, known)
    with Progress("planning") as progress:
        found = known.base.plan(
            options.goal,
            state,
            options.seconds,
            lambda count: progress(math.nan, f"{count} states looked at"),
        )
    output.findings((one for one in known.findings if one.is_error), known.texts)
    code = output.findings(found.findings, {})
    program = program_text(known.base.task, found.calls, "plan") if found.ok else ""
    output.text(program.rstrip("\n") if options.program else _steps(found.calls) if found.ok else "no plan")
    if found.ok and not options.program:
        if not found.is_fewest:
            output.text(NOT_SHOWN)
        output.text(unchecked_text(found.unchecked))
    output.document(
        {
            "ok": found.ok,
            "calls": [_call(one) for one in found.calls],
            "looked_at": found.looked_at,
            "inferences": found.inferences,
            "fewest": found.ok and found.is_fewest,
            "unchecked": found.unchecked,
            "program": program,
            **diagnostic_document((*known.findings, *found.findings)),
        }
    )
    return code


def _state(options: argparse.Namespace, known: Knowledge) -> WorldState:
    return WorldState.of(*options.state) if options.state else known.state


def _head(task: KnownTask) -> str:
    """Return name and parameters of a call, by their words, with defaults."""
    inside = (f"{one.label}{'' if one.default is None else f' = {default_text(one)}'}" for one in task.passed)
    return f"{task.name}({', '.join(inside)})"


def _parameters(task: KnownTask) -> list[str]:
    """Return a line for each parameter that has a word: its name in the text, its kind, and its bounds."""
    told = [one for one in task.parameters if one.word]
    width = max((len(one.word) for one in told), default=0)
    lines = [f"{one.word:{width}}  {_sentence(one)} ({one.name})" for one in told]
    return [*lines, ""] if lines else []


def _sentence(parameter: Parameter) -> str:
    """Return remarks on a parameter for users, its bounds, and whether no call passes it."""
    told = "told by the state of the cell" if parameter.is_symbolic else ""
    return ", ".join(filter(None, (parameter.sentence, *map(str, parameter.bounds), told)))


def _steps(calls: Sequence[TaskCall]) -> str:
    if not calls:
        return "nothing to do: the goal holds"
    width = max(len(str(one)) for one in calls)
    return "\n".join(
        f"{number:3}  {one!s:{width}}  {_objects(one)}".rstrip() for number, one in enumerate(calls, 1)
    )


def _objects(call: TaskCall) -> str:
    return ", ".join(f"{name} = {value}" for name, value in call.objects)


def _answer(report: CallReport, width: int) -> Iterator[str]:
    """Yield the lines of one call: question, answer, and remedy."""
    words = ", ".join(filter(None, (report.message, _objects(report.call)))) if report.ok else ""
    first: Sequence[Diagnostic] = report.findings
    yield f"{report.call!s:{width}}  {words or first[0].message}"
    for one in report.warnings:
        yield f"{'':{width}}  warning: {one.message}"
        yield f"{'':{width}}    = {one.hint}"
    for number, one in enumerate(first):
        if number:
            yield f"{'':{width}}  {one.message}"
        if one.hint:
            yield f"{'':{width}}    = {one.hint}"


def _call(call: TaskCall) -> Mapping[str, object]:
    return {"call": str(call), "task": call.name, "objects": dict(call.objects)}


def _report(report: CallReport) -> Mapping[str, object]:
    return {
        **_call(report.call),
        "ok": report.ok,
        "message": report.message,
        "fails": [term_text(one) for one in report.fails],
        "providers": list(report.providers),
        "warnings": [one.message for one in report.warnings],
    }


def _entry(task: KnownTask) -> Mapping[str, object]:
    parameters = [
        {
            "name": one.name,
            "kind": one.kind,
            "default": None if one.default is None else term_text(one.default),
            "word": one.word,
            "sentence": one.sentence,
            "unit": one.unit,
            "range": [str(bound) for bound in one.bounds],
        }
        for one in task.parameters
    ]
    terms = {"needs": task.needs, "adds": task.adds, "removes": task.removes, "geometry": task.geometry}
    return {
        "name": task.name,
        "group": group_of(task),
        "doc": task.doc,
        "parameters": parameters,
        **{word: [term_text(one) for one in some] for word, some in terms.items()},
        "version": version_of(task),
        "library": task.is_built_in,
        "source": task.span.source,
        "line": task.span.line,
    }
