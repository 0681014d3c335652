"""Expressions -> stack code."""

from ropsim.icr import Constant as IcrConstant
from ropsim.icr import Type, Value
from ropsim.program import expressions as sir
from ropsim.program.diagnostics import unsound
from ropsim.program.scope import Scope
from ropsim.spatial import quaternion

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
    if isinstance(expression, sir.Constant) and want is Type.REAL and isinstance(expression.value, int):
        push(scope, Type.REAL, float(expression.value))
        return
    found = _emit(scope, expression)
    if found is Type.INT and want is Type.REAL:
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
    scope.emitter.push(IcrConstant(kind, value))


def zero(scope: Scope, kind: Type) -> IcrConstant:
    """Return the value that a variable has where a program reads it before it gives it one."""
    axes = scope.used.axes or scope.known.axes
    scope.used.has_guessed_axes |= axes is None and kind is Type.JOINTS
    return zero_of(kind, axes or 1)


def zero_of(kind: Type, axes: int) -> IcrConstant:
    """Return the zero of a type, of so many joint coordinates."""
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


def _emit(scope: Scope, expression: sir.Expression) -> Type:
    emit = scope.emitter.emit
    match expression:
        case sir.Constant():
            return _constant(scope, expression)
        case sir.Variable(name=name):
            emit("LOAD", name)
        case sir.SignalValue(name=name):
            emit("IN", scope.channel(name).name)
        case sir.Unary():
            return _unary(scope, expression)
        case sir.Binary():
            return _binary(scope, expression)
        case sir.Component(operand=operand, index=index):
            evaluate(scope, operand, static_type(scope, operand))
            emit("GETC", index)
        case sir.MakeVector() | sir.MakeZyx() | sir.MakePose() | sir.MakeExternal() | sir.MakeJoints():
            _make(scope, expression)
        case sir.CommandPose():
            emit("CURPOSE")
        case sir.InPosture():
            _posture(scope, expression)
        case sir.InFrame(operand=operand, frame=frame):
            evaluate(scope, operand, Type.POSE)
            emit("INFRAME", scope.frame(frame) if frame else "")
        case sir.InAxes() | sir.Offset():
            _axes(scope, expression)
        case sir.Keeping() | sir.Kept():
            _kept(scope, expression)
        case sir.Home():
            raise unsound("the home position is a target of PTP moves only")
    return static_type(scope, expression)


def _axes(scope: Scope, expression: sir.InAxes | sir.Offset) -> None:
    """Emit a location that keeps its axes, or one that is shifted along them."""
    evaluate(scope, expression.operand, Type.POSE)
    if isinstance(expression, sir.InAxes):
        push(scope, Type.ORI, quaternion.unit(expression.axes))
        scope.emitter.emit("AXES")
    else:
        evaluate(scope, expression.way, Type.VEC)
        scope.emitter.emit("OFFSET")


def _kept(scope: Scope, expression: sir.Keeping | sir.Kept) -> None:
    if isinstance(expression, sir.Kept):
        if not scope.kept:
            raise unsound("no value is kept where one is taken")
        scope.emitter.emit("LOAD", scope.kept[-1])
        return
    kind = static_type(scope, expression.value)
    evaluate(scope, expression.value, kind)
    name = scope.hide("kept", kind)
    scope.emitter.emit("STORE", name)
    scope.kept.append(name)
    evaluate(scope, expression.result, expression.type)
    scope.kept.pop()


def _posture(scope: Scope, expression: sir.InPosture) -> None:
    evaluate(scope, expression.operand, Type.POSE)
    words, turns = expression.request.words, expression.request.turns
    if words:
        scope.emitter.emit("POSTURE", "-".join(words))
    for turn in turns:
        push(scope, Type.INT, turn)
    if turns:
        scope.emitter.emit("TURNS", len(turns))


def _make(
    scope: Scope,
    expression: sir.MakeVector | sir.MakeZyx | sir.MakePose | sir.MakeExternal | sir.MakeJoints,
) -> None:
    match expression:
        case sir.MakeVector(x=x, y=y, z=z):
            _all(scope, (x, y, z), "MKVEC")
        case sir.MakeZyx(c=c, b=b, a=a):
            _all(scope, (c, b, a), "MKORI.ZYX")
        case sir.MakePose(position=position, orientation=orientation):
            evaluate(scope, position, Type.VEC)
            evaluate(scope, orientation, Type.ORI)
            scope.emitter.emit("MKPOSE")
        case sir.MakeExternal(pose=pose, values=values):
            evaluate(scope, pose, Type.POSE)
            _all(scope, values, "MKEXT", len(values))
        case sir.MakeJoints(values=values):
            scope.used.axes = scope.used.axes or len(values)
            _all(scope, values, "MKJ", len(values))


def _all(scope: Scope, values: tuple[sir.Expression, ...], mnemonic: str, *operands: int) -> None:
    for value in values:
        evaluate(scope, value, Type.REAL)
    scope.emitter.emit(mnemonic, *operands)


def _constant(scope: Scope, constant: sir.Constant) -> Type:
    kind, value = constant.type, constant.value
    if isinstance(value, tuple):
        numbers = tuple(float(number) for number in value)
        if kind is Type.ORI or kind is Type.POSE:
            at = 3 if kind is Type.POSE else 0
            w, x, y, z = numbers[at : at + 4]
            numbers = (*numbers[:at], *quaternion.unit((w, x, y, z)), *numbers[at + 4 :])
        if kind is Type.JOINTS:
            scope.used.axes = scope.used.axes or len(numbers)
        value = numbers
    elif kind is Type.REAL:
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
    kinds = {static_type(scope, left), static_type(scope, right)}
    need = Type.REAL if Type.REAL in kinds or result is Type.REAL else static_type(scope, left)
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
