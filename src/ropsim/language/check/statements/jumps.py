"""Ways out: `break`, `continue` and `return`."""

from ropsim.language.check.doubts import facing, origins
from ropsim.language.check.expressions import convert, poses, values
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body, RejectedError
from ropsim.language.check.scope.types import article
from ropsim.language.findings import syntax as kinds
from ropsim.language.findings import types as type_kinds
from ropsim.language.syntax import statements as syntax
from ropsim.program import Assign, Block, Break, Continue, Return


def jump(body: Body, node: syntax.Jump) -> Block:
    """Return `break` or `continue` of the innermost loop.

    A `for each` is several loops for the machine, so leaving it sets a flag that the outer ones test.
    """
    if not body.loops:
        body.fail(kinds.MISPLACED, node, f"`{node.word}` outside of a loop", "use `return` to leave a task")
    if node.word == "continue":
        return (Continue(body.statement_span),)
    flag = body.loops[-1].flag
    leave = (Break(body.statement_span),)
    return (Assign(flag, fold.TRUE, body.statement_span), *leave) if flag else leave


def return_statement(body: Body, node: syntax.Return) -> Block:
    """Return the way out of a task."""
    if not body.task:
        body.fail(kinds.MISPLACED, node, "`return` outside of a task", "use `stop` to end the program")
    if body.result is None and body.is_tolerant:
        raise RejectedError
    if body.result is None:
        if node.value is not None:
            body.lacks_result = True
            hint = "write the type into the header: `-> length`"
            body.fail(type_kinds.WRONG_TYPE, node.value, f"task `{body.task}` returns no value", hint)
        return (Return(None, body.statement_span),)
    if node.value is None:
        body.fail(
            type_kinds.NO_RETURN,
            node,
            f"`return` needs a value: task `{body.task}` returns {article(body.result)}",
        )
    value = values.check(body, node.value)
    facing.check_target(body, node.value)
    expression = convert.to(body, value, body.result, node.value, "the value of `return`")
    if origins.has_sensors(body.world):
        body.returned.append(origins.origin_of(body, expression))
    return (Return(poses.kept(value, expression), body.statement_span),)
