"""Calls of tasks inside expressions: all of a line are reported at once."""

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import NoReturn

from ropsim.language.check.scope.body import Body, RejectedError
from ropsim.language.findings import names as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax


def refuse(body: Body, node: nodes.Function) -> NoReturn:
    """Report a call of a task inside an expression, and the calls behind it in the line.

    Raises:
        RejectedError: always.
    """
    _tell(body, node)
    statement = body.line.statement
    for call in _calls(statement.value if isinstance(statement, syntax.Assign) else statement):
        if call.start > node.start and _gives_result(body, call.name.text):
            _tell(body, call)
    raise RejectedError


def _tell(body: Body, node: nodes.Function) -> None:
    name, statement = node.name.text, body.line.statement
    hint = f"assign the result to a variable first: `v = {name}(…)`"
    if isinstance(statement, syntax.VariableDeclaration):
        variable = statement.name.text
        hint = f"declare `{variable}` without a value, and assign the result below: `{variable} = {name}(…)`"
    elif isinstance(statement, syntax.DECLARATIONS):
        hint = f"a declaration calls no task; assign the result to a variable: `v = {name}(…)`"
    body.warn(kinds.CALL_INSIDE, node.name, f"task `{name}` is called inside an expression", hint)


def _gives_result(body: Body, name: str) -> bool:
    signature = body.world.signatures.get(name)
    return name in body.tasks if signature is None else signature.result is not None


def _calls(node: object) -> Iterator[nodes.Function]:
    """Yield the calls of functions and tasks in a statement, outer ones first."""
    if isinstance(node, nodes.Function):
        yield node
    if isinstance(node, syntax.Assign) and isinstance(node.value, nodes.Function):
        node = node.value.arguments
    parts = [getattr(node, one.name) for one in fields(node)] if is_dataclass(node) else node
    if isinstance(parts, list | tuple):
        for part in parts:
            yield from _calls(part)
