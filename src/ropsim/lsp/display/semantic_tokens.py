"""Kind of each word of a program, for colours by meaning: in numbers relative to the word before."""

from collections.abc import Iterator, Mapping
from hashlib import sha256

from ropsim.core import Span, frozen_dataclass
from ropsim.language import Act, Mark, Meaning, Role, Space, Use
from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.cell.names import names_of
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import InRange, OfDocument, TokensSince

TYPES = (
    "keyword", "type", "function", "property", "number", "string", "comment", "parameter", "variable",
    "enumMember", "namespace", "class", "event", "struct",
)  # fmt: skip
MODIFIERS = ("declaration", "readonly", "modification")

_MARKS = {
    Mark.KEYWORD: "keyword",
    Mark.TYPE: "type",
    Mark.FUNCTION: "function",
    Mark.MEMBER: "property",
    Mark.NUMBER: "number",
    Mark.TEXT: "string",
    Mark.COMMENT: "comment",
}
_ROLES = {
    Role.TASK: "function",
    Role.PARAMETER: "parameter",
    Role.LOCATION: "enumMember",
    Role.FRAME: "namespace",
    Role.TOOL: "class",
    Role.SIGNAL: "event",
    Role.CONSTANT: "enumMember",
    Role.VARIABLE: "variable",
    Role.PATTERN: "struct",
    Role.LIST: "struct",
}
_SPACES = {
    Space.SYMBOL: "enumMember",
    Space.FRAME: "namespace",
    Space.TOOL: "class",
    Space.TASK: "function",
}
_CHANGING = (Role.VARIABLE, Role.PARAMETER)

LEGEND: Json = {"tokenTypes": list(TYPES), "tokenModifiers": list(MODIFIERS)}


@frozen_dataclass
class _Token:
    span: Span
    type: str
    modifiers: int = 0


def all_tokens(
    document: Document, _: OfDocument, documents: Mapping[str, Document], workshop: Workshop
) -> Json:
    """Return all words of a document, with a name for the answer: equal answers have equal ones."""
    return {"resultId": (made := _remembered(document, documents, workshop))[0], "data": list(made[1])}


def tokens_in(
    document: Document, params: InRange, documents: Mapping[str, Document], workshop: Workshop
) -> Json:
    """Return the words of some lines."""
    first, last = params.range.start.line + 1, params.range.end.line + 1
    found = [one for one in _tokens(document, documents, workshop) if first <= one.span.line <= last]
    return {"data": _data(found, document)}


def tokens_since(
    document: Document, params: TokensSince, documents: Mapping[str, Document], workshop: Workshop
) -> Json:
    """Return the changes since an earlier answer, or all tokens if that is not the last one."""
    before = workshop.sent_tokens.get(document.uri)
    name, data = _remembered(document, documents, workshop)
    if before is None or before[0] != params.previous_result_id:
        return {"resultId": name, "data": list(data)}
    old = before[1]
    start = next(
        (k for k, (a, b) in enumerate(zip(old, data, strict=False)) if a != b), min(len(old), len(data))
    )
    most = min(len(old), len(data)) - start
    end = next((k for k in range(most) if old[-1 - k] != data[-1 - k]), most)
    if start == len(old) == len(data):
        return {"resultId": name, "edits": []}
    change = {
        "start": start,
        "deleteCount": len(old) - end - start,
        "data": list(data[start : len(data) - end]),
    }
    return {"resultId": name, "edits": [change]}


def _remembered(
    document: Document, documents: Mapping[str, Document], workshop: Workshop
) -> tuple[str, tuple[int, ...]]:
    """Return name and numbers of the present answer, which is remembered to compute later changes."""
    data = tuple(_data(_tokens(document, documents, workshop), document))
    name = sha256(repr(data).encode()).hexdigest()[:16]
    workshop.sent_tokens[document.uri] = (name, data)
    return name, data


def _tokens(document: Document, documents: Mapping[str, Document], workshop: Workshop) -> list[_Token]:
    if not is_program(document):
        return []
    around = workshop.named(document, documents)
    of_cell = set(names_of(around))
    signals = frozenset(around.cell.signals) if around.cell is not None else frozenset()
    found = [_Token(one.span, _MARKS[one.mark]) for one in workshop.marked(document, documents)]
    workshop.attention.check()
    for use in workshop.uses(document, documents).found:
        workshop.attention.check()
        type_ = _type(use.meaning, of_cell, signals)
        if type_:
            found.append(_Token(use.span, type_, _modifiers(use)))
    return sorted(found, key=lambda one: (one.span.line, one.span.column))


def _type(meaning: Meaning, of_cell: set[tuple[Space, str]], signals: frozenset[str]) -> str:
    """Return the kind of a name for the editor, empty for an undefined name."""
    if meaning.role is not None:
        return _ROLES[meaning.role]
    if (meaning.space, meaning.name) not in of_cell:
        return ""
    is_signal = meaning.space is Space.SYMBOL and meaning.name in signals
    return "event" if is_signal else _SPACES[meaning.space]


def _modifiers(use: Use) -> int:
    held = (
        use.act is Act.DEFINES,
        use.meaning.role not in _CHANGING,
        use.act is Act.WRITES,
    )
    return sum(1 << place for place, is_so in enumerate(held) if is_so)


def _data(found: list[_Token], document: Document) -> list[int]:
    """Return five numbers for each word: line and column after the word before, length, type, modifiers."""
    return [number for five in _numbers(found, document) for number in five]


def _numbers(found: list[_Token], document: Document) -> Iterator[tuple[int, int, int, int, int]]:
    line, last, end = 0, 0, 0  # the line of the word before, and the characters where it starts and ends
    for one in found:
        number, start, stop = one.span.line - 1, one.span.column - 1, one.span.end_column - 1
        if one.span.end_line != one.span.line or (number, start) < (line, end):
            continue  # editors take neither words over several lines nor words within words
        across = document.units(number, last if number == line else 0, start)
        yield number - line, across, document.units(number, start, stop), TYPES.index(one.type), one.modifiers
        line, last, end = number, start, stop
