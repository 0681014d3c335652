"""Statements and tasks that no way through the program leads to."""

from collections.abc import Iterable, Iterator, Mapping

from ropsim.core import Diagnostic, Span
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.program import (
    Assign,
    AssignComponent,
    Block,
    Break,
    Call,
    Constant,
    Continue,
    For,
    Grip,
    If,
    Message,
    Move,
    Output,
    Repeat,
    Return,
    Set,
    Statement,
    Stop,
    Task,
    Wait,
    WaitUntil,
    While,
    With,
)


def uncalled(calls: Mapping[str, Iterable[str]], control: Iterable[str]) -> Iterator[str]:
    """Return the tasks that the control statements do not reach.

    Args:
        calls: names of the tasks that each task of the text calls; calls of library tasks may be unknown.
        control: tasks that the control statements call.
    """
    work = list(control)
    called: set[str] = set()
    while work:
        name = work.pop()
        if name in calls and name not in called:
            called.add(name)
            work += calls[name]
    return (name for name in calls if name not in called)


def never_called(task: Task) -> Diagnostic:
    """Return a hint at a task that the control statements do not reach (N238)."""
    message, hint = f"nothing calls the task `{task.name}`", "call it, or leave it out"
    return name_kinds.UNUSED_TASK.at(task.span, message, hint=hint)


def unreached(places: Iterable[tuple[Span, Span]]) -> Iterator[Diagnostic]:
    """Yield a warning for the first statement of each block that no way leads to (T337).

    Args:
        places: where these and the statements before them lie in the text.
    """
    for one, end in places:
        hint = f"line {end.line} never goes on to it"
        yield kinds.NEVER_REACHED.at(one, "this statement is never reached", hint=hint)


def late(block: Block) -> Iterator[tuple[Span, Span]]:
    """Yield where statements are not reached, each with that before it, which does not go on."""
    last = len(block) - 1
    for number, statement in enumerate(block):
        if type(statement) in _PLAIN:
            continue
        for inner in _blocks(statement):
            yield from late(inner)
        if number < last and _ends(statement):
            if block[number + 1].span != statement.span:
                yield block[number + 1].span, statement.span
            return


def _blocks(statement: Statement) -> tuple[Block, ...]:
    match statement:
        case If(branches=branches, otherwise=otherwise):
            return (*(block for _, block in branches), otherwise)
        case While(body=body) | Repeat(body=body) | For(body=body) | With(body=body):
            return (body,)
    return ()


_PLAIN = frozenset({Move, Assign, AssignComponent, Call, Set, Grip, Output, Wait, Message})
"""Statements without blocks, none of which is a way out."""
_GOING_ON = _PLAIN | {WaitUntil, For}
"""Statements behind which control goes on, regardless of their content."""


def goes_on(statement: Statement) -> bool:
    """Return whether the code behind a statement may be reached."""
    return not _ends(statement)


def _ends(statement: Statement) -> bool:
    """Return whether nothing behind a statement is reached."""
    if type(statement) in _GOING_ON:
        return False
    match statement:
        case Return() | Stop() | Break() | Continue():
            return True
        case If(otherwise=()):
            return False
        case If(branches=branches, otherwise=otherwise):
            return all(_block_ends(block) for block in (*(one for _, one in branches), otherwise))
        case With(body=body):
            return _block_ends(body)
        case Repeat(count=None, until=None, body=body) | While(condition=Constant(value=True), body=body):
            return not _is_left(body)
    return False


def _block_ends(block: Block) -> bool:
    return any(_ends(statement) for statement in block)


def _is_left(body: Block) -> bool:
    """Return whether a `break` leaves the loop of a body."""
    return any(
        isinstance(one, Break)
        or (not isinstance(one, While | Repeat | For) and any(_is_left(block) for block in _blocks(one)))
        for one in body
    )
