"""Statements that assign variables: `=`, `load`, `var` and calls with a result."""

from ropsim.core import maker
from ropsim.language.check.calls import arguments as calls
from ropsim.language.check.calls import first_values
from ropsim.language.check.doubts import facing, origins
from ropsim.language.check.expressions import components, convert, frames, other_values, poses, values
from ropsim.language.check.scope import fold, hidden
from ropsim.language.check.scope.body import Body, Made, RejectedError
from ropsim.language.check.scope.types import (
    ANGLE,
    INT,
    LENGTH,
    POSE,
    AnyType,
    Type,
    Unknown,
    Value,
    article,
    bind,
    known,
)
from ropsim.language.check.scope.world import Listed, Pattern, Poison, Symbol, Variable
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.program import Assign, AssignComponent, Block, Constant, Expression, SignalUse
from ropsim.program import Variable as VariableExpression

_assign, _made = maker(Assign), maker(Made)


def assign(body: Body, node: syntax.Assign) -> Block:
    """Return an assignment; the first one of a name declares it."""
    if node.member is not None:
        return _assign_member(body, node, node.member)
    if isinstance(node.value, nodes.Function) and node.value.name.text in body.world.signatures:
        return _assign_call(body, node, node.value)
    symbol = body.find(node.name.text)
    is_output = isinstance(symbol, SignalUse) and not symbol.is_input
    if is_output and other_values.is_unlike(body, node.value):
        other_values.refuse_assignment(body, node)
    value = values.check(body, node.value)
    facing.check_target(body, node.value)
    if is_output:
        other_values.refuse_assignment(body, node)
    variable = target(body, node.name, _type_of(body, value))
    if known(variable.type) == INT:
        first_values.look(body, node, variable, value)
    expression = convert.to(body, value, variable.type, node.value, f"the value of `{node.name.text}`")
    origins.note(body, node.name.text, variable, expression)
    return (_assign(variable.name, poses.kept(value, expression), body.statement_span),)


def load(body: Body, node: syntax.Load) -> Block:
    """Return the copies of x, y, z (pitch, roll, or roll, pitch, yaw) of a location.

    The location is read as a whole before any of them is written.
    """
    names = [name.text for name in node.names]
    for place, name in enumerate(node.names):
        if name.text in names[:place]:
            hint = "give each number a variable of its own"
            body.fail(name_kinds.DUPLICATE, name, f"`load` would write `{name.text}` twice", hint)
    source, before = _read_once(body, values.expect(body, node.source, POSE, "the source of `load`"))
    numbers = components.numbers_in_frame(body, source)
    parts = [(fold.component(numbers, k), LENGTH) for k in range(3)]
    if len(node.names) == 5:
        parts += [(angle, ANGLE) for angle in components.pitch_roll(body, source)]
    elif len(node.names) == 6:
        parts += [(fold.component(numbers, k), ANGLE) for k in (3, 4, 5)]
    result: list[Assign] = [*before]
    for name, (expression, kind) in zip(node.names, parts, strict=False):
        variable = target(body, name, kind)
        body.read.add(variable.name)  # the form of `load` uses all names, including unused ones
        fitted = convert.to(body, Value(expression, kind), variable.type, name, f"`{name.text}`")
        result.append(Assign(variable.name, fitted, body.statement_span))
    return tuple(result)


def _read_once(body: Body, source: Expression) -> tuple[Expression, tuple[Assign, ...]]:
    """Return a location to take numbers from, and the assignment that stores it if its parts may change."""
    inner = fold.numbers_of(source)
    if isinstance(inner, Constant | VariableExpression):
        return source, ()
    kept = body.hidden("load.source", POSE).name
    return VariableExpression(kept, POSE.value), (Assign(kept, source, body.statement_span),)


def initial(body: Body, node: syntax.VariableDeclaration) -> Block:
    """Return the first assignment of a `var` outside all tasks."""
    symbol = body.world.symbols.get(node.name.text)
    if node.value is None or not isinstance(symbol, Variable):
        return ()
    if node.type is None:
        declared = _made(body.report.source, body.line, node.name, symbol.name)
        body.declared.setdefault(symbol.name, declared)
    value = values.check(body, node.value)
    facing.check_target(body, node.value)
    expression = convert.to(body, value, symbol.type, node.value, f"the value of `{node.name.text}`")
    return (Assign(symbol.name, poses.kept(value, expression), body.statement_span),)


def target(body: Body, name: nodes.Name, kind: AnyType) -> Variable:
    """Return the variable to assign, made now if the name is new.

    Raises:
        RejectedError: the name cannot be assigned.
    """
    symbol = body.find(name.text)
    if isinstance(symbol, Variable) and not symbol.is_fixed:
        return symbol
    taken = _what(symbol) if symbol is not None and not isinstance(symbol, Poison) else ""
    taken = taken or hidden.declared_as(body.world, name.text)
    if not taken:
        if body.world.is_strict and symbol is None:
            hint = f"write `var {name.text}: type` outside the tasks, or make it a parameter"
            body.fail(kinds.UNDECLARED, name, f"`{name.text}` is not declared", hint)
        variable = body.declare(name.text, kind)
        body.made.setdefault(name.text, _made(body.report.source, body.line, name, variable.name))
        return variable
    body.fail(
        name_kinds.NOT_ASSIGNABLE,
        name,
        f"`{name.text}` cannot be assigned: it is {taken}",
        "choose another name for the variable",
    )


def _what(symbol: Symbol) -> str:
    """Return the kind of an entity that cannot be assigned."""
    match symbol:
        case Variable():
            return "the counter of a loop"
        case Pattern():
            return "a pattern"
        case Listed():
            return "a list of points"
        case SignalUse(is_input=True):
            return "an input, which the cell sets"
        case SignalUse():
            return "an output, which `set` sets"
        case Value():
            return "a location that keeps its value" if known(symbol.type) == POSE else "a constant"
    return "a name for something else"


def _assign_member(body: Body, node: syntax.Assign, member: nodes.Name) -> Block:
    symbol = body.find(node.name.text)
    if symbol is None:
        values.name(body, node.name)
    if isinstance(symbol, Value) and known(symbol.type) == POSE:
        message = f"`{node.name.text}` cannot be assigned: it is {_what(symbol)}"
        hint = f"copy it first: `q = {node.name.text}`, then `q.{member.text} = …`"
        body.fail(name_kinds.NOT_ASSIGNABLE, node.name, message, hint)
    variable = target(body, node.name, POSE)
    body.read.add(variable.name)
    kind = known(variable.type)
    if isinstance(kind, Type) and kind != POSE:
        body.fail(
            name_kinds.UNKNOWN_MEMBER,
            member,
            f"{article(kind)} has no component `{member.text}`",
            "locations have components",
        )
    index, member_type = values.member(body, member)
    convert.to(
        body, Value(VariableExpression(variable.name, POSE.value), kind), POSE, node.name, "the location"
    )
    value = values.expect(body, node.value, member_type, f"`{member.text}`")
    if frames.read(body) == fold.IDENTITY:
        return (AssignComponent(variable.name, index, value, body.statement_span),)
    return _assign_in_frame(body, variable.name, index, value)


def _assign_in_frame(body: Body, name: str, index: int, value: Expression) -> Block:
    """Change a component as seen in the frame in force, on a copy: `value` may read `name` itself."""
    here = VariableExpression(name, POSE.value)
    copy = body.hidden(f"{name}.seen", POSE).name
    seen = VariableExpression(copy, POSE.value)
    span = body.statement_span
    return (
        Assign(copy, components.numbers_in_frame(body, here), span),
        AssignComponent(copy, index, value, span),
        Assign(name, components.reframed(body, body.in_force.X_KC, seen), span),
    )


def _assign_call(body: Body, node: syntax.Assign, call: nodes.Function) -> Block:
    signature = body.world.signatures[call.name.text]
    statement = calls.call(body, calls.as_call(call, signature))
    if signature.result is None and signature.name in body.world.without_result:
        raise RejectedError
    if signature.result is None:
        hint = "give its header a result: `-> type`"
        body.fail(kinds.WRONG_TYPE, call, f"task `{signature.name}` returns no value", hint)
    variable = target(body, node.name, signature.result)
    kind = known(variable.type)
    if isinstance(kind, Unknown):
        bind(kind, signature.result)
    elif kind != signature.result:
        returned = article(signature.result)
        message = f"`{node.name.text}` is {article(kind)}, task `{signature.name}` returns {returned}"
        body.fail(kinds.WRONG_TYPE, call, message, "use a variable of its own for the result")
    if origins.is_number(variable):
        formals = tuple(formal.name for formal in signature.formals)
        origins.keep(body, node.name.text, variable, origins.of_result(body, statement, formals))
    return (calls.with_result(statement, variable.name),)


def _type_of(body: Body, value: Value) -> AnyType:
    """Return the type of a first assignment; in a classic text a bare number leaves it to use."""
    if not value.is_bare or not body.world.is_classic:
        return value.type
    if value.type == INT and not fold.number_of(value.expression) is not None:
        return INT
    return Unknown()
