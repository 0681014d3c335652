"""Going through all statements of a block, and through all parts of an expression."""

from collections.abc import Iterator
from dataclasses import fields, is_dataclass

from ropsim.program.expressions import Expression, SignalValue, Variable
from ropsim.program.statements import Block, For, If, Repeat, Statement, WaitUntil, While, With

_HOLDING = frozenset({If, While, Repeat, For, With, WaitUntil})
"""Statements with blocks inside."""


def parts(statement: Statement) -> tuple[Block, ...]:
    """Return the blocks inside a statement."""
    match statement:
        case If():
            return (*(block for _, block in statement.branches), statement.otherwise)
        case While() | Repeat() | For() | With():
            return (statement.body,)
        case WaitUntil():
            return (statement.otherwise,)
        case _:
            return ()


def walk(block: Block) -> Iterator[Statement]:
    """Yield all statements of a block and of the blocks inside, in the order of the text."""
    work = list(reversed(block))
    while work:
        statement = work.pop()
        yield statement
        if type(statement) in _HOLDING:
            for part in reversed(parts(statement)):
                work += reversed(part)


def signals_of(expression: Expression) -> Iterator[str]:
    """Yield the signals that an expression reads."""
    return (one.name for one in _leaves(expression) if isinstance(one, SignalValue))


def variables_of(expression: Expression) -> Iterator[str]:
    """Yield the variables that an expression reads."""
    return (one.name for one in _leaves(expression) if isinstance(one, Variable))


def _leaves(expression: Expression) -> Iterator[SignalValue | Variable]:
    work: list[object] = [expression]
    while work:
        part = work.pop()
        if isinstance(part, SignalValue | Variable):
            yield part
        elif isinstance(part, tuple):
            work += part
        elif is_dataclass(part):
            work += (getattr(part, one.name) for one in fields(part))
