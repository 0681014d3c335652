"""The tasks of a text, apart from its control statements, and the order in which they call each other."""

from collections.abc import Iterator, Mapping, Sequence

from ropsim.core import frozen_dataclass
from ropsim.language.blocks.clause import Clause, understand
from ropsim.language.blocks.matching import Block
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.text import Line


@frozen_dataclass
class TaskText:
    """A task of the text: its block, its header as far as readable, and its contract clauses."""

    name: str
    block: Block
    header: syntax.TaskHeader | None
    clauses: tuple[tuple[Line, Clause], ...]


def is_task(item: Line | Block) -> bool:
    """Return whether an item of the tree is a task, also one whose header is broken."""
    if not isinstance(item, Block):
        return False
    statement = item.opener.statement
    return isinstance(statement, syntax.TaskHeader) or (
        isinstance(statement, syntax.Broken) and statement.head == "task"
    )


def task_of(block: Block) -> TaskText:
    """Return a task by its block; its name is empty if the header has none."""
    header = block.opener.statement
    assert isinstance(header, syntax.TaskHeader | syntax.Broken)
    name = header.name.text if isinstance(header, syntax.TaskHeader) else header.name
    body, clauses = _split_contract(block)
    return TaskText(name, body, header if isinstance(header, syntax.TaskHeader) else None, clauses)


def _split_contract(block: Block) -> tuple[Block, tuple[tuple[Line, Clause], ...]]:
    """Return the block without the contract clauses at its head, and those."""
    first = block.sections[0]
    clauses: list[tuple[Line, Clause]] = []
    rest = list(first.body)
    place = 0
    while place < len(rest):
        line = rest[place]
        statement = line.statement if isinstance(line, Line) else None
        if isinstance(line, Line) and isinstance(statement, syntax.ContractClause):
            clauses.append((line, understand(statement.text)))
            del rest[place]
        elif isinstance(statement, syntax.Broken):
            place += 1
        else:
            break
    section = type(first)(first.header, tuple(rest))
    return Block((section, *block.sections[1:]), block.closer), tuple(clauses)


def callee_first(callees: Mapping[str, Sequence[str]]) -> list[str]:
    """Return tasks in an order in which those called come first, as far as calls are not circular.

    Args:
        callees: whom each task calls, by name; names that are no keys do not count.
    """
    order: list[str] = []
    seen: set[str] = set()
    for start in callees:
        stack = [(start, iter(callees[start]))] if start not in seen else []
        seen.add(start)
        while stack:
            name, called = stack[-1]
            following = next((one for one in called if one in callees and one not in seen), None)
            if following is None:
                order.append(name)
                stack.pop()
            else:
                seen.add(following)
                stack.append((following, iter(callees[following])))
    return order


def callees(block: Block) -> tuple[str, ...]:
    """Return the names that a block calls as tasks or may call, in order, each once."""
    return tuple(dict.fromkeys(_callees(block)))


def _callees(block: Block) -> Iterator[str]:
    for section in block.sections:
        for item in section.body:
            if isinstance(item, Block):
                yield from _callees(item)
            else:
                yield from _called(item.statement)


def _called(statement: syntax.Statement | None) -> list[str]:
    match statement:
        case syntax.Call(name=name):
            return [name.text]
        case syntax.Assign(value=nodes.Function(name=name)):
            return [name.text]
        case syntax.If(body=inner) | syntax.WaitCondition(otherwise=inner):
            return _called(inner)
    return []
