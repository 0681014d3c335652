"""The tasks of a text, apart from its control statements, and the order in which they call each other."""

from collections.abc import Mapping
from dataclasses import dataclass

from ropsim.language.blocks import Block
from ropsim.language.clause import Clause, understand
from ropsim.language.findings import names as name_kinds
from ropsim.language.report import Report
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.text import Line


@dataclass(frozen=True, slots=True)
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


def control_statements(tree: tuple[Line | Block, ...]) -> tuple[Line | Block, ...]:
    """Return what stands outside the tasks."""
    return tuple(i for i in tree if not ((isinstance(i, Block) and i.opener.head == "task") or is_task(i)))


def tasks_of(tree: tuple[Line | Block, ...], report: Report) -> dict[str, TaskText]:
    """Return the tasks of a text by name, in order; a second one of the same name is reported."""
    found: dict[str, TaskText] = {}
    for number, item in enumerate(tree):
        if not isinstance(item, Block) or not is_task(item):
            continue
        header = item.opener.statement
        assert isinstance(header, syntax.TaskHeader | syntax.Broken)
        name = header.name.text if isinstance(header, syntax.TaskHeader) else header.name or f"#{number}"
        if name in found:
            report.line(
                name_kinds.DUPLICATE, item.opener, f"task `{name}` is defined twice", "rename one of them"
            )
            name = f"#{number}"
        block, clauses = _split_contract(item)
        found[name] = TaskText(
            name, block, header if isinstance(header, syntax.TaskHeader) else None, clauses
        )
    return found


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


def callee_first(tasks: Mapping[str, TaskText]) -> list[str]:
    """Return the tasks in an order in which those called come first, as far as calls are not circular."""
    order: list[str] = []
    seen: set[str] = set()
    for start in tasks:
        stack = [(start, iter(_callees(tasks[start].block, tasks)))] if start not in seen else []
        seen.add(start)
        while stack:
            name, callees = stack[-1]
            following = next((c for c in callees if c not in seen), None)
            if following is None:
                order.append(name)
                stack.pop()
            else:
                seen.add(following)
                stack.append((following, iter(_callees(tasks[following].block, tasks))))
    return order


def _callees(block: Block, tasks: Mapping[str, TaskText]) -> list[str]:
    found: list[str] = []
    for section in block.sections:
        for item in section.body:
            if isinstance(item, Block):
                found += _callees(item, tasks)
            else:
                found += [n for n in _called(item.statement) if n in tasks]
    return found


def _called(statement: syntax.Statement | None) -> list[str]:
    match statement:
        case syntax.Call(name=name):
            return [name.text]
        case syntax.Assign(value=nodes.Function(name=name)):
            return [name.text]
        case syntax.If(body=inner) | syntax.WaitCondition(otherwise=inner):
            return _called(inner)
    return []
