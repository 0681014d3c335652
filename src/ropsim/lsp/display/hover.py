"""Hover text for the word or the move under the pointer, as Markdown."""

import re
from collections.abc import Iterator, Mapping

from ropsim.core import catalogue
from ropsim.language import Meaning, Role, Space
from ropsim.lsp.analysis import names
from ropsim.lsp.analysis.knowledge import place_words
from ropsim.lsp.analysis.last_run import last_run
from ropsim.lsp.analysis.line_times import line_words
from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.types_of import type_of_meaning
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.cell.hover import cell_hover, places_of
from ropsim.lsp.cell.place import is_cell_file
from ropsim.lsp.changes import findings
from ropsim.lsp.completion import words
from ropsim.lsp.display.motion_hover import motion_hover, resolved_words
from ropsim.lsp.names.found_name import FoundName, found_name
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import AtPosition, Position
from ropsim.model import Station
from ropsim.spatial import Pose
from ropsim.workbench import TaskTexts, location_of

_ROLES = {
    Space.SYMBOL: (Role.LOCATION, Role.SIGNAL, Role.LIST),
    Space.FRAME: (Role.FRAME,),
    Space.TOOL: (Role.TOOL,),
    Space.TASK: (),
}


def hover(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> Json | None:
    """Return the hover text for a place, None if there is none."""
    position = params.position
    found = names.word_at(document, position)
    parts = [*_finding(document, position, documents, workshop)]
    if document.is_task_text and found is not None:
        tasks = workshop.surroundings(document, documents).tasks
        parts = [*_of_task(found[0], tasks), *parts]
    if is_cell_file(document):
        texts = cell_hover(document, position, documents, workshop)
        parts = [*(one if one.startswith("**") else plain(one) for one in texts), *parts]
    if is_program(document):
        about = _about(document, params, documents, workshop)
        parts = [*about, *_of_run(document, position, documents, workshop), *parts]
    if not parts:
        return None
    answer: Json = {"contents": {"kind": "markdown", "value": "\n\n".join(parts)}}
    if found is not None:
        word, column = found
        line = position.line
        answer["range"] = {
            "start": document.position(line, column),
            "end": document.position(line, column + len(word)),
        }
    return answer


def _about(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[str]:
    found = found_name(document, params.position, documents, workshop)
    if found is not None and found.meaning is not None:
        if found.meaning.role is None:
            yield from _of_cell(found, document, documents, workshop)
        else:
            yield from _of_text(found.meaning, document, documents, workshop)
        return
    word = names.word_at(document, params.position)
    known = words.meaning_of(word[0]) if word is not None else None
    if known is not None:
        yield from (code(known.form), plain(known.meaning))
    moved = motion_hover(document, params.position, documents, workshop)
    if moved:
        yield plain(moved)


def _of_run(
    document: Document, position: Position, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[str]:
    """Yield the duration of the line in the last recorded run of the program."""
    run = last_run(document, documents, workshop)
    times = run.lines.get(position.line + 1) if run is not None else None
    if run is not None and times is not None:
        yield plain(line_words(times, run.remark))


def _of_text(
    meaning: Meaning, document: Document, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[str]:
    """Yield the hover text of a name that the text defines."""
    checked = workshop.checked(document, documents)
    outline = workshop.outline(document)
    if meaning.space is Space.TASK:
        form = checked.tasks.get(meaning.name)
        yield code(names.task_words(form) if form is not None else meaning.line)
        yield from map(plain, names.task_notes(outline, meaning.name))
        return
    type_ = type_of_meaning(meaning, workshop.uses(document, documents), checked)
    kind = f"{meaning.role.value if meaning.role else 'name'}{f' of type {type_}' if type_ else ''}"
    if meaning.definition is None:
        yield plain(f"{kind}: an implicit parameter of the task {meaning.task}")
        return
    yield code(meaning.line)
    yield plain(f"{kind}, line {meaning.definition.line}")
    around = workshop.named(document, documents)
    if meaning.role is Role.LOCATION:
        resolved = location_of(document.text, outline, meaning.name, around.environment)
        if resolved is not None:
            yield plain(resolved_words(resolved, around.station))


def _of_cell(
    found: FoundName, document: Document, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[str]:
    """Yield the hover text of a name that the cell defines, or of a task in another file."""
    form = workshop.checked(document, documents).tasks.get(found.name) if found.space is Space.TASK else None
    if form is not None:
        yield code(names.task_words(form))
        yield from tuple(_of_task(found.name, workshop.named(document, documents).tasks))[1:]
    around = workshop.named(document, documents)
    for one in names.of_cell(around):
        if one.name == found.name and one.role in _ROLES[found.space]:
            if one.role is Role.LIST:
                yield f"**{plain(found.name)}**: {one.role.value}, `points/{plain(found.name)}.csv`"
                yield plain(f"{one.text}, {one.where}")
                continue
            yield f"**{plain(found.name)}**: {one.role.value} of the cell"
            assert around.cell is not None
            texts = list(places_of(around.cell, f"{one.role.value}s", found.name))
            is_counted_from_base = one.where == "in the base frame" and not _stands_in_world(around.station)
            own = [f"{one.text} {one.where}"] if is_counted_from_base else []
            yield from map(plain, [*texts, *own, *([one.note] if one.note else [])])


def _stands_in_world(station: Station | None) -> bool:
    """Return whether the base frame of a station is the world frame."""
    return station is None or Pose() == station.X_WB


def _of_task(name: str, tasks: TaskTexts) -> Iterator[str]:
    """Yield the hover text of a task of a knowledge base: call, purpose, place."""
    task = tasks.told.get(name)
    if task is not None:
        yield code(f"task {task}")
        if task.doc:
            yield plain(task.doc)
        yield plain(f"task of {place_words(task)}")


def _finding(
    document: Document, position: Position, documents: Mapping[str, Document], workshop: Workshop
) -> list[str]:
    """Return the kinds of the findings at a place."""
    column = document.column(position)
    for one in workshop.findings(document, documents):
        span = one.span
        if span is None or not findings.touches(span, position.line, position.line):
            continue
        begins = span.column - 1 if span.line - 1 == position.line else 0
        ends = span.end_column - 1 if span.end_line - 1 == position.line else len(document.text)
        kind = catalogue().get(one.code)
        if kind is not None and (span.is_whole_line or begins <= column <= ends):
            return [
                f"{one.severity.value} **{one.code}** {plain(kind.summary)} (`ropsim explain {one.code}`)"
            ]
    return []


_MARKS = re.compile(r"([\\`*_{}\[\]<>#|&])")


def plain(text: str) -> str:
    """Return text of a user, escaped so that Markdown shows it literally."""
    return _MARKS.sub(r"\\\1", text)


def code(text: str) -> str:
    """Return text of the task language as a block."""
    fence = "`" * (3 + max((len(run) for run in re.findall(r"`{3,}", text)), default=0))
    return f"{fence}task\n{text}\n{fence}"
