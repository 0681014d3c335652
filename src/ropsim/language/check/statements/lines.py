"""One line to its statements: the table of lines."""

from collections.abc import Callable
from typing import Any

from ropsim.core import maker
from ropsim.language.check.calls import arguments as calls
from ropsim.language.check.expressions import frames, values
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import BOOL
from ropsim.language.check.statements import actions, assignments, jumps, motions, never_run
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.nodes import Name
from ropsim.language.syntax.words import RESERVED
from ropsim.program import Block, If, Set, Settings

_DECLARATIONS = (
    syntax.ProgramHeader, syntax.Units, syntax.Mode, syntax.FrameDeclaration, syntax.LocationDeclaration,
    syntax.ToolDeclaration, syntax.SignalDeclaration, syntax.ConstantDeclaration, syntax.PatternDeclaration,
)  # fmt: skip

_if = maker(If)


def statement(body: Body, node: syntax.Statement | None) -> Block:
    """Return the statements of one line.

    Raises:
        RejectedError: the line is wrong.
    """
    return _LINES[type(node)](body, node)


def poison_targets(body: Body, node: syntax.Statement | None) -> None:
    """Mark the names that a wrong line would have defined, so that they are not reported as well."""
    match node:
        case syntax.Assign(name=name) | syntax.For(name=name):
            body.poison(name.text)
        case syntax.Motion(store=Name(text=name)):
            body.poison(name)
        case syntax.ForEach(name=name):
            body.poison(name.text)
        case syntax.Load(names=names):
            for name in names:
                body.poison(name.text)
        case syntax.Broken(head=head, name=name):
            if head not in RESERVED:  # no name, so a look-up is useless
                body.poison(head)
            if name and head == "for":
                body.poison(name)
        case syntax.If(body=inner) if inner is not None:
            poison_targets(body, inner)


def _in_block(body: Body, node: syntax.Statement | None) -> Block:
    """Return the statement behind `then` or `else` on a line: a block of one statement, never empty.

    A `set frame` leaves nothing to run, but a wait with `else` does not end the program.
    """
    body.depth += 1
    with frames.in_block(body):
        try:
            return statement(body, node) or (Set(Settings(), body.statement_span),)
        finally:
            body.depth -= 1


def _call(body: Body, node: syntax.Call) -> Block:
    return (calls.call(body, node),)


def _wait_until(body: Body, node: syntax.WaitCondition) -> Block:
    otherwise = _in_block(body, node.otherwise) if node.otherwise else ()
    return actions.wait_until(body, node, otherwise)


def _one_line_if(body: Body, node: syntax.If) -> Block:
    condition = values.expect(body, node.condition, BOOL, "the condition of `if`")
    never_run.check_condition(body, node, node.condition, condition)
    return (_if(((condition, _in_block(body, node.body)),), (), body.statement_span, ()),)


def _variable(body: Body, node: syntax.VariableDeclaration) -> Block:
    _declaration(body, node)
    return assignments.initial(body, node)


def _declaration(body: Body, node: syntax.Statement) -> Block:
    """Return nothing: declarations have been read before; but they must stand outside of tasks and blocks."""
    if body.task or body.depth > 1:
        message = f"`{body.line.head}` inside a task or a block"
        body.fail(kinds.MISPLACED, node, message, "declare it outside, at the top of the text")
    return ()


def _contract(body: Body, node: syntax.ContractClause) -> Block:
    body.fail(
        kinds.MISPLACED, node, "a contract stands directly after the header of its task", "move it there"
    )


def _broken(body: Body, node: syntax.Broken) -> Block:
    """Return nothing: the line has its finding already."""
    body.has_gaps = body.in_force.is_read = True
    poison_targets(body, node)
    return ()


_LINES: dict[type, Callable[[Body, Any], Block]] = {
    syntax.Motion: motions.motion,
    syntax.Gripper: actions.gripper,
    syntax.SetSignal: actions.set_signal,
    syntax.SetMode: actions.set_mode,
    syntax.WaitTime: actions.wait,
    syntax.WaitCondition: _wait_until,
    syntax.Print: actions.message,
    syntax.Stop: actions.stop,
    syntax.Call: _call,
    syntax.Assign: assignments.assign,
    syntax.Load: assignments.load,
    syntax.If: _one_line_if,
    syntax.Jump: jumps.jump,
    syntax.Return: jumps.return_statement,
    syntax.VariableDeclaration: _variable,
    syntax.ContractClause: _contract,
    syntax.Broken: _broken,
    **dict.fromkeys(_DECLARATIONS, _declaration),
}
