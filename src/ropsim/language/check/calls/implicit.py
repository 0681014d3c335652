"""Implicit parameters of classic tasks: reference locations `l, l1, l2 …` and names read before written."""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

from ropsim.language.blocks.matching import Block
from ropsim.language.check.calls import arguments as calls
from ropsim.language.check.scope.types import POSE, known
from ropsim.language.check.scope.world import Signature
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.text import Line

MAX_REFERENCES = 99

_REFERENCE = re.compile(r"l(\d{0,2})")


@dataclass(slots=True)
class Uses:
    """Names that the body of a task reads and writes.

    Attributes:
        written: names that have a value.
        read_first: names read before they were written.
        references: highest number of a reference location.
        has_plain: whether `l` stands for the first one (else `l1`).
    """

    written: set[str] = field(default_factory=set)
    read_first: set[str] = field(default_factory=set)
    references: int = 0
    has_plain: bool = False

    def read(self, name: str) -> None:
        """Note that a name is read."""
        if name in self.written:
            return
        match = _REFERENCE.fullmatch(name)
        if match and match.group(1) != "0":
            self.references = max(self.references, int(match.group(1) or 1))
            self.has_plain |= name == "l"
        else:
            self.read_first.add(name)

    def reference_names(self) -> tuple[str, ...]:
        """Return the names of the reference locations, first to last."""
        first = "l" if self.has_plain or (self.references == 1 and "l1" not in self.read_first) else "l1"
        names = (first, *(f"l{k}" for k in range(2, self.references + 1)))
        return names[: self.references]


def uses(
    block: Block, known_names: Callable[[str], bool], signatures: Mapping[str, Signature]
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return reference locations and scalars (in alphabetical order) of a task without parameter list."""
    found = Uses()
    for section in block.sections:
        _walk(section.body, found, signatures)
    scalars = tuple(sorted(n for n in found.read_first if not known_names(n)))
    return found.reference_names(), scalars


def _walk(items: tuple[Line | Block, ...], found: Uses, signatures: Mapping[str, Signature]) -> None:
    for item in items:
        if isinstance(item, Line):
            _statement(item.statement, found, signatures)
            continue
        for section in item.sections:
            _statement(section.header.statement, found, signatures)
            _walk(section.body, found, signatures)
        if item.closer is not None:
            _statement(item.closer.statement, found, signatures)


def _statement(statement: syntax.Statement | None, found: Uses, signatures: Mapping[str, Signature]) -> None:
    match statement:
        case None | syntax.Broken() | syntax.ForEach():
            if isinstance(statement, syntax.ForEach):
                found.written.add(statement.name.text)
            return
        case syntax.Call():
            _call(statement, found, signatures)
        case syntax.Load():
            _read(statement.source, found)
            found.written.update(name.text for name in statement.names)
        case syntax.Assign():
            if isinstance(statement.value, nodes.Function) and statement.value.name.text in signatures:
                signature = signatures[statement.value.name.text]
                _call(calls.as_call(statement.value, signature), found, signatures)
            else:
                _read(statement.value, found)
            if statement.member is not None:
                found.read(statement.name.text)
            found.written.add(statement.name.text)
        case syntax.For():
            for bound in (statement.first, statement.last, statement.step):
                _read(bound, found)
            found.written.add(statement.name.text)
        case syntax.Motion(store=nodes.Name(text=name)):
            _fields(statement, found, signatures)
            found.written.add(name)
        case _:
            _fields(statement, found, signatures)


def _fields(statement: syntax.Statement, found: Uses, signatures: Mapping[str, Signature]) -> None:
    """Note the expressions of a statement without names of its own."""
    for name in statement.__dataclass_fields__:
        value = getattr(statement, name)
        for part in value if isinstance(value, tuple) else (value,):
            if isinstance(part, syntax.Setting):
                _read(part.value, found)
            elif isinstance(part, nodes.Name):
                continue  # names of tools, frames and outputs
            elif isinstance(part, _EXPRESSIONS):
                _read(part, found)
            elif hasattr(part, "start"):
                _statement(part, found, signatures)
    for expression in _plain_names(statement):
        _read(expression, found)


def _plain_names(statement: syntax.Statement) -> Iterator[nodes.Node]:
    """Yield the expressions that consist of a single name: there it is a value, not a name of something."""
    for name in ("target", "count", "condition", "duration", "value", "timeout", "message", "place"):
        part = getattr(statement, name, None)
        if isinstance(part, nodes.Name):
            yield part
    for part in statement.values if isinstance(statement, syntax.Print) else _via(statement):
        if isinstance(part, nodes.Name):
            yield part


def _via(statement: syntax.Statement) -> tuple[nodes.Node, ...]:
    return statement.via if isinstance(statement, syntax.Motion) else ()


def _call(statement: syntax.Call, found: Uses, signatures: Mapping[str, Signature]) -> None:
    signature = signatures.get(statement.name.text)
    arguments = statement.arguments
    if signature is not None:
        arguments = calls.spread(
            arguments, signature, lambda name: _REFERENCE.fullmatch(name.text) is not None
        )
    for index, item in enumerate(arguments):
        if signature is not None and _is_reference(item, index, signature):
            assert isinstance(item.value, nodes.Number)
            found.references = max(found.references, min(int(item.value.value), MAX_REFERENCES))
        else:
            _read(item.value, found)


def _is_reference(item: nodes.Item, index: int, signature: Signature) -> bool:
    value = item.value
    if not isinstance(value, nodes.Number) or not value.is_whole or value.unit:
        return False
    if item.name is not None:
        chosen = [f for f in signature.formals if f.name == item.name.text]
    else:
        chosen = list(signature.formals[index : index + 1])
    return bool(chosen) and known(chosen[0].type) == POSE


def _read(node: nodes.Node | None, found: Uses) -> None:
    """Note all names of an expression."""
    if isinstance(node, nodes.Name):
        found.read(node.text)
    elif node is not None:
        for part in _inner(node):
            _read(part, found)


def _inner(node: nodes.Node) -> tuple[nodes.Node | None, ...]:
    """Return the expressions inside an expression, from left to right."""
    match node:
        case nodes.Binary():
            return node.left, node.right
        case nodes.Unary() | nodes.Rebase() | nodes.Free() | nodes.State() | nodes.Member():
            return (node.operand,)
        case nodes.Index():
            return node.operand, node.index
        case nodes.External():
            return node.operand, *node.values
        case nodes.Function() | nodes.Joints():
            return node.values
        case nodes.Tuple():
            turned = [part for turn in node.turns for part in (*turn.values, turn.like)]
            counted = node.posture.turns if node.posture is not None else ()
            return *(item.value for item in node.items), *turned, *counted
        case _:
            return ()


_EXPRESSIONS = (
    nodes.Number, nodes.Text, nodes.Literal, nodes.Unary, nodes.Binary, nodes.Rebase, nodes.External,
    nodes.Free, nodes.State, nodes.Function, nodes.Tuple, nodes.Joints, nodes.Member,
    nodes.Index,
)  # fmt: skip
