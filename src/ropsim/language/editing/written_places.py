"""Where a line writes locations: as numbers, as the target of a motion, and as points on its way."""

from collections.abc import Iterator
from dataclasses import fields, is_dataclass

from ropsim.core import SourceText, Span, frozen_dataclass
from ropsim.language.cache import LineCache
from ropsim.language.editing.uses_of import statements_of
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.statements import If, Motion
from ropsim.language.syntax.text import Line

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
    """Yield the places on a line (from 1) of parentheses that may be locations, with their terms.

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
        case nodes.Rebase(operand=inner) | nodes.External(operand=inner) | nodes.Free(operand=inner):
            return _is_literal(inner)
    return False


def _nodes(node: object) -> Iterator[nodes.Tuple | nodes.Rebase | nodes.External | nodes.Free]:
    """Yield the nodes of a statement that may be literal locations, outer ones first."""
    if isinstance(node, nodes.Tuple | nodes.Rebase | nodes.External | nodes.Free):
        yield node
    parts = [getattr(node, one.name) for one in fields(node)] if is_dataclass(node) else node
    if isinstance(parts, list | tuple):
        for part in parts:
            yield from _nodes(part)


@frozen_dataclass
class MotionPlaces:
    """The places of a motion.

    Attributes:
        line: of its statement, from 1.
        word: its verb, in the form that the language prefers.
        spans: of the points on the way in their order, then of the target.
    """

    line: int
    word: str
    spans: tuple[Span, ...]


def motion_places(source: SourceText, number: int, cache: LineCache) -> MotionPlaces | None:
    """Return the places of the motion on a line (from 1), None where there is none."""
    for line in statements_of(source, cache):
        if line.logical.number <= number < line.logical.number + 1 + line.logical.text.count("\n"):
            statement = line.statement
            while isinstance(statement, If) and statement.body is not None:
                statement = statement.body
            if isinstance(statement, Motion):
                nodes = (*statement.via, statement.target)
                spans = tuple(line.logical.span(source.name, one.start, one.end) for one in nodes)
                return MotionPlaces(line.logical.number, statement.word, spans)
            return None
    return None
