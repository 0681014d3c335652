"""Expressions -> stack code."""

from collections.abc import Callable
from functools import lru_cache
from typing import Any, NoReturn

from ropsim.core import maker
from ropsim.flow import TargetOrientation
from ropsim.icr import Constant as IcrConstant
from ropsim.icr import Step, Type, Value
from ropsim.program import expressions as sir
from ropsim.program.diagnostics import unsound
from ropsim.program.scope import Scope
from ropsim.spatial import quaternion

_made = maker(IcrConstant)
_BOOL, _INT, _REAL = Type.BOOL, Type.INT, Type.REAL
_VEC, _ORI, _POSE = Type.VEC, Type.ORI, Type.POSE

_ARITHMETIC = {"add", "sub", "mul", "div", "mod", "min", "max"}
_COMPARISON = {"eq", "ne", "lt", "le", "gt", "ge"}
_REAL_UNARY = {"sqrt", "sin", "cos", "tan", "asin", "acos"}
_SUFFIX = {Type.INT: ".I", Type.REAL: ".R", Type.VEC: ".V"}
_OPERATIONS = {
    Type.INT: _ARITHMETIC | _COMPARISON,
    Type.REAL: _ARITHMETIC | _COMPARISON,
    Type.VEC: {"add", "sub"},
}
_PLAIN = {
    "not": ("NOT", Type.BOOL),
    "invert": ("INV", Type.POSE),
    "position": ("GETPOS", Type.POSE),
    "orientation": ("GETORI", Type.POSE),
    "and": ("AND", Type.BOOL),
    "or": ("OR", Type.BOOL),
    "compose": ("COMPOSE", Type.POSE),
    "reframe": ("REFRAME", Type.POSE),
    "distance": ("DIST", Type.POSE),
}


def evaluate(scope: Scope, expression: sir.Expression, want: Type) -> None:
    """Emit code that leaves the value of `expression` on the stack, as type `want` (INT widens to REAL).

    Raises:
        LoweringError: the expression contradicts itself.
    """
    if type(expression) is sir.Constant:
        if want is _REAL and isinstance(expression.value, int):
            push(scope, _REAL, float(expression.value))
            return
        found = _constant(scope, expression)
    else:
        found = _EMITTED[type(expression)](scope, expression)
    if found is _INT and want is _REAL:
        scope.emitter.emit("I2R")
    elif found is not want:
        raise unsound(f"a value of type {found.value} stands where {want.value} is needed")


def static_type(scope: Scope, expression: sir.Expression) -> Type:
    """Return the type that an expression has in ICR."""
    if isinstance(expression, sir.Variable):
        return scope.type_of(expression.name)
    if isinstance(expression, sir.SignalValue):
        return scope.channel(expression.name).type
    return expression.type


def push(scope: Scope, kind: Type, value: Value) -> None:
    """Emit a PUSH."""
    if value and (kind is _REAL or kind is _INT):  # of zeros there are two, which are equal
        scope.emitter.add(_pushed(kind, value))
    else:
        scope.emitter.emit("PUSH", _made(kind, value))


@lru_cache(maxsize=4096)
def _pushed(kind: Type, number: Value) -> Step:
    """Return the PUSH of a number: most programs push the same ones again and again."""
    return Step("PUSH", (IcrConstant(kind, number),))


def zero(scope: Scope, kind: Type) -> IcrConstant:
    """Return the value that a variable has if a program reads it before an assignment."""
    axes = scope.used.axes or scope.known.axes
    scope.used.has_guessed_axes |= axes is None and kind is Type.JOINTS
    return zero_of(kind, axes or 1)


def zero_of(kind: Type, axes: int) -> IcrConstant:
    """Return the zero of a type, for a number of joint coordinates."""
    identity = (1.0, 0.0, 0.0, 0.0)
    values: dict[Type, Value] = {
        Type.BOOL: False,
        Type.INT: 0,
        Type.REAL: 0.0,
        Type.STR: "",
        Type.VEC: (0.0, 0.0, 0.0),
        Type.ORI: identity,
        Type.POSE: (0.0, 0.0, 0.0, *identity),
        Type.JOINTS: (0.0,) * axes,
    }
    return IcrConstant(kind, values[kind])


def _variable(scope: Scope, expression: sir.Variable) -> Type:
    scope.emitter.emit("LOAD", expression.name)
    return scope.type_of(expression.name)


def _signal(scope: Scope, expression: sir.SignalValue) -> Type:
    channel = scope.channel(expression.name)
    scope.emitter.emit("IN", channel.name)
    return channel.type


def _component(scope: Scope, expression: sir.Component) -> Type:
    evaluate(scope, expression.operand, static_type(scope, expression.operand))
    scope.emitter.emit("GETC", expression.index)
    return expression.type


def _command_pose(scope: Scope, expression: sir.CommandPose) -> Type:
    scope.emitter.emit("CURPOSE")
    return expression.type


def _in_frame(scope: Scope, expression: sir.InFrame) -> Type:
    evaluate(scope, expression.operand, _POSE)
    scope.emitter.emit("INFRAME", scope.frame(expression.frame) if expression.frame else "")
    return expression.type


def _element(scope: Scope, expression: sir.Element) -> Type:
    evaluate(scope, expression.index, _INT)
    scope.used.lists.setdefault(expression.list)
    scope.emitter.emit("ITEM", expression.list)
    return expression.type


def _home(_: Scope, __: sir.Home) -> NoReturn:
    raise unsound("the home position is a target of PTP moves only")


def _in_axes(scope: Scope, expression: sir.InAxes) -> Type:
    """Emit a location that keeps its axes."""
    evaluate(scope, expression.operand, _POSE)
    push(scope, _ORI, quaternion.unit(expression.axes))
    scope.emitter.emit("AXES")
    return expression.type


def _offset(scope: Scope, expression: sir.Offset) -> Type:
    """Emit a location that is shifted along its axes."""
    evaluate(scope, expression.operand, _POSE)
    evaluate(scope, expression.way, _VEC)
    scope.emitter.emit("OFFSET")
    return expression.type


def _kept(scope: Scope, expression: sir.Kept) -> Type:
    if not scope.kept:
        raise unsound("no value is kept where one is taken")
    scope.emitter.emit("LOAD", scope.kept[-1])
    return expression.type


def _keeping(scope: Scope, expression: sir.Keeping) -> Type:
    kind = static_type(scope, expression.value)
    evaluate(scope, expression.value, kind)
    name = scope.hide("kept", kind)
    scope.emitter.emit("STORE", name)
    scope.kept.append(name)
    evaluate(scope, expression.result, expression.type)
    scope.kept.pop()
    return expression.type


def _posture(scope: Scope, expression: sir.InPosture) -> Type:
    evaluate(scope, expression.operand, _POSE)
    words, turns = expression.request.words, expression.request.turns
    if words:
        scope.emitter.emit("POSTURE", "-".join(words))
    for turn in turns:
        push(scope, _INT, turn)
    if turns:
        scope.emitter.emit("TURNS", len(turns))
    if expression.request.orientation is TargetOrientation.FREE:
        scope.emitter.emit("ORI.FREE")
    return expression.type


def _vector(scope: Scope, expression: sir.MakeVector) -> Type:
    _all(scope, (expression.x, expression.y, expression.z), "MKVEC")
    return expression.type


def _zyx(scope: Scope, expression: sir.MakeZyx) -> Type:
    _all(scope, (expression.c, expression.b, expression.a), "MKORI.ZYX")
    return expression.type


def _pose(scope: Scope, expression: sir.MakePose) -> Type:
    evaluate(scope, expression.position, _VEC)
    evaluate(scope, expression.orientation, _ORI)
    scope.emitter.emit("MKPOSE")
    return expression.type


def _external(scope: Scope, expression: sir.MakeExternal) -> Type:
    evaluate(scope, expression.pose, _POSE)
    _all(scope, expression.values, "MKEXT", len(expression.values))
    return expression.type


def _joints(scope: Scope, expression: sir.MakeJoints) -> Type:
    scope.used.axes = scope.used.axes or len(expression.values)
    _all(scope, expression.values, "MKJ", len(expression.values))
    return expression.type


def _all(scope: Scope, values: tuple[sir.Expression, ...], mnemonic: str, *operands: int) -> None:
    for value in values:
        evaluate(scope, value, _REAL)
    scope.emitter.emit(mnemonic, *operands)


def _constant(scope: Scope, constant: sir.Constant) -> Type:
    kind, value = constant.type, constant.value
    if isinstance(value, tuple):
        numbers = tuple(map(float, value))
        if kind is _ORI or kind is _POSE:
            at = 3 if kind is _POSE else 0
            w, x, y, z = numbers[at : at + 4]
            numbers = (*numbers[:at], *quaternion.unit((w, x, y, z)), *numbers[at + 4 :])
        if kind is Type.JOINTS:
            scope.used.axes = scope.used.axes or len(numbers)
        value = numbers
    elif kind is _REAL:
        value = float(value)
    push(scope, kind, value)
    return kind


def _unary(scope: Scope, expression: sir.Unary) -> Type:
    operation, operand = expression.op, expression.operand
    kind = static_type(scope, operand)
    result = expression.type
    if operation in _PLAIN:
        mnemonic, need = _PLAIN[operation]
        evaluate(scope, operand, need)
        scope.emitter.emit(mnemonic)
    elif operation in _REAL_UNARY:
        evaluate(scope, operand, Type.REAL)
        scope.emitter.emit(operation.upper())
    elif operation in {"neg", "abs"} and kind in {Type.INT, Type.REAL}:
        need = Type.REAL if result is Type.REAL else kind
        evaluate(scope, operand, need)
        scope.emitter.emit(operation.upper() + _SUFFIX[need])
    elif operation == "to_real":
        evaluate(scope, operand, Type.REAL)
    elif operation in {"trunc", "round"}:
        evaluate(scope, operand, kind)
        if kind is Type.REAL:
            scope.emitter.emit(operation.upper())
    else:
        raise unsound(f"operation `{operation}` does not exist for type {kind.value}")
    return result


def _binary(scope: Scope, expression: sir.Binary) -> Type:
    operation, left, right = expression.op, expression.left, expression.right
    result = expression.type
    of_left, of_right = static_type(scope, left), static_type(scope, right)
    need = _REAL if result is _REAL or of_left is _REAL or of_right is _REAL else of_left
    if operation in _PLAIN:
        mnemonic, need = _PLAIN[operation]
    elif operation in _OPERATIONS.get(need, set()):
        mnemonic = operation.upper() + _SUFFIX[need]
    elif operation in {"eq", "ne"} and need is Type.BOOL:
        mnemonic = "EQ.B"
    elif operation in {"pow", "atan2"}:
        mnemonic, need = operation.upper(), Type.REAL
    else:
        raise unsound(f"operation `{operation}` does not exist for type {need.value}")
    evaluate(scope, left, need)
    evaluate(scope, right, need)
    scope.emitter.emit(mnemonic)
    if operation == "ne" and need is Type.BOOL:
        scope.emitter.emit("NOT")
    if operation in {"pow", "atan2"} and result is Type.INT:
        scope.emitter.emit("ROUND")
    return result


_EMITTED: dict[type, Callable[[Scope, Any], Type]] = {
    sir.Constant: _constant,
    sir.Variable: _variable,
    sir.SignalValue: _signal,
    sir.Unary: _unary,
    sir.Binary: _binary,
    sir.Component: _component,
    sir.MakeVector: _vector,
    sir.MakeZyx: _zyx,
    sir.MakePose: _pose,
    sir.MakeExternal: _external,
    sir.MakeJoints: _joints,
    sir.CommandPose: _command_pose,
    sir.InPosture: _posture,
    sir.InFrame: _in_frame,
    sir.InAxes: _in_axes,
    sir.Offset: _offset,
    sir.Keeping: _keeping,
    sir.Kept: _kept,
    sir.Element: _element,
    sir.Home: _home,
}
"""How the value of each kind of expression comes onto the stack; each returns its type."""
