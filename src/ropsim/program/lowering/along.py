"""Motions along a list of points -> ICR: a loop over its elements, or one curve through all of them."""

from collections.abc import Callable

from ropsim.icr import Type
from ropsim.program import expressions as sir
from ropsim.program.emitter import Label
from ropsim.program.lowering.expressions import evaluate, push
from ropsim.program.move import Along
from ropsim.program.scope import Scope

_NOWHERE = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
Emit = Callable[[], None]
"""Emits code that leaves a value on the stack."""


def placed_elements(scope: Scope, along: Along) -> Callable[[Emit], None]:
    """Emit code that computes once where a list lies; return what puts one of its points on the stack.

    The returned function takes code that puts the number of the point there.
    """
    before, behind = _held(scope, along.before), _held(scope, along.behind)
    scope.used.lists.setdefault(along.list)

    def point(number: Emit) -> None:
        if before is not None:
            before()
        number()
        scope.emitter.emit("ITEM", along.list)
        if before is not None:
            scope.emitter.emit("COMPOSE")
        if behind is not None:
            behind()
            scope.emitter.emit("COMPOSE")

    return point


def each_number(scope: Scope, first: int, last: int, body: Callable[[Emit], None]) -> None:
    """Emit a loop over whole numbers, of which there is one at least."""
    emit, top = scope.emitter.emit, Label()
    name = scope.hide("point", Type.INT)
    push(scope, Type.INT, first)
    emit("STORE", name)
    scope.emitter.place(top)
    body(lambda: emit("LOAD", name))
    emit("LOAD", name)
    push(scope, Type.INT, 1)
    emit("ADD.I")
    emit("STORE", name)
    emit("LOAD", name)
    push(scope, Type.INT, last)
    emit("LE.I")
    scope.emitter.jump("JT", top)


def curve_through(scope: Scope, along: Along) -> tuple[str, str]:
    """Emit code that puts on the stack where a list lies; return the instruction of the curve through it."""
    evaluate(scope, along.before, Type.POSE)
    evaluate(scope, along.behind, Type.POSE)
    scope.used.lists.setdefault(along.list)
    return "MOVE.SPL.L", along.list


def _held(scope: Scope, pose: sir.Expression) -> Emit | None:
    """Compute a pose here and return code that puts it on the stack; None for the identity."""
    if isinstance(pose, sir.Constant):
        if pose.value == _NOWHERE:
            return None
        return lambda: evaluate(scope, pose, Type.POSE)
    name = scope.hide("place", Type.POSE)
    evaluate(scope, pose, Type.POSE)
    scope.emitter.emit("STORE", name)
    return lambda: scope.emitter.emit("LOAD", name)
