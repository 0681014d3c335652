"""What texts of tasks tell at a glance, without Prolog: names, parameters and what each task is for.

Texts are only searched, so that lists can be made while one is being typed; what is in a comment counts, too.
"""

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from pathlib import Path

from ropsim.core import SourceText, Span, frozen_dataclass, read_bytes

FEW = 64
"""So many names are looked for one by one in a text."""

_TASK = re.compile(r"\btask\(\s*('?)([^\W\d]\w*)\1")
_DOC = re.compile(r"\bdoc\(\s*\"((?:[^\"\\]|\\.)*)\"")
_PARAMETERS = re.compile(r"\bparams\(\s*\[([^\]]*)\]")
_PARAMETER = re.compile(r"([A-Z_]\w*)\s*-\s*([a-z]\w*)\s*(=)?")
_WORD = re.compile(r"[^\W\d]\w*")
_BY_STATE = frozenset(("part", "tool", "device", "thing"))


@frozen_dataclass
class ToldTask:
    """A task as its text tells it.

    Attributes:
        name: how it is called.
        parameters: those that a call passes, in words such as `clear: length = …`.
        doc: what it is for; empty where nothing says so.
        span: of the name, in its text.
    """

    name: str
    parameters: tuple[str, ...]
    doc: str
    span: Span

    def __str__(self) -> str:
        return f"{self.name}({', '.join(self.parameters)})"


def told_tasks(texts: Iterable[SourceText]) -> Mapping[str, ToldTask]:
    """Return the tasks of some texts by name; of two with one name the first counts."""
    found: dict[str, ToldTask] = {}
    for text in texts:
        for one in _told(text):
            found.setdefault(one.name, one)
    return found


@lru_cache(maxsize=4096)
def _told(text: SourceText) -> tuple[ToldTask, ...]:
    begins = list(_TASK.finditer(text.text))
    ends = (*(one.start() for one in begins[1:]), len(text.text))
    return tuple(_task(text, one, end) for one, end in zip(begins, ends, strict=False))


def _task(text: SourceText, head: re.Match[str], end: int) -> ToldTask:
    doc = _DOC.search(text.text, head.end(), end)
    listed = _PARAMETERS.search(text.text, head.end(), end)
    line = text.text.count("\n", 0, head.start()) + 1
    column = head.start(2) - (text.text.rfind("\n", 0, head.start(2)) + 1) + 1
    return ToldTask(
        head[2],
        tuple(
            f"{name.lower()}: {kind}{' = …' if default else ''}"
            for name, kind, default in _PARAMETER.findall(listed[1] if listed else "")
            if kind not in _BY_STATE
        ),
        " ".join(doc[1].split()) if doc else "",
        Span.on_line(text.name, line, column, len(head[2])),
    )


@lru_cache(maxsize=1)
def library_texts() -> tuple[SourceText, ...]:
    """Return the texts that come with ropsim, under the names of their files; nothing reads them."""
    folder = Path(__file__).parent.parent / "tasks" / "library"
    return tuple(SourceText(str(one), read_bytes(one).decode()) for one in sorted(folder.glob("*.pl")))


def mentioned(text: str, names: Iterable[str]) -> tuple[str, ...]:
    """Return which names are words of a text, in their order."""
    wanted = tuple(names)
    if len(wanted) > FEW:
        words = frozenset(_WORD.findall(text))
        return tuple(one for one in wanted if one in words)
    return tuple(one for one in wanted if one in text and re.search(rf"\b{one}\b", text))
