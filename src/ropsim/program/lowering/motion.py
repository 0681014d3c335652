"""Moves, with the points on their way -> ICR."""

from dataclasses import replace

from ropsim.flow import MotionKind
from ropsim.icr import Type
from ropsim.program import expressions as sir
from ropsim.program import statements as st
from ropsim.program.diagnostics import unsound
from ropsim.program.lowering.expressions import evaluate, static_type
from ropsim.program.lowering.robot import lower_settings
from ropsim.program.scope import Scope

_SINGLE = (MotionKind.PTP, MotionKind.LIN)


def lower_move(scope: Scope, move: st.Move) -> None:
    """Emit a move; its own settings are taken back after it.

    All points are evaluated before the first motion, so `here` is where the arm is then.
    """
    single = move.kind in _SINGLE
    if single and move.via:
        _through(scope, move)
        return
    saves = not move.settings.is_empty
    if saves:
        scope.emitter.emit("MODAL.SAVE")
        lower_settings(scope, move.settings)
    if single:
        _evaluate(scope, move, move.target)
        _single(scope, move, move.target)
    else:
        _curved(scope, move)
    if saves:
        scope.emitter.emit("MODAL.RESTORE")


def _through(scope: Scope, move: st.Move) -> None:
    """Emit a move to each point on the way, which passes it by, and one to the target.

    A zone of the move's own is that of all points; a fine stop is one at the target only.
    """
    emit, settings = scope.emitter.emit, move.settings
    fine = isinstance(settings.zone, sir.Constant) and settings.zone.value == 0
    emit("MODAL.SAVE")
    lower_settings(scope, replace(settings, zone=None) if fine else settings)
    for point in (move.target, *reversed(move.via)):
        _evaluate(scope, move, point)
    emit("MODAL.SAVE")
    emit("ZONE.VIA")
    for point in move.via:
        _single(scope, move, point)
    emit("MODAL.RESTORE")
    if fine:
        emit("ZONE.FINE")
    _single(scope, move, move.target)
    emit("MODAL.RESTORE")


def _evaluate(scope: Scope, move: st.Move, point: sir.Expression) -> None:
    """Emit code that leaves a target on the stack; home is no value."""
    if static_type(scope, point) is Type.POSE:
        evaluate(scope, point, Type.POSE)
    elif move.kind != MotionKind.PTP:
        raise unsound(f"a path of the TCP ({move.kind}) needs a pose as target", move.span)
    elif not isinstance(point, sir.Home):
        evaluate(scope, point, Type.JOINTS)


def _single(scope: Scope, move: st.Move, point: sir.Expression) -> None:
    """Emit the motion to a target on the stack."""
    if isinstance(point, sir.Home):
        scope.emitter.emit("HOME")
    elif static_type(scope, point) is Type.POSE:
        scope.emitter.emit(f"MOVE.{move.kind}")
    else:
        scope.emitter.emit("MOVE.PTP.J")


def _curved(scope: Scope, move: st.Move) -> None:
    """Emit an arc or a smooth curve."""
    for point in (*move.via, move.target):
        _evaluate(scope, move, point)
    if move.kind == MotionKind.SPLINE:
        scope.emitter.emit("MOVE.SPL", len(move.via) + 1)
        return
    if len(move.via) != 1:
        raise unsound(f"an arc leads through one point, not {len(move.via)}", move.span)
    if move.angle is None:
        scope.emitter.emit("MOVE.CIRC")
    else:
        evaluate(scope, move.angle, Type.REAL)
        scope.emitter.emit("MOVE.CIRC.A")
