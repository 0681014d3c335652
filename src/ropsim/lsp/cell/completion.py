"""Completions at a place of the cell file: keys that its reader accepts there, and their values."""

import re
from collections.abc import Iterator

from ropsim.cellfile import meaning_of
from ropsim.lsp.analysis.workshop import Surroundings
from ropsim.lsp.cell.place import Questions, questions_in
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import Position
from ropsim.tomltext import Path, Question, Sort, unfinished_at

_PROPERTY, _VALUE, _MODULE = 10, 12, 9
_HEADER = re.compile(r"\s*(\[\[?)\s*([\w-]*)$")
_KEY = re.compile(r"\s*[\w-]*$")
_SECTIONS = {Sort.SECTION: "[", Sort.NAMED: "[", Sort.SECTIONS: "[["}


def proposed_in_cell(
    document: Document, position: Position, around: Surroundings, trigger: str
) -> list[Json]:
    """Return the completions at a place; the incomplete word at the place is not read.

    Args:
        document: the cell file.
        position: in it.
        around: its project.
        trigger: the character just typed if it triggered the request: then no keys are offered.
    """
    place = unfinished_at(document.lines(), position.line, document.column(position))
    questions = questions_in(place.rest, around)
    if place.key is not None:
        question = questions.questions.get(place.key)
        return list(_values(question, place.typed)) if question is not None else []
    header = _HEADER.match(document.line(position.line)[: document.column(position)])
    if place.table is None:
        return []
    if header is not None:
        return list(_sections(questions, header[1]))
    if trigger or not _KEY.match(place.typed):
        return []
    return list(_keys(questions, place.table, place.others))


def _sections(questions: Questions, bracket: str) -> Iterator[Json]:
    """Yield the sections of the file that begin with a number of brackets."""
    for key, question in questions.keys_of(()).items():
        if _SECTIONS.get(question.sort) == bracket:
            label = f"{key}." if question.sort is Sort.NAMED else key
            yield _item(label, _MODULE, question.form, meaning_of((key,)))


def _keys(questions: Questions, section: Path, there: frozenset[str]) -> Iterator[Json]:
    """Yield the keys of a section that are not there yet, required keys first."""
    for key, question in questions.keys_of(section).items():
        path = (*section, key)
        if key in there or (not section and question.sort in _SECTIONS):
            continue
        words = "needed" if path in questions.needed else question.default_words
        detail = f"{question.form}; {words}" if words else question.form
        item = _item(key, _PROPERTY, detail, meaning_of(path, question))
        item["sortText"] = f"{'0' if path in questions.needed else '1'}{key.lower()}"
        yield item


def _values(question: Question, typed: str) -> Iterator[Json]:
    """Yield the words that a value may be, in quotes where none is open; true and false."""
    if question.sort is Sort.FLAG:
        yield from (_item(word, _VALUE, "") for word in ("true", "false"))
    quote = "" if typed.count('"') % 2 else '"'
    for word in question.choices or question.likely:
        yield _item(f"{quote}{word}{quote}", _VALUE, question.names)


def _item(label: str, kind: int, detail: str, meaning: str = "") -> Json:
    item: Json = {"label": label, "kind": kind, "detail": detail, "sortText": f"1{label.lower()}"}
    if meaning:
        item["documentation"] = {"kind": "plaintext", "value": meaning}
    return item
