"""Motions: the target, the points on the way, and modifiers of this motion only."""

from ropsim.core import maker
from ropsim.flow import MotionKind, PostureRequest, Side
from ropsim.icr import external_part
from ropsim.language.check.doubts import facing, numerals, radians
from ropsim.language.check.expressions import convert, frames, poses, values
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import (
    ANGLE,
    JOINTS,
    LENGTH,
    POSE,
    TIME,
    AnyType,
    Type,
    Unknown,
    Value,
    article,
    bind,
    known,
)
from ropsim.language.check.statements import actions, along, assignments, guards, settings, trackings
from ropsim.language.findings import points as point_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.nodes import Literal, Name, Node
from ropsim.program import (
    Along,
    Assign,
    Block,
    Expression,
    Home,
    MakeExternal,
    Move,
    Trigger,
    ValueType,
    Variable,
)

_KINDS = {
    "mov": MotionKind.PTP,
    "lin": MotionKind.LIN,
    "circ": MotionKind.CIRC,
    "spline": MotionKind.SPLINE,
}
_move = maker(Move)
_CURVED = ("circ", "spline")
_OWN = (
    ("values of external axes", "they are those of the whole path"),
    ("posture, turns and free orientation", "they are those of the whole path"),
)


def motion(body: Body, node: syntax.Motion) -> Block:
    """Return a move."""
    listed: Along | None = None
    if node.along is not None:
        listed, target = along.along(body, node, node.along)
    else:
        target = _point(body, node, node.target, f"the target of `{node.word}`")
    via: tuple[Expression, ...] = ()
    if node.via:
        via = tuple(_point(body, node, one, f"a via point of `{node.word}`") for one in node.via)
    if node.word in _CURVED:
        for point, expression in zip(node.via, via, strict=True):
            _refuse_own(body, node, point, expression, target)
    chosen = settings.of_motion(body, node)
    if node.word not in _CURVED and (node.via or (listed and listed.count > 1)):
        _check_zone(body, node, chosen.zone)
    triggers = tuple(_trigger(body, one) for one in node.triggers) if node.triggers else ()
    angle = _angle(body, node)
    ends, corrected = guards.guard(body, node), trackings.tracking(body, node)
    store = _store(body, node.store) if node.store is not None else ""
    span = body.statement_span
    move = _move(
        _KINDS[node.word], target, chosen, span, via, angle, triggers, ends, corrected, store, listed
    )
    if not store:
        return (move,)
    attained = Variable(store, POSE.value)
    seen = poses.kept(Value(attained, POSE, X_KF=frames.read(body)), attained)
    return (move,) if seen is attained else (move, Assign(store, seen, span))


def _check_zone(body: Body, node: syntax.Motion, zone: Expression | None) -> None:
    """Report `blend 0` on a way through points, which does not stop at them."""
    given = next((one for one in node.modifiers if one.word == "blend"), None) if node.modifiers else None
    if given is not None and zone is not None and fold.number_of(zone) == 0.0:
        message = (
            "with `blend 0` the arm stops at the last point only; it passes the others by with the zone in "
        )
        message += "force, else with that of the cell for via points"
        hint = "give a zone, such as `blend 1 mm`; to stop at each point give each a motion of its own"
        if node.along is not None:
            hint = "give a zone, such as `blend 1 mm`; to stop at each point write `for each p in "
            hint += f"{node.along.text}` and `{node.word} p`"
        body.warn(point_kinds.NO_ZONE_ON_THE_WAY, given, message, hint)


def _store(body: Body, name: Name) -> str:
    """Return the variable that keeps the pose of the arm.

    Raises:
        RejectedError: it cannot be assigned, or keeps something else.
    """
    variable = assignments.target(body, name, POSE)
    kind = known(variable.type)
    if isinstance(kind, Type) and kind != POSE:
        message = f"`store` keeps a location, `{name.text}` is {article(kind)}"
        body.fail(kinds.WRONG_TYPE, name, message, "use a variable of its own")
    if isinstance(kind, Unknown):
        bind(kind, POSE)
    return variable.name


def _trigger(body: Body, node: syntax.Trigger) -> Trigger:
    """Return an output that is set on the way; a bare number is a distance."""
    value = values.check(body, node.place)
    is_time = known(value.type) == TIME
    place = convert.to(body, value, TIME if is_time else LENGTH, node.place, "the place of `at`")
    number = fold.number_of(place)
    if number is not None and number < 0.0:
        found = numerals.quoted(body, node.place, number, "s" if is_time else "m")
        message = f"the place of `at` must not be negative, found {found}"
        hint = "`after start` counts from the start on, `before end` from the end back"
        body.fail(kinds.OUT_OF_RANGE, node.place, message, hint)
    output = actions.output(body, node.action)
    side = Side.AFTER_START if node.side == "after" else Side.BEFORE_END
    distance, time = (None, place) if is_time else (place, None)
    return Trigger(output.signal, output.value, side, distance, time)


def _point(body: Body, node: syntax.Motion, place: Node, what: str) -> Expression:
    if isinstance(place, Literal) and place.word == "home":
        value = Value(Home(), JOINTS)
    else:
        value = values.check(body, place)
    facing.check_target(body, place)
    kind = known(value.type)
    _refuse_coordinate(body, place, kind)
    wanted = JOINTS if kind == JOINTS and node.word == "mov" else POSE
    return convert.to(body, value, wanted, place, what)


def _refuse_coordinate(body: Body, place: Node, kind: AnyType) -> None:
    """Report a plain coordinate as target at a station that has no arm.

    Raises:
        RejectedError: it is one.
    """
    axes, external = body.world.environment.axes, body.world.environment.external
    armless = bool(axes) and len(external) == len(axes)
    if armless and isinstance(kind, Type) and kind.value in {ValueType.INT, ValueType.REAL}:
        body.fail(
            kinds.WRONG_TYPE,
            place,
            f"the target of a station without an arm must be joint coordinates, found {article(kind)}",
            "write `mov joints(…)` with the coordinate of its axis: `mov joints(900)`",
        )


def _refuse_own(body: Body, node: syntax.Motion, place: Node, point: Expression, target: Expression) -> None:
    """Report a via point of an arc or curve with external values or a posture different from the target's.

    Raises:
        RejectedError: it is written with such.
    """
    at_end = _owned(target)
    for (what, hint), found, wanted in zip(_OWN, _owned(point), at_end, strict=True):
        if found and found != wanted:
            message = f"a via point of `{node.word}` has no {what} of its own"
            body.fail(kinds.WRONG_TYPE, place, message, f"give them to the target: {hint}")


def _owned(location: Expression) -> tuple[tuple[Expression | float, ...], PostureRequest | None]:
    """Return the values of external axes and the posture that a location is seen to have."""
    inner, posture, _ = fold.opened(location)
    if isinstance(inner, MakeExternal):
        return inner.values, posture
    value = fold.location_of(inner)
    return external_part(value) if value is not None else (), posture


def _angle(body: Body, node: syntax.Motion) -> Expression | None:
    """Return the angle of an arc.

    Raises:
        RejectedError: it is given twice, to another motion, or is not greater than zero.
    """
    given = [one for one in node.modifiers if one.word == "angle"] if node.modifiers else []
    if not given:
        return None
    if len(given) > 1:
        body.fail(kinds.ARGUMENTS, given[1], "`angle` is given twice")
    (setting,) = given
    assert setting.value is not None
    radians.check_arc(body, setting)
    if node.word != "circ":
        hint = "leave it out, or write `circ via point to target angle …`"
        body.fail(kinds.WRONG_TYPE, setting, f"`{node.word}` has no `angle`, only arcs have one", hint)
    angle = values.expect(body, setting.value, ANGLE, "the value of `angle`")
    number = fold.number_of(angle)
    if number is not None and number <= 0.0:
        found = numerals.quoted(body, setting.value, number, "rad")
        message = f"`angle` must be greater than zero, found {found}"
        body.fail(kinds.OUT_OF_RANGE, setting, message, "for the other way round choose another via point")
    return angle
