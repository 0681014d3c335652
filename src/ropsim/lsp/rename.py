"""A name of a program changed at all its places, or the reason why it cannot be."""

import re
from collections.abc import Mapping

from ropsim.core import SourceText
from ropsim.language import FUNCTIONS, INNER_WORDS, STATEMENT_WORDS, Meaning, Space, Uses, uses_of
from ropsim.lsp.cell_names import names_of
from ropsim.lsp.document import Document
from ropsim.lsp.found_name import FoundName, found_name
from ropsim.lsp.messages import Json, Refusal
from ropsim.lsp.programs import is_program
from ropsim.lsp.protocol import AtPosition, RenameAt
from ropsim.lsp.workshop import Workshop

_NAME = re.compile(r"[A-Za-z_][A-Za-z_0-9]*", re.ASCII)
_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_REFERENCE = re.compile(r"l\d{0,2}")

#: Of a new name [characters].
LONGEST = 100


def prepare_rename(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> Json | Refusal:
    """Return the place and text of the name at a place, or why it cannot have another one."""
    found = found_name(document, params.position, documents, workshop)
    if found is None or found.use is None:
        return Refusal(_nothing(document, params))
    refused = _fixed(document, found, workshop.uses(document, documents))
    return refused or {"range": document.range_of(found.use.span), "placeholder": found.name}


def rename(
    document: Document, params: RenameAt, documents: Mapping[str, Document], workshop: Workshop
) -> Json | Refusal:
    """Return the edits that give a name another one at all its places, or why that cannot be.

    The new text is read once more: where one of its places would mean something else than before, the name is
    refused.
    """
    found = found_name(document, params.position, documents, workshop)
    if found is None or found.use is None or found.meaning is None:
        return Refusal(_nothing(document, params))
    uses = workshop.uses(document, documents)
    new = params.new_name.strip()
    of_cell = frozenset(names_of(workshop.named(document, documents)))
    refused = _fixed(document, found, uses) or _wrong(new, found) or _clash(new, uses, of_cell)
    if refused is not None or new == found.name:
        return refused or {"changes": {}}
    places = [use.span for use in uses.of(found.meaning)]
    edits: list[Json] = [{"range": document.range_of(span), "newText": new} for span in places]
    outside = frozenset(name for space, name in of_cell if space is Space.SYMBOL)
    after = uses_of(_renamed(document, uses, found, new), workshop.lines, outside)
    if not _keeps(uses, after, found, new):
        return Refusal(f"with the name `{new}` a line would be read in another way")
    return {"changes": {document.uri: edits}}


def _nothing(document: Document, params: AtPosition) -> str:
    if not is_program(document):
        return "names of the cell are changed by hand, in the cell file and in all programs"
    column = document.column(params.position)
    words = _WORD.finditer(document.line(params.position.line))
    word = next((one[0] for one in words if one.start() <= column <= one.end()), "")
    return f"`{word}` is no name of this text" if word else "no name stands here"


def _fixed(document: Document, found: FoundName, uses: Uses) -> Refusal | None:
    """Return why the name at a place cannot have another one."""
    meaning = found.meaning
    if found.is_of_cell:
        return Refusal(f"`{found.name}` is a name of the cell: change it in cell.toml and in all programs")
    if meaning is not None and meaning.is_implicit:
        return Refusal(f"`{found.name}` is an implicit parameter, whose place follows from its name")
    if meaning is None or meaning.role is None:
        return Refusal(f"`{found.name}` is not defined")
    word = re.compile(rf"\b{re.escape(found.name)}\b")
    for span in uses.broken:
        if any(word.search(document.line(line - 1)) for line in range(span.line, span.end_line + 1)):
            return Refusal(f"line {span.line} names `{found.name}` and cannot be read: mend it first")
    return None


def _wrong(new: str, found: FoundName) -> Refusal | None:
    """Return what is wrong with a new name by itself."""
    if not _NAME.fullmatch(new):
        return Refusal(f"`{new}` is no name: letters, digits and `_`, and no digit first")
    if len(new) > LONGEST:
        return Refusal(f"a name has at most {LONGEST} characters")
    if new.lower() in STATEMENT_WORDS | INNER_WORDS:
        return Refusal(f"`{new}` is a word of the language")
    if new.lower() in FUNCTIONS:
        return Refusal(f"`{new}` is a function of the language")
    if found.space is Space.FRAME and new == "base":
        return Refusal("`base` is the base frame")
    return None


def _clash(new: str, uses: Uses, of_cell: frozenset[tuple[Space, str]]) -> Refusal | None:
    """Return what else has the new name already."""
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


def _renamed(document: Document, uses: Uses, found: FoundName, new: str) -> SourceText:
    """Return the text with the new name."""
    lines = [document.line(number) for number in range(len(document.starts))]
    for use in reversed(uses.found):
        if use.meaning == found.meaning:
            line = lines[use.span.line - 1]
            lines[use.span.line - 1] = line[: use.span.column - 1] + new + line[use.span.end_column - 1 :]
    return SourceText(document.name, "\n".join(lines))


def _keeps(uses: Uses, after: Uses, found: FoundName, new: str) -> bool:
    """Return whether a text with the new name uses all names as before, the new one instead of the old."""
    return len(uses.broken) == len(after.broken) and _shape(uses, found.meaning, new) == _shape(after)


def _shape(uses: Uses, renamed: Meaning | None = None, new: str = "") -> list[tuple[int, str, str, int]]:
    """Return what stands where: line, name, act, and the number of its meaning."""
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
