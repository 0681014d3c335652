"""Tasks as forms: their fields, findings on each, and the text of the project with a form in it."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import PurePosixPath

import msgspec

from ropsim.core import Diagnostic, SourceText
from ropsim.studio.wire.jobs import CheckTaskForm, FormParameterFields, OpenTaskForm, TaskFormFields
from ropsim.studio.wire.task_messages import FormFault, TaskFormChecked, TaskFormOpened
from ropsim.tasks import (
    NO_COMPILING,
    ClausePlaces,
    FieldFault,
    FormParameter,
    KnowledgeBase,
    Layer,
    TaskError,
    TaskForm,
    edited,
    field_at,
    form_clause,
    form_of,
    words,
)
from ropsim.workbench import Project, TaskTexts, Workspace, text_findings

FOLDER = "kb"
"""Where texts of tasks lie in a project."""


def form_opened(job: OpenTaskForm, base: KnowledgeBase) -> TaskFormOpened:
    """Return the form of a task; one of the library becomes one of the project when it is saved."""
    task = base.task(job.task)
    if task is None:
        return TaskFormOpened(job.task, "", None, f"Task not defined: `{job.task}`", words.KINDS)
    path = PurePosixPath(task.span.source)
    own = task.layer is Layer.PROJECT
    document = f"{FOLDER}/{path.name if own else f'{task.name}.pl'}"
    try:
        form = form_of(task)
    except TaskError as error:
        return TaskFormOpened(job.task, document, None, error.diagnostic.message, words.KINDS)
    return TaskFormOpened(job.task, document, _fields(form), "", words.KINDS)


def form_checked(job: CheckTaskForm, project: Project, workspace: Workspace) -> TaskFormChecked:
    """Return the findings on a form, and the text of its document with the form in it."""
    base = workspace.knowledge(project.tasks)
    old = next((one for one in project.tasks.own if _is(one.name, job.document)), None)
    form = TaskForm(
        job.form.name,
        job.form.doc,
        tuple(FormParameter(*msgspec.structs.astuple(one)) for one in job.form.parameters),
        job.form.needs,
        job.form.effects,
        job.form.geometry,
        job.form.body,
    )
    after = form_clause(form, base.term_faults)
    faults = list(map(_told, after.faults))
    task = base.task(job.task) if job.task else None
    places = base.clause(job.task) if task is not None and old is not None else None
    if task is not None and old is not None and places is not None and places.source == old.name:
        begin = places.begin
        before = form_clause(form_of(task), base.term_faults)
        text, more = edited(old.text, places, before, after)
        faults += map(_told, more)
    else:
        kept = f"{old.text.rstrip()}\n\n" if old is not None and old.text.strip() else ""
        begin, text = len(kept), kept + after.text
    if any(one.severity == "error" for one in faults):
        return TaskFormChecked(job.id, "", "", tuple(faults))
    name = old.name if old is not None else job.document
    texts = _with(project.tasks, SourceText(name, text))
    found = text_findings(workspace, texts, project.cell, name)
    inside = workspace.knowledge(texts).clause_at(text, begin)
    faults += _placed(found, text, inside)
    end = max((end for _, end in inside.properties.values()), default=begin) if inside is not None else begin
    stop = text.find("\n", end)
    return TaskFormChecked(job.id, text, text[begin : stop if stop >= 0 else len(text)], tuple(faults))


def _fields(form: TaskForm) -> TaskFormFields:
    parameters = tuple(
        FormParameterFields(one.name, one.kind, one.default, one.word, one.sentence, one.bounds, one.called)
        for one in form.parameters
    )
    return TaskFormFields(form.name, form.doc, parameters, form.needs, form.effects, form.geometry, form.body)


def _is(source: str, document: str) -> bool:
    return source == document or source.replace("\\", "/").endswith(f"/{document}")


def _with(texts: TaskTexts, new: SourceText) -> TaskTexts:
    own = tuple(new if one.name == new.name else one for one in texts.own)
    return replace(texts, own=own if new in own else (*own, new))


def _told(fault: FieldFault) -> FormFault:
    return _fault(fault.field, fault.place, fault.finding)


def _fault(field: str, place: int, finding: Diagnostic) -> FormFault:
    return FormFault(field, place, finding.severity.value, finding.message, finding.hint)


def _placed(found: tuple[Diagnostic, ...], text: str, places: ClausePlaces | None) -> Iterator[FormFault]:
    """Yield findings of the clause, each with its field; findings of other clauses are left out."""
    lines = text.splitlines(keepends=True)
    for one in found:
        if one.span is None or places is None:
            continue
        at = sum(map(len, lines[: one.span.line - 1])) + one.span.column - 1
        field = "body" if one.code == NO_COMPILING.code else field_at(places, at)
        if field:
            yield _fault(field, -1, one)
