"""What can be written at a place of the cell file: keys that its reader knows there, and their values."""

import re
from collections.abc import Iterator

from ropsim.cellfile import meaning_of
from ropsim.lsp.cell_place import Asked, asked_in, section_at
from ropsim.lsp.document import Document
from ropsim.lsp.messages import Json
from ropsim.lsp.protocol import Position
from ropsim.lsp.workshop import Surroundings
from ropsim.tomltext import Path, Question, Sort

_PROPERTY, _VALUE, _MODULE = 10, 12, 9
_INLINE = re.compile(r"\s*([\w-]+)\s*=\s*\{(.*)$")
_GIVEN = re.compile(r"\s*([\w-]+)\s*=\s*(.*)$")
_HEADER = re.compile(r"\s*(\[\[?)\s*([\w-]*)$")
_REMARK = re.compile(r"""(?:[^"'#]|"[^"]*"|'[^']*')*+#""")
_KEY = re.compile(r"\s*[\w-]*$")
_SECTIONS = {Sort.SECTION: "[", Sort.NAMED: "[", Sort.SECTIONS: "[["}


def proposed_in_cell(
    document: Document, position: Position, around: Surroundings, trigger: str
) -> list[Json]:
    """Return what can be written at a place; the line is left out of what is read, as it is being typed.

    Args:
        document: the cell file.
        position: in it.
        around: its project.
        trigger: the sign that has just been typed, where it is what asks: then no keys are offered.
    """
    number = position.line
    before = document.line(number)[: document.column(position)]
    if _REMARK.match(before):
        return []
    header = _HEADER.match(before)
    if header is not None:
        asked = asked_in(_with_line(document, number, ""), around)
        return list(_sections(asked, header[1]))
    section, rest, stub = section_at(document, number), before, ""
    inline = _INLINE.match(before)
    if inline is not None and "{" not in inline[2]:
        section, stub = (*section, inline[1]), f"{inline[1]} = {{}}"
        rest = _last_item(inline[2])
    asked = asked_in(_with_line(document, number, stub), around)
    given = _GIVEN.match(rest)
    if given is not None:
        question = asked.questions.get((*section, given[1]))
        return list(_values(question, given[2])) if question is not None else []
    if trigger or not _KEY.match(rest):
        return []
    return list(_keys(asked, section, document, number))


def _with_line(document: Document, number: int, text: str) -> str:
    lines = [document.line(one) for one in range(len(document.starts))]
    lines[number] = text
    return "\n".join(lines)


def _last_item(inside: str) -> str:
    """Return what stands behind the last comma that is in no list."""
    depth, start = 0, 0
    for at, sign in enumerate(inside):
        depth += {"[": 1, "]": -1}.get(sign, 0)
        if sign == "," and depth == 0:
            start = at + 1
    return inside[start:]


def _sections(asked: Asked, bracket: str) -> Iterator[Json]:
    """Yield the sections of the file that begin with so many brackets."""
    for key, question in asked.keys_of(()).items():
        if _SECTIONS.get(question.sort) == bracket:
            label = f"{key}." if question.sort is Sort.NAMED else key
            yield _item(label, _MODULE, question.form, (key,))


def _keys(asked: Asked, section: Path, document: Document, number: int) -> Iterator[Json]:
    """Yield the keys of a section that are not there yet, those that must be there first."""
    there = {
        given[1]
        for at in range(len(document.starts))
        if at != number and section_at(document, at) == section and (given := _GIVEN.match(document.line(at)))
    }
    for key, question in asked.keys_of(section).items():
        path = (*section, key)
        if key in there or (not section and question.sort in _SECTIONS):
            continue
        words = "needed" if path in asked.needed else question.default_words
        detail = f"{question.form}; {words}" if words else question.form
        yield _item(key, _PROPERTY, detail, path, "0" if path in asked.needed else "1")


def _values(question: Question, typed: str) -> Iterator[Json]:
    """Yield the words that a value may be, in quotes where none is open; true and false."""
    if question.sort is Sort.FLAG:
        yield from (_item(word, _VALUE, "", ()) for word in ("true", "false"))
    quote = "" if typed.count('"') % 2 else '"'
    for word in question.choices or question.likely:
        yield _item(f"{quote}{word}{quote}", _VALUE, question.names, ())


def _item(label: str, kind: int, detail: str, path: Path, group: str = "1") -> Json:
    item: Json = {"label": label, "kind": kind, "detail": detail, "sortText": f"{group}{label.lower()}"}
    meaning = meaning_of(path)
    if meaning:
        item["documentation"] = {"kind": "plaintext", "value": meaning}
    return item
