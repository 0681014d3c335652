"""Completions at a place: words of the language, tasks, and names of cell and text."""

import re
import string
from collections.abc import Iterator, Mapping
from itertools import chain

from ropsim import language
from ropsim.language import Role
from ropsim.lsp.analysis import names
from ropsim.lsp.analysis.knowledge import not_named, proposed_in_tasks, task_item
from ropsim.lsp.analysis.names import Known
from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.cell.completion import proposed_in_cell
from ropsim.lsp.cell.place import is_cell_file
from ropsim.lsp.completion import words
from ropsim.lsp.completion.behind_values import behind_value, guard_completions
from ropsim.lsp.completion.expected import expected, in_call, type_of
from ropsim.lsp.completion.incomplete_word import Numbers, continues, in_number
from ropsim.lsp.completion.items import (
    KEYWORD,
    KINDS,
    LITERAL,
    NO_VALUES,
    TYPE,
    UNIT,
    item,
    members,
    name_item,
    point_names,
    values,
    word_items,
)
from ropsim.lsp.completion.line_place import Place, place_of, statement_of
from ropsim.lsp.completion.next_words import next_words
from ropsim.lsp.completion.unit_order import is_counted, ordered_units, own_units
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import CompletionAt, Position
from ropsim.workbench import CheckedText, environment_of

_QUIET_TRIGGERS = (" ", ",", "(")
_NO_PLACE = re.compile(r'^(?:[^"#/]|/(?!/)|"(?:[^"\\]|\\.)*+")*+(?:#|//|")')
_WORD = f"{string.ascii_letters}{string.digits}_"
_INPUT = re.compile(r"(?:^|=)\s*(?:analog\s+)?input\b", re.IGNORECASE)
_WORDS: Mapping[Place, tuple[Json, ...]] = {
    Place.UNITS: tuple(item(unit, UNIT, "unit", "") for unit in sorted(language.UNIT_WORDS - {"%"})),
    Place.TYPE: tuple(word_items(words.TYPES, TYPE, "1")),
    Place.TURN: tuple(word_items(words.TURNS, KEYWORD, "1")),
    Place.MODIFIER: tuple(word_items(words.MODIFIERS, KEYWORD, "1")),
    Place.SETTING: tuple(word_items(words.MODIFIERS, KEYWORD, "1")),
    Place.STATEMENT: tuple(word_items(words.STATEMENTS, KEYWORD, "2")),
}
_ROLES = {
    Place.PATTERN: (Role.PATTERN, Role.LIST),
    Place.LIST: (Role.LIST,),
    Place.TOOL: (Role.TOOL,),
    Place.FRAME: (Role.FRAME,),
    Place.STATEMENT: (Role.VARIABLE,),
}


def completions(
    document: Document, params: CompletionAt, documents: Mapping[str, Document], workshop: Workshop
) -> Json:
    """Return the completions at a place, the likeliest first.

    The list is complete, except if it is empty: behind a space, in a number or unit, or if the text at the
    place already is the only completion. The next character may then change it.
    """
    trigger = params.context.trigger_character if params.context is not None else None
    line, column = document.line(params.position.line), document.column(params.position)
    numbers = Numbers.WITH_UNITS if is_program(document) else Numbers.PLAIN
    if in_number(line[:column], numbers):
        return {"isIncomplete": True, "items": []}
    items = proposed(document, params.position, documents, workshop, trigger or "")
    offered = items if continues(line[:column], line[column:], items) else []
    return {"isIncomplete": not offered, "items": offered}


def proposed(
    document: Document,
    position: Position,
    documents: Mapping[str, Document],
    workshop: Workshop,
    trigger: str = "",
) -> list[Json]:
    """Return the completions at a place, the likeliest first.

    Args:
        document: where.
        position: in it.
        documents: all open documents.
        workshop: results for the documents.
        trigger: the character just typed if it triggered the request; empty for a word or an explicit
            request.
    """
    if document.is_task_text:
        return proposed_in_tasks(document, position, workshop.surroundings(document, documents).tasks)
    if is_cell_file(document):
        return proposed_in_cell(document, position, workshop.named(document, documents), trigger)
    if not is_program(document):
        return []
    before = document.line(position.line)[: document.column(position)]
    line = before[: len(before) - len(_partial(before))]
    if _NO_PLACE.search(before):
        return list(point_names(line, workshop.named(document, documents).environment.lists))
    checked = workshop.checked(document, documents)
    if trigger in _QUIET_TRIGGERS and not in_call(line, checked.tasks):
        return []
    prefix = statement_of(line)
    followed = next_words(prefix)
    if followed:
        return followed
    place = place_of(prefix, checked.tasks)
    around = workshop.named(document, documents)
    of_text = names.of_text(workshop.uses(document, documents), position.line, checked)
    known = {(_table_of(one.role), one.name): one for one in chain(names.of_cell(around), of_text)}
    guard = guard_completions(prefix, known.values())
    if guard is not None:
        return guard
    if place is Place.POSTURE:
        parts = environment_of(around.cell, around.station).postures or ()
        return [item(word, LITERAL, "posture", "") for part in parts for word in part]
    if place is Place.UNIT:
        units = ordered_units(prefix, checked.tasks, own_units(document.text))
        group = "5" if is_counted(prefix) else "0"
        ordered = [item(unit, UNIT, "unit", "", f"{group}{at:02}") for at, unit in enumerate(units)]
        return [*ordered, *behind_value(prefix)]
    offered = list(_offered(place, prefix, list(known.values()), checked, workshop.outline(document)))
    if place in (Place.TASK, Place.STATEMENT):
        offered += map(task_item, not_named(around.tasks, frozenset(checked.tasks)))
    return offered


def _table_of(role: Role) -> Role | None:
    """Return the table that contains the names of a role: frames and tools have their own."""
    return role if role in (Role.FRAME, Role.TOOL) else None


def _partial(before: str) -> str:
    """Return the word at the end of a line, behind a number the unit that is begun."""
    word = before[len(before.rstrip(_WORD)) :]
    return word.lstrip(string.digits) or word


def _offered(
    place: Place, prefix: str, known: list[Known], checked: CheckedText, outline: language.Outline
) -> Iterator[Json]:
    if place in _WORDS:
        yield from _WORDS[place]
    if place in _ROLES:
        for role in _ROLES[place]:
            yield from _named(known, role)
    match place:
        case Place.TURN:
            yield from (name_item(one) for one in known if one.role not in NO_VALUES)
        case Place.MEMBER:
            yield from members(prefix, known)
        case Place.STORE:
            variables = (one for one in known if one.role is Role.VARIABLE)
            yield from (name_item(one) for one in variables if type_of(one) in ("loc", ""))
        case Place.FRAME:
            yield item("base", KINDS[Role.FRAME], "the base frame", "")
        case Place.OUTPUT | Place.SETTING | Place.INPUT:
            signals = (one for one in known if one.role is Role.SIGNAL)
            wanted = place is Place.INPUT
            yield from (name_item(one, "0") for one in signals if _is_input(one) is wanted)
        case Place.TASK | Place.STATEMENT:
            yield from _tasks(checked, outline)
        case Place.BEHIND_VALUE:
            yield from behind_value(prefix)
        case Place.VALUE:
            yield from values(prefix, known, expected(prefix, checked.tasks))


def _named(known: list[Known], role: Role) -> Iterator[Json]:
    yield from (name_item(one) for one in known if one.role is role)


def _is_input(signal: Known) -> bool:
    return _INPUT.search(signal.text) is not None


def _tasks(checked: CheckedText, outline: language.Outline) -> Iterator[Json]:
    for name, form in checked.tasks.items():
        if name.isidentifier():
            notes = " ".join(names.task_notes(outline, name))
            yield item(name, KINDS[Role.TASK], str(form)[len(name) :], notes, "1")
