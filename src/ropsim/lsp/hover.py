"""What is said about the word under the pointer."""

import re
from collections.abc import Mapping

from ropsim.core import catalogue
from ropsim.lsp import findings, names, words
from ropsim.lsp.document import Document
from ropsim.lsp.messages import Json
from ropsim.lsp.protocol import AtPosition, Position
from ropsim.lsp.workshop import Workshop

_MARKS = re.compile(r"([\\`*_{}\[\]<>#|&])")


def hover(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> Json | None:
    """Return what is known about a place, None for nothing."""
    position = params.position
    found = names.word_at(document, position)
    parts = [*_finding(document, position, documents, workshop)]
    if found is not None:
        parts = [*_about(found[0], document, position, documents, workshop), *parts]
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
    word: str, document: Document, position: Position, documents: Mapping[str, Document], workshop: Workshop
) -> list[str]:
    if document.name.endswith((".toml", ".icr")):
        return []
    form = workshop.checked(document, documents).tasks.get(word)
    outline = workshop.outline(document)
    if form is not None:
        return [_code(names.task_words(form)), *map(plain, names.task_notes(outline, word))]
    defined = names.definition_of(outline, word, position.line)
    if defined is not None:
        return [_code(defined.line), plain(f"{defined.role.value}, line {defined.span.line}")]
    around = workshop.surroundings(document, documents)
    for one in names.of_cell(around):
        if one.name == word:
            told = [f"{one.text} {one.where}".strip(), *([one.note] if one.note else [])]
            return [f"**{plain(word)}**: {one.role.value} of the cell", *map(plain, told)]
    known = words.meaning_of(word)
    return [_code(known.form), plain(known.meaning)] if known is not None else []


def _finding(
    document: Document, position: Position, documents: Mapping[str, Document], workshop: Workshop
) -> list[str]:
    """Return what kind of finding marks a place."""
    column = document.column(position)
    for one in workshop.checked(document, documents).diagnostics:
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


def plain(text: str) -> str:
    """Return text of a user so that Markdown shows it as it stands."""
    return _MARKS.sub(r"\\\1", text)


def _code(text: str) -> str:
    fence = "`" * (3 + max((len(run) for run in re.findall(r"`{3,}", text)), default=0))
    return f"{fence}task\n{text}\n{fence}"
