"""Texts of tasks in the editor: completions, definitions, and the task at a place."""

import re
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path, PurePath

from ropsim.core import SourceText
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import Position
from ropsim.workbench import DeclaredTask, TaskTexts

_TASK, _PROPERTY, _KIND, _STATEMENT, _CONDITION = 3, 10, 25, 14, 8
"""Kinds of completions in the protocol."""
_SYMBOL = 12

_WORD = re.compile(r"\w*$")
_CALL = re.compile(r"\bcall\(\s*$")
_PARAMETER = re.compile(r"\b[A-Z_]\w*\s*-\s*$")
_TOKEN = re.compile(r"(\w*)([(\[])|[)\]]|\"(?:[^\"\\]|\\.)*\"|'(?:[^'\\]|\\.)*'|%.*")


def proposed_in_tasks(document: Document, position: Position, tasks: TaskTexts) -> list[Json]:
    """Return the completions at a place of a text of tasks."""
    before = document.line(position.line)[: document.column(position)]
    word = _WORD.search(before)
    prefix = before[: word.start()] if word is not None else before
    if _CALL.search(prefix):
        return [task_item(one) for one in tasks.told.values()]
    start = document.starts[min(position.line, len(document.starts) - 1)]
    return list(_words_at(_around(document.text[:start] + prefix), prefix))


def _words_at(around: str, prefix: str) -> Iterator[Json]:
    """Yield the words that fit into the context of a place."""
    from ropsim.tasks import words

    if around == "params" and _PARAMETER.search(prefix):
        yield from (_item(one, _KIND, "kind of a parameter", "") for one in words.KINDS)
    elif around == "task":
        yield from (
            _item(name, _PROPERTY, "property of a task", doc) for name, doc in words.PROPERTIES.items()
        )
    elif around == "body" or around in words.BLOCKS:
        yield from (_item(name, _STATEMENT, form, "") for name, form in words.STATEMENTS.items())
    elif around in ("pre", "eff"):
        yield from (_item(one, _CONDITION, "fact of the cell", "") for one in words.FACTS)
        more = words.OF_PATTERNS if around == "pre" else ("in_rows",)
        yield from (_item(one, _CONDITION, "for patterns", "") for one in more)
    elif around == "geo":
        yield from (_item(one, _CONDITION, "condition of geometry", "") for one in words.GEOMETRY)


def _around(text: str) -> str:
    """Return the name in front of the parenthesis that is open at the end of a text, empty for none."""
    begin = max(text.rfind("task("), 0)
    opened: list[tuple[str, str]] = []
    for token in _TOKEN.finditer(text, begin):
        if token[2]:
            opened.append((token[1], token[2]))
        elif token[0] in (")", "]") and opened:
            opened.pop()
    return next((name for name, sign in reversed(opened) if sign == "("), "")


def not_named(tasks: TaskTexts, known: Collection[str]) -> Iterator[DeclaredTask]:
    """Yield the tasks that a program can call and does not yet."""
    yield from (one for one in tasks.told.values() if one.name not in known)


def task_item(task: DeclaredTask) -> Json:
    """Return the completion item of a task."""
    return _item(task.name, _TASK, f"({', '.join(task.parameters)})", task.doc)


def task_symbols(document: Document) -> list[Json]:
    """Return the tasks of a text in their order."""
    own = TaskTexts((SourceText(document.name, document.text),)).told
    found = [one for one in own.values() if one.span.source == document.name]
    return [
        {
            "name": one.name,
            "detail": one.doc[:120],
            "kind": _SYMBOL,
            "range": document.range_of(one.span),
            "selectionRange": document.range_of(one.span),
        }
        for one in found
    ]


def place_of_task(
    name: str, tasks: TaskTexts, document: Document, documents: Mapping[str, Document]
) -> Json | None:
    """Return the location of a task in its text, open or on the disk; None where no text has it."""
    task = tasks.told.get(name)
    if task is None:
        return None
    place = Path(task.span.source)
    opened = next((one for one in documents.values() if one.path == place), None)
    text = tasks.text(task.span.source)
    there = opened or Document(place.absolute().as_uri(), 0, text.text if text else "", document.encoding)
    return {"uri": there.uri, "range": there.range_of(task.span)}


def place_words(task: DeclaredTask) -> str:
    """Return where a task is, as people say it."""
    return f"{'/'.join(PurePath(task.span.source).parts[-2:])}, line {task.span.line}"


def _item(label: str, kind: int, detail: str, documentation: str) -> Json:
    item: Json = {"label": label, "kind": kind, "detail": detail, "sortText": f"3{label.lower()}"}
    if documentation:
        item["documentation"] = {"kind": "plaintext", "value": documentation}
    return item
