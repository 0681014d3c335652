"""Extracts whole lines as a task: names that they read become parameters, names that they set results."""

import re
from collections.abc import Iterator, Mapping
from textwrap import dedent, indent

from ropsim.language import Act, Meaning, Role, Use, Uses
from ropsim.lsp.analysis.same_code import does_the_same
from ropsim.lsp.analysis.types_of import type_of_meaning
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.changes.name_location import free_name
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.edits import Change, action, applied, refused
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import InRange
from ropsim.workbench import CheckedText

TITLE = "make a task of these lines"
KIND = "refactor.extract"

_STAYS = re.compile(
    r"^[ \t]*+(?:\d++\.[ \t]++)?(program|units|classic|strict|frame|loc|tool|signal|const|var|pattern|task"
    r"|needs|assumes|endp|endtask|return|set[ \t]+(?:speed|acc|blend|frame|tool))\b",
    re.IGNORECASE | re.MULTILINE,
)
_RETURNS = re.compile(r"\b(?:then|else)\s+return\b", re.IGNORECASE)
_COMMENT = re.compile(r"\s*(?:#|//)")


def extract_task(
    document: Document, params: InRange, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[Json]:
    """Yield the change for a selection of whole lines, or the reason why they cannot be a task."""
    start, end = params.range.start, params.range.end
    first, last = start.line, end.line - 1 if end.character == 0 else end.line
    is_whole = start.character <= _blank(document.line(first))
    lines = [document.line(number) for number in range(first, last + 1)]
    if start == end or first > last or not is_whole or not any(line.strip() for line in lines):
        return
    made = _made(document, first, last, documents, workshop)
    if isinstance(made, str):
        yield refused(TITLE, KIND, made)
        return
    if does_the_same(document, applied(document, made), workshop.named(document, documents), workshop):
        yield action(TITLE, KIND, document, made)
    else:
        yield refused(TITLE, KIND, "as a task they would not be complete, or would not do the same")


def _made(
    document: Document, first: int, last: int, documents: Mapping[str, Document], workshop: Workshop
) -> list[Change] | str:
    """Return the changes that make a task of lines (from 0), or why there are none."""
    text = "\n".join(document.line(number) for number in range(first, last + 1))
    uses = workshop.uses(document, documents)
    stays = _STAYS.search(text) or _RETURNS.search(text)
    if stays is not None:
        return f"`{stays[0].split(maxsplit=1)[0]}` has to stay where it is"
    if uses.is_classic:
        return "in a classic text, tasks have no parameters with types"
    taken, given = _taken(uses, first + 1, last + 1), _given(uses, first + 1, last + 1)
    lost = carried(document, uses, first + 1, last + 1, frozenset(taken) & frozenset(given))
    if lost is not None:
        return f"the loop around them keeps the value of `{lost.name}` for its next pass, and a task does not"
    if len(given) > 1:
        listed = " and ".join(f"`{one.name}`" for one in given)
        return f"they give values to {listed}, and a task returns one"
    types = _types((*taken, *given), uses, workshop.checked(document, documents))
    if isinstance(types, str):
        return types
    name = free_name("Task", uses, workshop.named(document, documents))
    header = f"task {name}({', '.join(f'{one.name}: {types[one]}' for one in taken)})"
    body = indent(dedent(text), "  ", lambda line: bool(line.strip()))
    call = f"{name} {', '.join(one.name for one in taken)}".rstrip()
    if given:
        header += f" -> {types[given[0]]}"
        body += f"\n  return {given[0].name}"
        call = f"{given[0].name} = {name}({', '.join(one.name for one in taken)})"
    place = _place(document, uses, first)
    blank = " " * _blank(next(line for line in text.split("\n") if line.strip()))
    return [
        Change(place, 0, place, 0, f"{header}\n{body}\nendp\n\n"),
        Change(first, 0, last, len(document.line(last)), blank + call),
    ]


def _taken(uses: Uses, first: int, last: int) -> list[Meaning]:
    """Return the names of the task that lines (from 1) use and that lines around them define."""
    inside = [use for use in uses.found if first <= use.span.line <= last and not use.meaning.is_global]
    names = list(dict.fromkeys(use.meaning for use in inside if use.meaning.role is not None))
    return [one for one in names if one.definition is None or not first <= one.definition.line <= last]


def _given(uses: Uses, first: int, last: int) -> list[Meaning]:
    """Return the names of the task to which lines (from 1) assign a value that lines outside read."""
    written = dict.fromkeys(
        use.meaning
        for use in uses.found
        if first <= use.span.line <= last and use.act is not Act.READS and not use.meaning.is_global
    )
    read = {use.meaning for use in uses.found if not first <= use.span.line <= last and use.act is Act.READS}
    return [one for one in written if one in read and one.role in (Role.VARIABLE, Role.PARAMETER)]


def _types(names: tuple[Meaning, ...], uses: Uses, checked: CheckedText) -> dict[Meaning, str] | str:
    """Return the type of each name, or the name that has no type."""
    found = {one: type_of_meaning(one, uses, checked) for one in names}
    unknown = next((one.name for one, type_ in found.items() if not type_), None)
    return f"the type of `{unknown}` is not known" if unknown is not None else found


def _place(document: Document, uses: Uses, first: int) -> int:
    """Return the line (from 0) above the outermost block around a line."""
    around = [start - 1 for start, ended in uses.blocks if start - 1 <= first <= ended - 1]
    place = min((*around, first))
    while place > 0 and _COMMENT.match(document.line(place - 1)):
        place -= 1
    return place


def _blank(line: str) -> int:
    return len(line) - len(line.lstrip())


_NO_LOOP = re.compile(r"\s*(?:\d+\.\s*)?(?:if|elseif|else|with|task)\b", re.IGNORECASE)
_GIVES_ALWAYS = re.compile(r"\s*(?:\d+\.\s*)?(?:\w+\s*:?=|for\b)", re.IGNORECASE)


def carried(
    document: Document, uses: Uses, first: int, last: int, handed: frozenset[Meaning]
) -> Meaning | None:
    """Return a name whose value lines need from the pass before, None for none.

    The name is assigned in the lines, and not every pass assigns it before reading it.

    Args:
        document: the text.
        uses: of its names.
        first: first of the lines, from 1.
        last: last of them.
        handed: names that a task of the lines would receive and return, so that nothing is lost.
    """
    around = (start for start, ended in uses.blocks if start < first and last <= ended)
    if all(_NO_LOOP.match(document.line(start - 1)) for start in around):
        return None
    inside = [use for use in uses.found if first <= use.span.line <= last and not use.meaning.is_global]
    written = dict.fromkeys(use.meaning for use in inside if use.act is not Act.READS)
    for one in written:
        if one in handed or not any(use.act is Act.READS for use in uses.of(one)):
            continue
        own = [use for use in inside if use.meaning == one]
        if not _begins_anew(document, uses, first, own):
            return one
    return None


def _begins_anew(document: Document, uses: Uses, first: int, own: list[Use]) -> bool:
    """Return whether the first use of a name assigns it, in every pass and from no value of its own."""
    line = own[0].span.line
    is_inner = any(first <= start < line <= ended for start, ended in uses.blocks)
    is_given = own[0].act is not Act.READS and _GIVES_ALWAYS.match(document.line(line - 1)) is not None
    statement = frozenset(_statement(document, line))
    return is_given and not is_inner and not any(use.span.line in statement for use in own[1:])


def _statement(document: Document, line: int) -> Iterator[int]:
    """Yield the lines (from 1) into which the statement that begins on a line may go on."""
    depth = 0
    for number in range(line, len(document.starts) + 1):
        yield number
        text = document.line(number - 1)
        depth += sum(sign in "([" for sign in text) - sum(sign in ")]" for sign in text)
        if depth <= 0 and not text.rstrip().endswith("\\"):
            return
