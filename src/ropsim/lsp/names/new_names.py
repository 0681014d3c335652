"""Whether a name can have another one, and the text in which it has."""

import re

from ropsim.core import SourceText
from ropsim.language import FUNCTIONS, RESERVED_WORDS, Meaning, Space, Uses
from ropsim.lsp.names.found_name import FoundName
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Refusal

_NAME = re.compile(r"[A-Za-z_][A-Za-z_0-9]*", re.ASCII)
_REFERENCE = re.compile(r"l\d{0,2}")

#: Of a new name [characters].
LONGEST = 100


def unread(document: Document, found: FoundName, uses: Uses) -> Refusal | None:
    """Return which line names something and cannot be read."""
    word = re.compile(rf"\b{re.escape(found.name)}\b")
    for span in uses.broken:
        if any(word.search(document.line(line - 1)) for line in range(span.line, span.end_line + 1)):
            return Refusal(f"line {span.line} names `{found.name}` and has an error: correct it first")
    return None


def wrong(new: str, found: FoundName) -> Refusal | None:
    """Return the error in a new name, regardless of other names."""
    if not _NAME.fullmatch(new):
        return Refusal(f"`{new}` is no name: letters, digits and `_`, and no digit first")
    if len(new) > LONGEST:
        return Refusal(f"a name has at most {LONGEST} characters")
    if new.lower() in RESERVED_WORDS:
        return Refusal(f"`{new}` is a word of the language")
    if new.lower() in FUNCTIONS:
        return Refusal(f"`{new}` is a function of the language")
    if found.space is Space.FRAME and new == "base":
        return Refusal("`base` is the base frame")
    return None


def clash(new: str, uses: Uses, of_cell: frozenset[tuple[Space, str]]) -> Refusal | None:
    """Return the other entity that already has the new name."""
    if any(name == new for _, name in of_cell):
        return Refusal(f"the cell has the name `{new}`")
    for one in uses.meanings():
        if one.name == new:
            place = f" in line {one.definition.line}" if one.definition is not None else ""
            return Refusal(f"`{new}` is {_article(one.role.value if one.role else 'name')}{place} already")
    if uses.is_classic and _REFERENCE.fullmatch(new):
        return Refusal(f"`{new}` is the name of a reference location in classic tasks")
    return None


def _article(what: str) -> str:
    return f"{'an' if what[0] in 'aeiou' else 'a'} {what}"


def renamed(document: Document, uses: Uses, found: FoundName, new: str) -> SourceText:
    """Return the text with the new name."""
    lines = [document.line(number) for number in range(len(document.starts))]
    for use in reversed(uses.found):
        if use.meaning == found.meaning:
            line = lines[use.span.line - 1]
            lines[use.span.line - 1] = line[: use.span.column - 1] + new + line[use.span.end_column - 1 :]
    return SourceText(document.name, "\n".join(lines))


def keeps(uses: Uses, after: Uses, found: FoundName, new: str) -> bool:
    """Return whether a text with the new name uses all names as before, the new one instead of the old."""
    return len(uses.broken) == len(after.broken) and _shape(uses, found.meaning, new) == _shape(after)


def _shape(uses: Uses, renamed: Meaning | None = None, new: str = "") -> list[tuple[int, str, str, int]]:
    """Return the uses of names: line, name, act, and the number of the meaning."""
    numbers = {meaning: number for number, meaning in enumerate(uses.meanings())}
    return [
        (
            use.span.line,
            new if use.meaning == renamed else use.meaning.name,
            use.act.value,
            numbers[use.meaning],
        )
        for use in uses.found
    ]
