"""Moves, with the points on their way -> ICR."""

from collections.abc import Callable
from dataclasses import replace

from ropsim.flow import MotionKind, Side
from ropsim.icr import Type
from ropsim.program import expressions as sir
from ropsim.program.diagnostics import unsound
from ropsim.program.lowering.along import curve_through, each_number, placed_elements
from ropsim.program.lowering.expressions import evaluate, push, static_type
from ropsim.program.lowering.robot import lower_settings, lower_timeout
from ropsim.program.move import Along, Guard, Move, Tracking, Trigger
from ropsim.program.scope import Scope

_Prefix = tuple[str, str, str]
"""Mnemonic and operands of an instruction that belongs to the next move."""

_SIDES = {Side.BEFORE_END: "before", Side.AFTER_START: "after"}
_SINGLE = {MotionKind.PTP: "MOVE.PTP", MotionKind.LIN: "MOVE.LIN"}


def lower_move(scope: Scope, move: Move) -> None:
    """Emit a move; its own settings are taken back after it.

    All points and places of triggers are evaluated before the first motion: `here` is where the arm is then.
    """
    single = move.kind in _SINGLE
    if move.kind == MotionKind.PTP and move.tracking is not None:
        raise unsound("a motion in joint space is not corrected by a sensor", move.span)
    if single and (move.via or move.along is not None):
        if move.guard is not None:
            raise unsound("a motion through points has no condition that ends it", move.span)
        if move.tracking is not None:
            raise unsound("a motion through points is not corrected by a sensor", move.span)
        if move.along is None:
            _through(scope, move)
        else:
            _along(scope, move, move.along)
        return
    saves = not move.settings.is_empty
    if saves:
        scope.emitter.emit("MODAL.SAVE")
        lower_settings(scope, move.settings)
    if single:
        _evaluate(scope, move, move.target)
        _prefix(scope, _operands(scope, move.triggers, move.guard, move.tracking))
        _single(scope, move, move.target)
    else:
        _curved(scope, move)
    _store(scope, move)
    if saves:
        scope.emitter.emit("MODAL.RESTORE")


def _store(scope: Scope, move: Move) -> None:
    """Emit code that stores the pose of the arm after a move; it waits until the arm is there."""
    if move.store:
        scope.emitter.emit("ATTAINED")
        scope.emitter.emit("STORE", move.store)


def _through(scope: Scope, move: Move) -> None:
    """Emit a move to each point on the way, which passes it by, and one to the target.

    A zone of the move's own is that of all points; a fine stop is one at the target only. Triggers after the
    start belong to the first move, triggers before the end to the last one.
    """
    emit, settings = scope.emitter.emit, move.settings
    fine = isinstance(settings.zone, sir.Constant) and settings.zone.value == 0
    emit("MODAL.SAVE")
    lower_settings(scope, replace(settings, zone=None) if fine else settings)
    first = tuple(one for one in move.triggers if one.side is Side.AFTER_START)
    last = tuple(one for one in move.triggers if one.side is Side.BEFORE_END)
    _evaluate(scope, move, move.target)
    at_end = _operands(scope, last)
    for point in reversed(move.via):
        _evaluate(scope, move, point)
    at_start = _operands(scope, first)
    emit("MODAL.SAVE")
    emit("ZONE.VIA")
    _prefix(scope, at_start)
    for point in move.via:
        _single(scope, move, point)
    emit("MODAL.RESTORE")
    if fine:
        emit("ZONE.FINE")
    _prefix(scope, at_end)
    _single(scope, move, move.target)
    _store(scope, move)
    emit("MODAL.RESTORE")


def _along(scope: Scope, move: Move, along: Along) -> None:
    """Emit a move to each point of a list, which passes it by, and one to the last; see `_through`."""
    emit, settings = scope.emitter.emit, move.settings
    fine = isinstance(settings.zone, sir.Constant) and settings.zone.value == 0
    emit("MODAL.SAVE")
    lower_settings(scope, replace(settings, zone=None) if fine else settings)
    point = placed_elements(scope, along)
    at_end = _operands(scope, tuple(one for one in move.triggers if one.side is Side.BEFORE_END))
    at_start = _operands(scope, tuple(one for one in move.triggers if one.side is Side.AFTER_START))

    def passed(number: Callable[[], None]) -> None:
        point(number)
        emit(_SINGLE[move.kind])

    if along.count > 1:
        emit("MODAL.SAVE")
        emit("ZONE.VIA")
        if at_start:
            _prefix(scope, at_start)
            passed(lambda: push(scope, Type.INT, 1))
        first = 2 if at_start else 1
        if first < along.count:
            each_number(scope, first, along.count - 1, passed)
        emit("MODAL.RESTORE")
    if fine:
        emit("ZONE.FINE")
    _prefix(scope, (*(at_start if along.count == 1 else ()), *at_end))
    passed(lambda: push(scope, Type.INT, along.count))
    _store(scope, move)
    emit("MODAL.RESTORE")


def _operands(
    scope: Scope,
    triggers: tuple[Trigger, ...],
    guard: Guard | None = None,
    tracking: Tracking | None = None,
) -> tuple[_Prefix, ...]:
    """Emit code that pushes the operands of triggers, guard and tracking, the first one on top.

    Returns:
        The instructions that take it from there.
    """
    if not triggers and guard is None and tracking is None:
        return ()
    found = []
    if tracking is not None:
        evaluate(scope, tracking.value, Type.REAL)
        evaluate(scope, tracking.gain, Type.REAL)
        found.append(("TRACK", tracking.direction.value, scope.channel(tracking.signal).name))
    if guard is not None:
        channel = scope.channel(guard.signal)
        evaluate(scope, guard.value, channel.type)
        lower_timeout(scope, guard.timeout)
        found.append(("GUARD", guard.comparison.value, channel.name))
    for one in reversed(triggers):
        channel = scope.channel(one.signal)
        evaluate(scope, one.value, channel.type)
        place, mnemonic = (one.distance, "TRIG.DIST") if one.time is None else (one.time, "TRIG.TIME")
        if place is None or (one.distance is not None and one.time is not None):
            raise unsound(f"the place of `{one.signal}` on a motion is a distance or a time")
        evaluate(scope, place, Type.REAL)
        found.append((mnemonic, _SIDES[one.side], channel.name))
    return tuple(reversed(found))


def _prefix(scope: Scope, prefixes: tuple[_Prefix, ...]) -> None:
    """Emit the prefix instructions of the next move."""
    for mnemonic, *operands in prefixes:
        scope.emitter.emit(mnemonic, *operands)


def _evaluate(scope: Scope, move: Move, point: sir.Expression) -> None:
    """Emit code that leaves a target on the stack; home is no value."""
    if static_type(scope, point) is Type.POSE:
        evaluate(scope, point, Type.POSE)
    elif move.kind != MotionKind.PTP:
        raise unsound(f"a path of the TCP ({move.kind}) needs a pose as target", move.span)
    elif not isinstance(point, sir.Home):
        evaluate(scope, point, Type.JOINTS)


def _single(scope: Scope, move: Move, point: sir.Expression) -> None:
    """Emit the motion to a target on the stack."""
    if isinstance(point, sir.Home):
        scope.emitter.emit("HOME")
    elif static_type(scope, point) is Type.POSE:
        scope.emitter.emit(_SINGLE[move.kind])
    else:
        scope.emitter.emit("MOVE.PTP.J")


def _curved(scope: Scope, move: Move) -> None:
    """Emit a path that leads through its points: an arc, a smooth curve."""
    mnemonic: str
    operands: list[str | int]
    if move.along is not None:
        mnemonic, *operands = curve_through(scope, move.along)
    else:
        mnemonic, *operands = _through_points(move)
        for point in (*move.via, move.target):
            _evaluate(scope, move, point)
    if move.angle is not None:
        evaluate(scope, move.angle, Type.REAL)
    _prefix(scope, _operands(scope, move.triggers, move.guard, move.tracking))
    scope.emitter.emit(mnemonic, *operands)


def _through_points(move: Move) -> tuple[str] | tuple[str, int]:
    """Return the instruction of a path that leads through its points; a new kind has its case here.

    Raises:
        LoweringError: no instruction makes a path of this kind, or through this number of points.
    """
    match move.kind:
        case MotionKind.CIRC if len(move.via) != 1:
            raise unsound(f"an arc leads through one point, not {len(move.via)}", move.span)
        case MotionKind.CIRC:
            return ("MOVE.CIRC" if move.angle is None else "MOVE.CIRC.A",)
        case MotionKind.SPLINE if move.angle is not None:
            raise unsound("a curve goes on no circle, so it has no angle", move.span)
        case MotionKind.SPLINE:
            return "MOVE.SPL", len(move.via) + 1
    raise unsound(f"no instruction makes a path of kind `{move.kind}`", move.span)
