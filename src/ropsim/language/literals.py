"""Where a line writes locations as numbers, outside of declarations."""

from collections.abc import Iterator
from dataclasses import fields, is_dataclass

from ropsim.core import SourceText, Span
from ropsim.language.cache import LineCache
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.text import Line
from ropsim.language.uses_of import statements_of

_NAMED = (
    syntax.LocationDeclaration,
    syntax.FrameDeclaration,
    syntax.ToolDeclaration,
    syntax.PatternDeclaration,
    syntax.ConstantDeclaration,
    syntax.VariableDeclaration,
    syntax.TaskHeader,
    syntax.Broken,
    syntax.ContractClause,
)


def literals_on(source: SourceText, number: int, cache: LineCache) -> Iterator[Span]:
    """Yield the places on a line (from 1) of parentheses that may be locations, with what belongs to them.

    Outer ones come first; one that fills several lines is left out.
    """
    if not any("(" in text for text in source.lines[number - 1 : number]):
        return
    for line in statements_of(source, cache):
        if line.logical.number <= number < line.logical.number + 1 + line.logical.text.count("\n"):
            yield from (one for one in _literals(source, line) if one.line == one.end_line == number)


def _literals(source: SourceText, line: Line) -> Iterator[Span]:
    if not isinstance(line.statement, _NAMED):
        for node in _nodes(line.statement):
            if _is_literal(node):
                yield line.logical.span(source.name, node.start, node.end)


def _is_literal(node: object) -> bool:
    match node:
        case nodes.Tuple():
            return len(node.items) >= 3
        case nodes.Rebase(operand=inner) | nodes.External(operand=inner):
            return _is_literal(inner)
    return False


def _nodes(node: object) -> Iterator[nodes.Tuple | nodes.Rebase | nodes.External]:
    """Yield the nodes of a statement that may be literal locations, outer ones first."""
    if isinstance(node, nodes.Tuple | nodes.Rebase | nodes.External):
        yield node
    parts = [getattr(node, one.name) for one in fields(node)] if is_dataclass(node) else node
    if isinstance(parts, list | tuple):
        for part in parts:
            yield from _nodes(part)
