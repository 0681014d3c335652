"""Fixes that put a statement below the header of its loop end the loop, if no other line does."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from ropsim.core import Diagnostic, Span, TextEdit
from ropsim.language.blocks.block_ends import opened
from ropsim.language.blocks.matching import Block
from ropsim.language.report import finding_of
from ropsim.language.syntax.fault import Fault
from ropsim.language.syntax.line import parse_line
from ropsim.language.syntax.statements import Broken
from ropsim.language.syntax.text import Line
from ropsim.language.syntax.words import OPENERS


def with_ends(found: Iterable[Diagnostic], items: Iterable[Line | Block]) -> Iterator[Diagnostic]:
    """Yield findings of a text; fixes of headers whose block has no end of its own write one.

    If more lines are indented below the header, the intended body is unknown: there is no fix.

    Args:
        found: all findings of the text.
        items: its lines and blocks.
    """
    fixes: dict[tuple[str, Span | None], TextEdit | None] = {}
    for block in _unclosed(items):
        header = block.opener
        fault = header.fault
        if fault is not None and _goes_on_below(fault, header):
            finding = finding_of(header, fault, "")
            fixes[finding.code, finding.span] = None if _is_longer(block) else _ended(header, fault)
    for one in found:
        place = (one.code, replace(one.span, source="") if fixes and one.span is not None else None)
        yield replace(one, fix=fixes[place]) if place in fixes and one.fix is not None else one


def _unclosed(items: Iterable[Line | Block]) -> Iterator[Block]:
    for item in items:
        if isinstance(item, Line):
            continue
        if item.closer is None:
            yield item
        for section in item.sections:
            yield from _unclosed(section.body)


def _goes_on_below(fault: Fault, header: Line) -> bool:
    """Return whether the fix of a fault does no more than to put the rest of the line below."""
    return "\n" in fault.fix and fault.fix.endswith(f"  {header.logical.text[fault.start : fault.end]}")


def _is_longer(block: Block) -> bool:
    """Return whether lines are indented below a header, or its line holds the header of another block."""
    header = block.opener
    rest = header.logical.text[header.fault.start : header.end] if header.fault is not None else ""
    dropped, _ = parse_line(rest)
    if dropped is None or isinstance(dropped, Broken) or opened(replace(header, statement=dropped)):
        return True
    first = next(iter(block.sections[0].body), None)
    line = first.opener if isinstance(first, Block) else first
    return line is not None and line.indent > header.indent


def _ended(header: Line, fault: Fault) -> TextEdit:
    """Return the fix of a header with the end of its block below."""
    text = header.logical.text
    indent = text[: header.indent]
    closer = OPENERS[opened(header)][0]
    whole = f"{fault.fix}{text[fault.end : header.end]}\n{indent}{closer}"
    return TextEdit(header.logical.span("", fault.start - fault.before, header.end), whole)
