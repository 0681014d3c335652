"""What can be written at a place: words of the language, tasks, and names of cell and text."""

import re
from collections.abc import Iterator, Mapping
from itertools import chain

from ropsim import language
from ropsim.language import Role
from ropsim.lsp import names, words
from ropsim.lsp.cell_completion import proposed_in_cell
from ropsim.lsp.cell_place import is_cell_file
from ropsim.lsp.document import Document
from ropsim.lsp.expected import LITERALS, expected, in_call, may_give, type_of
from ropsim.lsp.knowledge import not_named, proposed_in_tasks, task_item
from ropsim.lsp.messages import Json
from ropsim.lsp.programs import is_program
from ropsim.lsp.protocol import CompletionAt, Position
from ropsim.lsp.workshop import Workshop
from ropsim.workbench import CheckedText, environment_of

_KINDS = {
    Role.TASK: 3,
    Role.PARAMETER: 6,
    Role.LOCATION: 21,
    Role.FRAME: 22,
    Role.TOOL: 7,
    Role.SIGNAL: 5,
    Role.CONSTANT: 21,
    Role.VARIABLE: 6,
    Role.PATTERN: 13,
}
_KEYWORD, _FUNCTION, _UNIT, _TYPE, _FIELD, _LITERAL = 14, 3, 11, 25, 5, 12
_SIDES = ("after start", "before end")
_QUIET_TRIGGERS = (" ", ",", "(")
_MEMBERS = ("x", "y", "z", "rx", "ry", "rz", "col", "row", "layer")
_NO_PLACE = re.compile(r'^(?:[^"#/]|/(?!/)|"(?:[^"\\]|\\.)*+")*+(?:#|//|")')
_PARTIAL = re.compile(r"[A-Za-z_]?\w*$", re.ASCII)

#: What may stand at the end of a line up to the word being typed, and what is offered there.
_PLACES = tuple(
    (re.compile(pattern, re.IGNORECASE), offer)
    for pattern, offer in (
        (r"^\s*units\b.*$", "unit"),
        (r"^\s*(?:task|const|var)\b.*(?::|->)\s*$", "type"),
        (r"^\s*(?:program|loc|frame|tool|signal|const|var|pattern|task)\s+$", "nothing"),
        (r"^\s*(?:for\s+each\s+\w+\s+in)\s+$", "pattern"),
        (r"^\s*(?:\d+\.\s*)?$", "statement"),
        (r"\b(?:then|else)\s+$", "statement"),
        (r"\bat\s(?:(?!\bdo\b).)*[^\d\s(,=+*/-]\s+$", "side"),
        (r"\b(?:start|end)\s+do\s+$", "trigger"),
        (r"\bdo\s+set\s+$", "signal"),
        (r"^\s*call\s+$", "task"),
        (r"^\s*set\s+$", "setting"),
        (r"^\s*with\s+$|^\s*with\b.*,\s*$", "modifier"),
        (r"^\s*(?:open|close)\s+$|\btool\s+$", "tool"),
        (r"(?:\bin|@|\bframe)\s*$", "frame"),
        (r"\d\s*$", "unit"),
        (r"[A-Za-z_]\w*\.$", "member"),
        (r"\bconfig\s*\([^()]*$", "posture"),
        (r"\([^()]*;[^()]*$", "turn"),
    )
)
_LOCATION = re.compile(r"^\s*loc\b.*=.*\S\s+$", re.IGNORECASE)
_VERB = re.compile(r"^\s*(?:mov[jlc]?|lin|circ|spline)\s+$", re.IGNORECASE)
_MOTION = re.compile(r"^\s*(?:mov[jlc]?|lin|circ|spline)\b.*\S\s+$", re.IGNORECASE)


def completions(
    document: Document, params: CompletionAt, documents: Mapping[str, Document], workshop: Workshop
) -> Json:
    """Return what can be written at a place, the likeliest first; it is the whole list."""
    trigger = params.context.trigger_character if params.context is not None else None
    return {
        "isIncomplete": False,
        "items": proposed(document, params.position, documents, workshop, trigger or ""),
    }


def proposed(
    document: Document,
    position: Position,
    documents: Mapping[str, Document],
    workshop: Workshop,
    trigger: str = "",
) -> list[Json]:
    """Return what can be written at a place, the likeliest first.

    Args:
        document: where.
        position: in it.
        documents: all that are open.
        workshop: knows what was made of them.
        trigger: the sign that has just been typed, where it is what asks; empty for a word or by wish.
    """
    if document.is_task_text:
        return proposed_in_tasks(document, position, workshop.surroundings(document, documents).tasks)
    if is_cell_file(document):
        return proposed_in_cell(document, position, workshop.named(document, documents), trigger)
    if not is_program(document):
        return []
    before = document.line(position.line)[: document.column(position)]
    if _NO_PLACE.search(before):
        return []
    lead = before[: len(before) - len(_partial(before))]
    place = next((offer for pattern, offer in _PLACES if pattern.search(lead)), "value")
    if trigger in _QUIET_TRIGGERS and not in_call(lead, workshop.checked(document, documents).tasks):
        return []
    around = workshop.named(document, documents)
    of_text = names.of_text(workshop.uses(document, documents), position.line)
    known = {(_table_of(one.role), one.name): one for one in chain(names.of_cell(around), of_text)}
    checked = workshop.checked(document, documents)
    if place == "posture":
        parts = environment_of(around.cell, around.station).postures or ()
        return [_item(word, _LITERAL, "posture", "") for part in parts for word in part]
    offered = list(_offered(place, lead, list(known.values()), checked, workshop.outline(document)))
    if place in ("task", "statement"):
        offered += map(task_item, not_named(around.tasks, frozenset(checked.tasks)))
    return offered


def _table_of(role: Role) -> Role | None:
    """Return where names of a role are looked for: frames and tools apart from all others."""
    return role if role in (Role.FRAME, Role.TOOL) else None


def _partial(before: str) -> str:
    match = _PARTIAL.search(before)
    return match[0] if match else ""


def _offered(
    place: str, lead: str, known: list[names.Known], checked: CheckedText, outline: language.Outline
) -> Iterator[Json]:
    match place:
        case "unit":
            yield from (_item(unit, _UNIT, "unit", "") for unit in sorted(language.UNIT_WORDS) if unit != "%")
        case "type":
            yield from _words(words.TYPES, _TYPE, "1")
        case "member":
            yield from (_item(name, _FIELD, "coordinate", "") for name in _MEMBERS)
        case "turn":
            yield from _words(words.TURNS, _KEYWORD, "1")
            yield from _values(known)
        case "pattern":
            yield from _named(known, Role.PATTERN)
        case "tool":
            yield from _named(known, Role.TOOL)
        case "frame":
            yield from _named(known, Role.FRAME)
            yield _item("base", _KINDS[Role.FRAME], "the base frame", "")
        case "task":
            yield from _tasks(checked, outline)
        case "modifier":
            yield from _words(words.MODIFIERS, _KEYWORD, "1")
        case "side" | "trigger" | "signal":
            yield from _on_the_way(place, known)
        case "setting":
            yield from _named(known, Role.SIGNAL)
            yield from _words(words.MODIFIERS, _KEYWORD, "2")
        case "statement":
            yield from _tasks(checked, outline)
            yield from _words(words.STATEMENTS, _KEYWORD, "2")
            yield from _named(known, Role.VARIABLE)
        case "value":
            yield from _behind_locations(lead)
            yield from _fitting(known, expected(lead, checked.tasks))


def _on_the_way(place: str, known: list[names.Known]) -> Iterator[Json]:
    """Yield what may follow in the words of an output that is set on the way of a motion."""
    if place == "side":
        yield from (_item(side, _KEYWORD, "the end from which is counted", "") for side in _SIDES)
    elif place == "trigger":
        yield _item("set", _KEYWORD, "set OUTPUT on|off|= value", words.STATEMENTS["set"].meaning)
    else:
        yield from _named(known, Role.SIGNAL)


def _behind_locations(lead: str) -> Iterator[Json]:
    """Yield what may follow a location, where the line may end with one."""
    is_target = _MOTION.search(lead) is not None
    if is_target:
        yield from _words(words.MODIFIERS, _KEYWORD, "2")
        own = {name: word for name, word in words.MOTIONS.items() if name in language.BEHIND_TARGETS}
        yield from _words(own, _KEYWORD, "2")
        yield _item("until", _KEYWORD, "until SIGNAL", "Ends the motion when the condition holds.", "2")
    elif _VERB.search(lead):
        yield _item("via", _KEYWORD, words.MOTIONS["via"].form, words.MOTIONS["via"].meaning, "3")
    if is_target or _LOCATION.search(lead):
        yield from _words(words.LOCATIONS, _KEYWORD, "3")


def _values(known: list[names.Known]) -> Iterator[Json]:
    for one in known:
        if one.role not in (Role.FRAME, Role.TOOL, Role.PATTERN):
            yield _name(one)


def _fitting(known: list[names.Known], wanted: str) -> Iterator[Json]:
    """Yield values: those of the type that is wanted first, then literals, then what may be made one."""
    for one in known:
        if one.role is Role.FRAME and wanted == "loc":
            yield _name(one, "2")
        elif one.role not in (Role.FRAME, Role.TOOL, Role.PATTERN) and may_give(wanted, type_of(one)):
            yield _name(one, "0" if wanted and type_of(one) == wanted else "1" if not wanted else "2")
    for place, literal in enumerate(LITERALS.get(wanted, ())):
        yield _item(literal, _LITERAL, wanted, "", f"1{place}")
    if wanted not in ("loc", "bool"):
        yield from _words(words.FUNCTIONS, _FUNCTION, "4")
    if not wanted:
        yield from _words(words.INNER, _KEYWORD, "3")


def _named(known: list[names.Known], role: Role) -> Iterator[Json]:
    yield from (_name(one) for one in known if one.role is role)


def _name(one: names.Known, group: str = "1") -> Json:
    detail = f"{one.role.value}: {one.text}" if one.origin == "cell" else one.text
    return _item(one.name, _KINDS[one.role], detail[:120], "", group)


def _tasks(checked: CheckedText, outline: language.Outline) -> Iterator[Json]:
    for name, form in checked.tasks.items():
        if name.isidentifier():
            notes = " ".join(names.task_notes(outline, name))
            yield _item(name, _KINDS[Role.TASK], str(form)[len(name) :], notes, "1")


def _words(table: Mapping[str, words.Word], kind: int, group: str) -> Iterator[Json]:
    for name, word in table.items():
        yield _item(name, kind, word.form, word.meaning, group)


def _item(label: str, kind: int, detail: str, documentation: str, group: str = "1") -> Json:
    item: Json = {"label": label, "kind": kind, "detail": detail, "sortText": f"{group}{label.lower()}"}
    if documentation:
        item["documentation"] = {"kind": "plaintext", "value": documentation}
    return item
