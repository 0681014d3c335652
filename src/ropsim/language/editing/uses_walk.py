"""The walk through the blocks of a text that finds uses of names, with the scopes of tasks and loops."""

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field

from ropsim.core import Span
from ropsim.language.blocks.matching import Block
from ropsim.language.editing.mentions import Mention, Part, mentions
from ropsim.language.editing.outline import Role
from ropsim.language.editing.uses import Act, Meaning, Sight, Space, Use
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.nodes import Name
from ropsim.language.syntax.text import Line

_ROLES: dict[type, tuple[Space, Role]] = {
    syntax.FrameDeclaration: (Space.FRAME, Role.FRAME),
    syntax.ToolDeclaration: (Space.TOOL, Role.TOOL),
    syntax.LocationDeclaration: (Space.SYMBOL, Role.LOCATION),
    syntax.SignalDeclaration: (Space.SYMBOL, Role.SIGNAL),
    syntax.ConstantDeclaration: (Space.SYMBOL, Role.CONSTANT),
    syntax.VariableDeclaration: (Space.SYMBOL, Role.VARIABLE),
    syntax.PatternDeclaration: (Space.SYMBOL, Role.PATTERN),
}
_HEADS = {
    "frame": (Space.FRAME, Role.FRAME),
    "tool": (Space.TOOL, Role.TOOL),
    "loc": (Space.SYMBOL, Role.LOCATION),
    "signal": (Space.SYMBOL, Role.SIGNAL),
    "const": (Space.SYMBOL, Role.CONSTANT),
    "var": (Space.SYMBOL, Role.VARIABLE),
    "pattern": (Space.SYMBOL, Role.PATTERN),
}
_SPACES = {Part.FRAME: Space.FRAME, Part.TOOL: Space.TOOL, Part.CALLED: Space.TASK}
_GIVES = (Part.WRITTEN, Part.LOOP, Part.LOOP_PLACES)


@dataclass(slots=True)
class Scope:
    """Names of one body: a task or the control statements.

    Attributes:
        task: its name, empty for the control statements.
        names: their meanings at the present place.
        is_classic: whether a name that it reads first may be an implicit parameter.
        around: meanings of the variables of the loops around that place.
        open: uses of names that had no meaning at their place.
        end: the line from which on nothing of it is known.
        is_outside: whether it is that of the control statements.
    """

    task: str
    names: dict[str, Meaning] = field(default_factory=dict)
    is_classic: bool = False
    around: list[Meaning] = field(default_factory=list)
    open: list[tuple[Line, Name]] = field(default_factory=list)
    end: float = math.inf
    is_outside: bool = False


class Walk:
    """Traversal of one text; its results so far, in any order.

    Attributes:
        found: the uses.
        broken: places of the statements that could not be read.
        sights: lines in which each meaning is visible; hiding ones come after hidden ones.
        tasks: name, first and last line of each task.
        rooms: first line of each task, and the one that ends it.
        blocks: first and last line of each part of a block with a header of its own.
        is_classic: whether tasks may have implicit parameters.
    """

    def __init__(self, source: str, outside: frozenset[str]) -> None:
        self.found: list[Use] = []
        self.sights: list[Sight] = []
        self.broken: list[Span] = []
        self.rooms: list[tuple[int, float]] = []
        self.tasks: list[tuple[str, int, int]] = []
        self.blocks: list[tuple[int, int]] = []
        self.is_classic = False
        self._source = source
        self._outside = outside
        self._known: dict[tuple[Space, str], Meaning] = {}
        self._own: dict[int, dict[str, Meaning]] = {}
        self._parameters: dict[str, dict[str, Meaning]] = {}
        self._number = 0

    def declare(self, top: Iterable[Line]) -> None:
        """Record the declarations outside tasks; the first declaration of a name counts."""
        for line in top:
            statement = line.statement
            if isinstance(statement, syntax.Broken):
                kind, name = _HEADS.get(statement.head), _name_in(line, statement)
            else:
                kind, name = _ROLES.get(type(statement)), getattr(statement, "name", None)
            if kind is not None and isinstance(name, Name):
                self._global(line, name, *kind)

    def header(self, line: Line) -> None:
        """Note a task and its parameters."""
        statement = line.statement
        if not isinstance(statement, syntax.TaskHeader):
            return
        self._global(line, statement.name, Space.TASK, Role.TASK)
        own: dict[str, Meaning] = {}
        for one in statement.parameters or ():
            if one.name.text not in own:
                own[one.name.text] = self._local(line, one.name, Role.PARAMETER, statement.name.text)
        self._own[line.logical.number] = own
        self._parameters.setdefault(statement.name.text, own)

    def task(self, block: Block, end: float) -> None:
        """Walk through a task; without an end of its own it reaches to the line `end`."""
        opener, last = block.opener, block.closer or _last(block)
        self.blocks += _parts(block)
        header = opener.statement
        assert isinstance(header, syntax.TaskHeader | syntax.Broken)
        name = header.name.text if isinstance(header, syntax.TaskHeader) else header.name
        self.tasks.append((name, opener.logical.number, _end(last)))
        end = block.closer.logical.number if block.closer is not None else end
        self.rooms.append((opener.logical.number, end))
        scope = Scope(name, dict(self._own.get(opener.logical.number, {})), end=end)
        for one in scope.names.values():
            self._known_behind(opener, one, scope)
        scope.is_classic = (
            self.is_classic and isinstance(header, syntax.TaskHeader) and header.parameters is None
        )
        self._line(opener, scope)
        self.items(block.sections[0].body, scope, end)
        for section in block.sections[1:]:
            self._line(section.header, scope)
            self.items(section.body, scope, end)
        self.close(scope)

    def items(self, items: Sequence[Line | Block], scope: Scope, end: float) -> None:
        """Traverse lines and blocks up to the line `end`, which closes blocks without an end of their own."""
        for item, behind in with_ends(items, end):
            if isinstance(item, Line):
                self._line(item, scope)
                continue
            self.blocks += _parts(item)
            opener = item.opener.statement
            closed = item.closer.logical.number if item.closer is not None else behind
            if isinstance(opener, syntax.For | syntax.ForEach):
                with self._loop(item.opener, opener, scope, closed):
                    self.items(item.sections[0].body, scope, closed)
            else:
                for section in item.sections:
                    self._line(section.header, scope)
                    self.items(section.body, scope, closed)
            if item.closer is not None:
                self._line(item.closer, scope)

    def close(self, scope: Scope) -> None:
        """Set the meanings of names that had none at their place."""
        for line, name in scope.open:
            meaning = scope.names.get(name.text) or self._nobodys(Space.SYMBOL, name.text)
            self._use(line, name, Act.READS, meaning, scope)

    def _line(self, line: Line, scope: Scope) -> None:
        statement = line.statement
        if isinstance(statement, syntax.Broken):
            self.broken.append(line.logical.span(self._source, line.start, line.end))
            name = _name_in(line, statement)
            known = self._known.get((_HEADS[statement.head][0], name.text)) if name is not None else None
            if name is not None and known is not None:
                self._use(line, name, Act.DEFINES, known, scope)
            return
        for one in mentions(statement):
            self._mention(line, one, scope)

    def _mention(self, line: Line, one: Mention, scope: Scope) -> None:
        name, part = one.name, one.part
        if part is Part.ARGUMENT:
            parameter = self._parameters.get(one.callee, {}).get(name.text)
            if parameter is not None:
                self._use(line, name, Act.READS, parameter, scope)
        elif part is Part.DECLARED:
            space, _ = _ROLES[type(line.statement)]
            meaning = self._known.get((space, name.text)) or self._nobodys(space, name.text)
            self._use(line, name, Act.DEFINES, meaning, scope)
        elif part is Part.TASK:
            self._use(line, name, Act.DEFINES, self._known[Space.TASK, name.text], scope)
        elif part is Part.PARAMETER:
            self._use(line, name, Act.DEFINES, scope.names[name.text], scope)
        elif part in _SPACES:
            space = _SPACES[part]
            meaning = self._known.get((space, name.text)) or self._nobodys(space, name.text)
            self._use(line, name, Act.READS, meaning, scope)
        elif part is Part.CHANGED:
            self._symbol(line, name, scope, Act.WRITES)
        elif part in _GIVES:
            self._given(line, name, scope)
        else:
            self._symbol(line, name, scope)

    def _symbol(self, line: Line, name: Name, scope: Scope, act: Act = Act.READS) -> None:
        """Record that a name is read; a name that a classic task reads first is its parameter."""
        meaning = self._find(name.text, scope)
        if meaning is None and scope.is_classic and name.text not in self._outside:
            meaning = Meaning(name.text, Space.SYMBOL, Role.PARAMETER, scope.task, is_global=False)
            scope.names[name.text] = meaning
            self._known_behind(line, meaning, scope)
        if meaning is None:
            scope.open.append((line, name))
        else:
            self._use(line, name, act, meaning, scope)

    def _given(self, line: Line, name: Name, scope: Scope) -> Meaning:
        """Note that a name is given a value; the first time that makes a variable."""
        meaning = self._find(name.text, scope)
        if meaning is None and name.text in self._outside:
            meaning = self._nobodys(Space.SYMBOL, name.text)
        if meaning is None:
            meaning = scope.names[name.text] = self._local(line, name, Role.VARIABLE, scope.task)
            self._known_behind(line, meaning, scope)
        is_first = meaning.definition == self._span(line, name)
        self._use(line, name, Act.DEFINES if is_first else Act.WRITES, meaning, scope)
        return meaning

    @contextmanager
    def _loop(
        self, line: Line, loop: syntax.For | syntax.ForEach, scope: Scope, end: float
    ) -> Iterator[None]:
        """Note the header of a loop, whose lines see its variable: one of the loop alone, or an older one."""
        for one in mentions(loop):
            if one.name is not loop.name:
                self._mention(line, one, scope)
        name = loop.name
        before = scope.names.get(name.text)
        found = self._find(name.text, scope)
        is_older = isinstance(loop, syntax.For) and found is not None and found not in scope.around
        if is_older or (found is None and name.text in self._outside):
            meaning = self._given(line, name, scope)
        else:
            meaning = self._local(line, name, Role.VARIABLE, scope.task)
            self._use(line, name, Act.DEFINES, meaning, scope)
            scope.names[name.text] = meaning
            self.sights.append(Sight(meaning, _end(line) + 1, end, scope.is_outside))
        scope.around.append(meaning)
        yield
        scope.around.pop()
        if before is not None:
            scope.names[name.text] = before
        elif not is_older:
            scope.names.pop(name.text, None)

    def _known_behind(self, line: Line, meaning: Meaning, scope: Scope) -> None:
        """Note that a meaning is known from the line after one on, to the end of its scope."""
        self.sights.append(Sight(meaning, _end(line) + 1, scope.end, scope.is_outside))

    def _find(self, name: str, scope: Scope) -> Meaning | None:
        return scope.names.get(name) or self._known.get((Space.SYMBOL, name))

    def _use(self, line: Line, name: Name, act: Act, meaning: Meaning, scope: Scope) -> None:
        span = self._span(line, name)
        self.found.append(Use(span, act, meaning, scope.task))

    def _global(self, line: Line, name: Name, space: Space, role: Role) -> None:
        if (space, name.text) not in self._known:
            span = self._span(line, name)
            text = line.logical.text.strip()
            meaning = Meaning(name.text, space, role, definition=span, line=text, number=self._next())
            self._known[space, name.text] = meaning
            self.sights.append(Sight(meaning, 1, math.inf))

    def _local(self, line: Line, name: Name, role: Role, task: str) -> Meaning:
        span = self._span(line, name)
        text = line.logical.text.strip()
        return Meaning(
            name.text,
            Space.SYMBOL,
            role,
            task,
            is_global=False,
            definition=span,
            line=text,
            number=self._next(),
        )

    def _span(self, line: Line, name: Name) -> Span:
        """Return the place of a name, without the quotes that a task may have."""
        quote = line.logical.text[name.start] == '"'
        return line.logical.span(self._source, name.start + quote, name.end - quote)

    def _next(self) -> int:
        self._number += 1
        return self._number

    def _nobodys(self, space: Space, name: str) -> Meaning:
        return Meaning(name, space, None)


def with_ends(items: Sequence[Line | Block], end: float = math.inf) -> Iterator[tuple[Line | Block, float]]:
    """Yield each item with the line at which the next one begins, `end` for the last."""
    begins = [(item if isinstance(item, Line) else item.opener).logical.number for item in items]
    yield from zip(items, (*begins[1:], end), strict=False)


def _name_in(line: Line, broken: syntax.Broken) -> Name | None:
    """Return the name that a statement that cannot be read was to declare, with its place."""
    if broken.head not in _HEADS or not broken.name:
        return None
    found = re.compile(rf"\w\s+({re.escape(broken.name)})\b").search(line.logical.text, line.start)
    return Name(broken.name, found.start(1), found.end(1)) if found else None


def _parts(block: Block) -> Iterator[tuple[int, int]]:
    """Yield first and last line of each section of a block."""
    heads = [section.header.logical.number for section in block.sections]
    after = block.closer.logical.number if block.closer is not None else _end(_last(block)) + 1
    for first, following in zip(heads, (*heads[1:], after), strict=True):
        yield first, following - 1


def _end(line: Line) -> int:
    """Return the last physical line of a statement."""
    return line.logical.number + line.logical.text.count("\n")


def _last(block: Block) -> Line:
    section = block.sections[-1]
    last = section.body[-1] if section.body else section.header
    return last if isinstance(last, Line) else last.closer or _last(last)
