"""Branches and loops -> labels and jumps."""

import math

from ropsim.icr import TRAP_NOT_WHOLE, Type
from ropsim.program import expressions as sir
from ropsim.program import statements as st
from ropsim.program.diagnostics import unsound
from ropsim.program.emitter import Label
from ropsim.program.lowering.expressions import evaluate, push, static_type
from ropsim.program.scope import Loop, Scope

PASS_TOLERANCE = 1e-9
"""Share of a step by which the last value of a REAL loop may be missed through rounding."""


def lower_if(scope: Scope, statement: st.If) -> None:
    """Emit the branches in order; the first one whose condition holds is run."""
    end = Label()
    for number, (condition, block) in enumerate(statement.branches):
        other = Label()
        if number < len(statement.places):
            scope.emitter.line = statement.places[number].line
        evaluate(scope, condition, Type.BOOL)
        scope.emitter.jump("JF", other)
        scope.lower_block(scope, block)
        scope.emitter.jump("JMP", end)
        scope.emitter.place(other)
    scope.lower_block(scope, statement.otherwise)
    scope.emitter.place(end)


def lower_while(scope: Scope, statement: st.While) -> None:
    """Emit test, body, jump back."""
    loop = Loop(Label(), Label(), scope.depth)
    scope.emitter.place(loop.again)
    evaluate(scope, statement.condition, Type.BOOL)
    scope.emitter.jump("JF", loop.leave)
    _body(scope, statement.body, loop)
    scope.emitter.line = scope.line(statement.span)
    scope.emitter.jump("JMP", loop.again)
    scope.emitter.place(loop.leave)


def lower_repeat(scope: Scope, statement: st.Repeat) -> None:
    """Emit a loop that counts down and is left where `until` holds after a pass.

    Whether there is a first pass is tested only if the count is not constant: variables assigned in the body
    of `repeat 6` have a value behind it, and the verifier can see that.
    """
    emitter = scope.emitter
    top, loop = Label(), Loop(Label(), Label(), scope.depth)
    left = _count(scope, statement.count) if statement.count is not None else ""
    runs = statement.count is None or _number(statement.count, 0) >= 1
    if not runs:
        _more(scope, left)
        emitter.jump("JF", loop.leave)
    emitter.place(top)
    _body(scope, statement.body, loop)
    emitter.line = scope.line(statement.place or statement.span)
    emitter.place(loop.again)
    if statement.until is not None:
        evaluate(scope, statement.until, Type.BOOL)
        emitter.jump("JT", loop.leave)
    if left:
        emitter.emit("LOAD", left)
        push(scope, Type.INT, 1)
        emitter.emit("SUB.I")
        emitter.emit("STORE", left)
        _more(scope, left)
        emitter.jump("JT", top)
    else:
        emitter.jump("JMP", top)
    emitter.place(loop.leave)


def _more(scope: Scope, left: str) -> None:
    """Emit the question whether passes are left."""
    scope.emitter.emit("LOAD", left)
    push(scope, Type.INT, 0)
    scope.emitter.emit("GT.I")


def lower_for(scope: Scope, statement: st.For) -> None:
    """Emit a loop over values; assignments of the body to the variable do not change the number of passes.

    Whether there is a first pass is tested only if the bounds are not constant. A REAL variable is `first +
    pass·step`, not a running sum, so that rounding does not pile up.
    """
    kind = scope.type_of(statement.variable)
    if kind not in {Type.INT, Type.REAL}:
        raise unsound(f"loop variable `{statement.variable}` is {kind.value}", statement.span)
    step = _constant_step(statement)
    emitter, suffix = scope.emitter, ".I" if kind is Type.INT else ".R"
    top, loop = Label(), Loop(Label(), Label(), scope.depth)
    last = scope.hide("last", kind)
    evaluate(scope, statement.first, kind)
    value = _IntSteps(scope, int(step)) if kind is Type.INT else _RealSteps(scope, float(step))
    evaluate(scope, statement.last, kind)
    if kind is Type.REAL:
        push(scope, Type.REAL, step * PASS_TOLERANCE)
        emitter.emit("ADD.R")
    emitter.emit("STORE", last)

    def more() -> None:
        value.load()
        emitter.emit("LOAD", last)
        emitter.emit(("LE" if step > 0 else "GE") + suffix)

    way = (_number(statement.last, math.nan) - _number(statement.first, math.nan)) * step
    if not way >= 0:  # unknown bounds lead to NaN
        more()
        emitter.jump("JF", loop.leave)
    emitter.place(top)
    value.load()
    emitter.emit("STORE", statement.variable)
    _body(scope, statement.body, loop)
    emitter.line = statement.span.line
    emitter.place(loop.again)
    value.advance()
    more()
    emitter.jump("JT", top)
    emitter.place(loop.leave)


def leave_loop(scope: Scope, statement: st.Break | st.Continue) -> None:
    """Emit break or continue: the modal states saved inside the loop are restored first."""
    if not scope.loops:
        raise unsound("`break` or `continue` outside a loop", statement.span)
    loop = scope.loops[-1]
    for _ in range(scope.depth - loop.depth):
        scope.emitter.emit("MODAL.RESTORE")
    scope.emitter.jump("JMP", loop.leave if isinstance(statement, st.Break) else loop.again)


def _body(scope: Scope, body: st.Block, loop: Loop) -> None:
    scope.loops.append(loop)
    scope.lower_block(scope, body)
    scope.loops.pop()


def _count(scope: Scope, count: sir.Expression) -> str:
    """Emit the evaluation of a repeat count, return the variable that holds it; 6.0 is right, 2.5 traps."""
    left = scope.hide("left", Type.INT)
    if static_type(scope, count) is Type.REAL:
        whole = Label()
        exact = scope.hide("count", Type.REAL)
        evaluate(scope, count, Type.REAL)
        scope.emitter.emit("STORE", exact)
        scope.emitter.emit("LOAD", exact)
        scope.emitter.emit("ROUND")
        scope.emitter.emit("STORE", left)
        scope.emitter.emit("LOAD", left)
        scope.emitter.emit("I2R")
        scope.emitter.emit("LOAD", exact)
        scope.emitter.emit("EQ.R")
        scope.emitter.jump("JT", whole)
        scope.emitter.emit("TRAP", TRAP_NOT_WHOLE)
        scope.emitter.place(whole)
    else:
        evaluate(scope, count, Type.INT)
        scope.emitter.emit("STORE", left)
    return left


def _constant_step(statement: st.For) -> int | float:
    step = _number(statement.step, 0)
    if step == 0:
        raise unsound("the step of a loop must be a constant other than 0", statement.span)
    return step


def _number(expression: sir.Expression, otherwise: float) -> int | float:
    """Return the value of a constant number, `otherwise` for anything else."""
    sign = 1
    while isinstance(expression, sir.Unary) and expression.op in {"neg", "to_real"}:
        sign = -sign if expression.op == "neg" else sign
        expression = expression.operand
    value = expression.value if isinstance(expression, sir.Constant) else None
    if isinstance(value, bool) or not isinstance(value, int | float):
        return otherwise
    return sign * value


class _IntSteps:
    """The value of an INT loop, kept in a separate variable; starts with the value on the stack."""

    def __init__(self, scope: Scope, step: int) -> None:
        self.scope = scope
        self.step = step
        self.name = scope.hide("next", Type.INT)
        scope.emitter.emit("STORE", self.name)

    def load(self) -> None:
        """Emit code that pushes the value of this pass."""
        self.scope.emitter.emit("LOAD", self.name)

    def advance(self) -> None:
        """Emit code that goes on to the next pass."""
        self.load()
        push(self.scope, Type.INT, self.step)
        self.scope.emitter.emit("ADD.I")
        self.scope.emitter.emit("STORE", self.name)


class _RealSteps:
    """The value of a REAL loop, computed from the number of the pass; starts with the value on the stack."""

    def __init__(self, scope: Scope, step: float) -> None:
        self.scope = scope
        self.step = step
        self.first = scope.hide("first", Type.REAL)
        scope.emitter.emit("STORE", self.first)
        push(scope, Type.INT, 0)
        self.number = _IntSteps(scope, 1)

    def load(self) -> None:
        """Emit code that pushes the value of this pass."""
        self.scope.emitter.emit("LOAD", self.first)
        self.number.load()
        self.scope.emitter.emit("I2R")
        push(self.scope, Type.REAL, self.step)
        self.scope.emitter.emit("MUL.R")
        self.scope.emitter.emit("ADD.R")

    def advance(self) -> None:
        """Emit code that goes on to the next pass."""
        self.number.advance()
