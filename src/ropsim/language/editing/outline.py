"""Definitions of a text and their places: tasks, declarations and variables, for editors; without types."""

import re
from collections.abc import Iterator
from enum import Enum

from ropsim.core import SourceText, Span, frozen_dataclass
from ropsim.language.blocks.block_ends import ANY, closed, opened
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.nodes import Name
from ropsim.language.syntax.text import Line, Parser, read

_COMMENT = re.compile(r"\s*(?:#|//)+\s?(.*)")


class Role(Enum):
    """Kind of entity behind a name."""

    TASK = "task"
    PARAMETER = "parameter"
    LOCATION = "location"
    FRAME = "frame"
    TOOL = "tool"
    SIGNAL = "signal"
    CONSTANT = "constant"
    VARIABLE = "variable"
    PATTERN = "pattern"
    LIST = "list of points"


@frozen_dataclass
class Definition:
    """A name and where it begins to mean something.

    Attributes:
        name: as written.
        role: kind of entity.
        span: of the name.
        task: name of the task in which it is visible, empty for the whole text or the control statements.
        line: the statement that defines it, as written.
    """

    name: str
    role: Role
    span: Span
    task: str
    line: str


@frozen_dataclass
class TaskOutline:
    """A task of the text.

    Attributes:
        definition: its name.
        span: from its header to its end.
        notes: comment above it and its contract, line by line.
    """

    definition: Definition
    span: Span
    notes: tuple[str, ...]


@frozen_dataclass
class Outline:
    """All definitions of a text in order, and its tasks."""

    definitions: tuple[Definition, ...]
    tasks: tuple[TaskOutline, ...]


def outline(source: SourceText, cache: Parser) -> Outline:
    """Return the definitions of a text; any text has an outline."""
    definitions: list[Definition] = []
    tasks: list[TaskOutline] = []
    notes: list[str] = []
    header: Definition | None = None
    last = Span.whole_line(source.name, 1)
    inner: list[str] = []
    for line in read(source, cache):
        statement = line.statement
        span = line.logical.span(source.name, line.start, line.end)
        if isinstance(statement, syntax.TaskHeader):
            if header is not None:
                tasks.append(TaskOutline(header, header.span.to(last), tuple(notes)))
                notes = []
            header = _definition(source, line, statement.name, Role.TASK, "")
            definitions.append(header)
            inner = []
        elif statement is None:
            comment = _COMMENT.match(line.logical.text)
            if header is None:
                notes = [*notes, comment[1]] if comment else []
        elif header is None:
            notes = []
        elif isinstance(statement, syntax.ContractClause):
            notes.append(statement.text)
        task = header.name if header is not None else ""
        definitions += [_definition(source, line, name, role, task) for name, role in _defined(statement)]
        last = span if statement is not None else last
        if header is not None and _ends_task(line, inner):
            tasks.append(TaskOutline(header, header.span.to(span), tuple(notes)))
            header, notes = None, []
    if header is not None:
        tasks.append(TaskOutline(header, header.span.to(last), tuple(notes)))
    return Outline(tuple(definitions), tuple(tasks))


def _ends_task(line: Line, inner: list[str]) -> bool:
    """Return whether a line ends the task in which it stands; `inner` are the blocks open there."""
    opener, closes = opened(line), closed(line)
    if opener and opener != "task":
        inner.append(opener)
    elif closes in inner:
        del inner[len(inner) - 1 - inner[::-1].index(closes) :]
    elif closes == ANY and inner:
        inner.pop()
    else:
        return closes in ("task", ANY)
    return False


def _definition(source: SourceText, line: Line, name: Name, role: Role, task: str) -> Definition:
    span = line.logical.span(source.name, name.start, name.end)
    return Definition(name.text, role, span, task, line.logical.text.strip())


def _defined(statement: syntax.Statement | None) -> Iterator[tuple[Name, Role]]:
    """Yield the names that a statement defines, or assigns and so may define."""
    match statement:
        case syntax.TaskHeader(parameters=parameters):
            for parameter in parameters or ():
                yield parameter.name, Role.PARAMETER
        case syntax.FrameDeclaration(name=name):
            yield name, Role.FRAME
        case syntax.ToolDeclaration(name=name):
            yield name, Role.TOOL
        case syntax.LocationDeclaration(name=name):
            yield name, Role.LOCATION
        case syntax.SignalDeclaration(name=name):
            yield name, Role.SIGNAL
        case syntax.ConstantDeclaration(name=name):
            yield name, Role.CONSTANT
        case syntax.PatternDeclaration(name=name):
            yield name, Role.PATTERN
        case syntax.VariableDeclaration(name=name) | syntax.For(name=name) | syntax.ForEach(name=name):
            yield name, Role.VARIABLE
        case syntax.Assign(name=name, member=None) | syntax.Motion(store=Name() as name):
            yield name, Role.VARIABLE
        case syntax.Load(names=names):
            for name in names:
                yield name, Role.VARIABLE
        case syntax.If(body=inner) | syntax.WaitCondition(otherwise=inner) if inner is not None:
            yield from _defined(inner)
