"""Locations: tuples with their orientations, and the operators that move and re-base them."""

from collections.abc import Callable
from functools import partial

from ropsim.icr import MAX_EXTERNAL
from ropsim.language.check.doubts import metres, numerals, radians
from ropsim.language.check.expressions import components, convert, frames, postures, turns, values
from ropsim.language.check.scope import fold, units
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import ANGLE, JOINTS, LENGTH, POSE, Type, Value, article, known, valued
from ropsim.language.check.scope.world import Listed
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax.lexer import LARGEST
from ropsim.program import CommandPose, Constant, Expression, ValueType
from ropsim.spatial import PoseTuple, quaternion

_DOWN = Constant(components.DOWN, ValueType.ORI)


def location(body: Body, node: nodes.Tuple) -> Value:
    """Return the location of a tuple, read in the frame in force and given in the work frame.

    In a frame that moves it is given in that one.

    Three numbers are a position with the tool pointing down, or with the orientation after `;`. Five are
    x, y, z, pitch, roll: R = Rz(atan2(y, x))·Ry(pitch)·Rx(roll) in the base frame, the approach direction
    along its +X. Six are x, y, z, roll, pitch, yaw with R = Rz(yaw)·Ry(pitch)·Rx(roll).

    Raises:
        RejectedError: the tuple is not a location.
    """
    X_CT = _pose(body, node, _DOWN, partial(components.frame_in_base, body))
    metres.check_place(body, node)
    X_KC = frames.read(body)
    X_KT = X_CT if X_KC == fold.IDENTITY else fold.compose(fold.pose(X_KC), X_CT)
    if node.posture is not None:
        X_KT = fold.in_posture(X_KT, postures.request(body, node.posture))
    placed = fold.in_frame(X_KT, body.in_force.moving) if body.in_force.moving else X_KT
    return valued(placed, POSE, is_bare=False, X_KF=X_KC)


def transform(body: Body, node: nodes.Node, X_BC: PoseTuple = fold.IDENTITY) -> Expression:
    """Return the pose of a tuple whose orientation is upright unless it says otherwise.

    Args:
        body: where it stands.
        node: the tuple.
        X_BC: its frame, where that is one of the room: pitch and roll count in the base frame. A step and a
            tool are given in the tool and in the mechanical interface, where they count from its axes.

    Raises:
        RejectedError: the node is not a pose tuple.
    """
    if not isinstance(node, nodes.Tuple):
        return values.expect(body, node, POSE, "the pose")
    if node.posture is not None:
        hint = "locations have them: leave them out here"
        message = "a step, a frame and a tool have no posture, no turns and no free orientation"
        body.fail(kinds.WRONG_TYPE, node.posture, message, hint)
    return _pose(body, node, components.UPRIGHT, lambda: X_BC)


def shift(body: Body, node: nodes.Node, what: str) -> Expression:
    """Return the VEC of a tuple of three lengths.

    Raises:
        RejectedError: the node is not a pose tuple.
    """
    if not isinstance(node, nodes.Tuple) or len(node.items) != 3 or node.turns or node.posture:
        body.fail(kinds.WRONG_TYPE, node, f"{what} is three lengths in parentheses", "write `(dx, dy, dz)`")
    return _position(body, node)


def moved(body: Body, value: Value, node: nodes.Binary) -> Value:
    """Return `A above d`, `A offset (dx, dy, dz)` or `A rel (dx, dy, dz; …)`.

    `above` goes back along the approach direction, tool Z, by d; `offset` shifts along the axes of the frame
    in which A was given, which a variable or parameter keeps; `rel` composes in the tool frame at A.
    """
    base = convert.to(body, value, POSE, node.left, f"the left side of `{node.op}`")
    if node.op == "above":
        distance = _length(body, node.right, "the distance of `above`")
        metres.check_length(body, "above", node.right, node.right)
        back = fold.vector(fold.real(0.0), fold.real(0.0), fold.unary("neg", distance, ValueType.REAL))
        return Value(fold.compose(base, fold.make_pose(back, components.UPRIGHT)), POSE, X_KF=value.X_KF)
    if node.op == "rel":
        return Value(fold.compose(base, _step(body, node.right)), POSE, X_KF=value.X_KF)
    way = shift(body, node.right, "the shift of `offset`")
    if value.X_KF is None and body.world.has_axes:
        return Value(fold.offset(base, way), POSE)
    X_KF = fold.IDENTITY if value.X_KF is None else value.X_KF
    rotation = fold.pose((0.0, 0.0, 0.0, *X_KF[3:]))
    turned = components.position_of(fold.compose(rotation, fold.make_pose(way, components.UPRIGHT)))
    return Value(fold.compose(fold.make_pose(turned, components.UPRIGHT), base), POSE, X_KF=value.X_KF)


def _step(body: Body, node: nodes.Node) -> Expression:
    """Return the pose on the right of `rel`: numbers alone, independent of their frame.

    Raises:
        RejectedError: it is no pose, or is written with values of external axes.
    """
    if isinstance(node, nodes.External):
        hint = "write `external (…)` behind the whole: `A rel (…) external (…)`"
        body.fail(kinds.WRONG_TYPE, node, "the step of `rel` has no values of external axes", hint)
    if isinstance(node, nodes.Free):
        hint = "write `free` behind the whole: `A rel (…) free`"
        body.fail(kinds.WRONG_TYPE, node, "the step of `rel` has no free orientation", hint)
    step = transform(body, node)
    if body.world.environment.moving:
        return fold.in_frame(step, "")
    return _without_axes(body, step)


def here(body: Body) -> Expression:
    """Return the pose commanded last; it is shifted along the frame in force, or its own frame that moves."""
    X_KC = frames.read(body)
    is_turned = X_KC[3:] != quaternion.IDENTITY
    return fold.in_axes(CommandPose(), X_KC) if is_turned else CommandPose()


def _without_axes(body: Body, location: Expression) -> Expression:
    """Return a location with the axes of the work frame, including variables in it."""
    is_known = isinstance(fold.numbers_of(location), Constant)
    return fold.in_axes(location, fold.IDENTITY) if body.world.has_axes and not is_known else location


def kept(value: Value, expression: Expression) -> Expression:
    """Return a value in stored form (kept, passed or returned): a location with the axes of its frame."""
    is_turned = value.X_KF is not None and value.X_KF[3:] != quaternion.IDENTITY
    return fold.in_axes(expression, value.X_KF) if is_turned and value.X_KF is not None else expression


def rebased(body: Body, node: nodes.Rebase) -> Value:
    """Return `A in F`: a location written there as F in force would read it, else the numbers of A read in F.

    The numbers of A are expressed in the frame in force.
    """
    X_KF, moving = body.frame(node.frame)
    if _is_written(body, node.operand):
        with frames.in_frame(body, X_KF, moving):
            return values.check(body, node.operand)
    value = values.check(body, node.operand)
    base = convert.to(body, value, POSE, node.operand, "the left side of `in`")
    if body.world.environment.moving:
        numbers = fold.without_frame(components.numbers_in_frame(body, base))
        return Value(fold.in_frame(fold.compose(fold.pose(X_KF), numbers), moving), POSE, X_KF=X_KF)
    change = fold.compose(fold.pose(X_KF), fold.pose(quaternion.invert(frames.read(body))))
    return Value(_without_axes(body, fold.compose(change, base)), POSE, X_KF=X_KF)


def _is_written(body: Body, node: nodes.Node) -> bool:
    """Return whether an expression is a location in numbers, moved by `above`, `offset` and `rel` or not.

    The points of a list are numbers, too.
    """
    while not isinstance(node, nodes.Tuple):
        match node:
            case nodes.Binary(op="above" | "offset" | "rel", left=inner):
                node = inner
            case nodes.External(operand=inner) | nodes.Free(operand=inner):
                node = inner
            case nodes.Name(text=name) | nodes.Index(operand=nodes.Name(text=name)):
                return isinstance(body.find(name), Listed)
            case _:
                return False
    return True


def with_external(body: Body, value: Value, node: nodes.External) -> Value:
    """Return `A external (e1, …)`: A with these values of external axes, a bare one in the unit of its axis.

    Raises:
        RejectedError: A is no location, or a value does not fit.
    """
    kind = known(value.type)
    if isinstance(kind, Type) and kind != POSE:
        hint = "`joints(…)` has their values behind those of the arm"
        if kind != JOINTS:
            hint = "write `external (…)` right behind the location, before `speed` and other modifiers"
        message = f"`external` needs a location on its left, found {article(kind)}"
        body.fail(kinds.WRONG_TYPE, node.operand, message, hint)
    if len(node.values) > MAX_EXTERNAL:
        message = f"a location has up to {MAX_EXTERNAL} values of external axes, found {len(node.values)}"
        body.fail(kinds.WRONG_TYPE, node, message)
    base = convert.to(body, value, POSE, node.operand, "the left side of `external`")
    axes = body.world.environment.external
    numbers = []
    for k, item in enumerate(node.values):
        number = values.check(body, item)
        is_length = axes[k] == "length" if k < len(axes) else known(number.type) == LENGTH
        wanted = LENGTH if is_length else ANGLE
        numbers.append(convert.to(body, number, wanted, item, f"external axis E{k + 1}"))
    return Value(fold.external(base, tuple(numbers)), POSE, X_KF=value.X_KF)


def with_free_orientation(body: Body, value: Value, node: nodes.Free) -> Value:
    """Return `A free`: A of which the position counts.

    Raises:
        RejectedError: A is no location.
    """
    kind = known(value.type)
    if isinstance(kind, Type) and kind != POSE:
        hint = "write `free` right behind the location, before `speed` and other modifiers"
        if kind == JOINTS:
            hint = "joint coordinates leave nothing free: leave the word out"
        message = f"`free` needs a location on its left, found {article(kind)}"
        body.fail(kinds.WRONG_TYPE, node.operand, message, hint)
    base = convert.to(body, value, POSE, node.operand, "the left side of `free`")
    return Value(fold.with_free_orientation(base), POSE, X_KF=value.X_KF)


def _pose(body: Body, node: nodes.Tuple, default: Expression, base: Callable[[], PoseTuple]) -> Expression:
    """Return the numbers of a tuple; `base` returns X_BC of the frame in which they are given."""
    for item in node.items:
        if item.name is not None:
            body.fail(
                kinds.WRONG_TYPE, item.name, "the numbers of a location have no names", "write `(x, y, z)`"
            )
    count = len(node.items)
    if count not in (3, 5, 6):
        body.fail(
            kinds.WRONG_TYPE, node, f"a location has 3, 5 or 6 numbers, found {count}", "write `(x, y, z)`"
        )
    if node.turns and count != 3:
        body.fail(
            kinds.WRONG_TYPE,
            node,
            f"{count} numbers already give the orientation",
            "write three numbers before `;`",
        )
    position = _position(body, node)
    if count > 3:
        radians.check_angles(body, node)
    if count == 5:
        return components.polar(
            base(), position, _angle(body, node, 3, "pitch"), _angle(body, node, 4, "roll"), None
        )
    if count == 6:
        roll, pitch, yaw = (_angle(body, node, k, w) for k, w in ((3, "roll"), (4, "pitch"), (5, "yaw")))
        return fold.make_pose(position, fold.zyx(yaw, pitch, roll))
    if not node.turns:
        return fold.make_pose(position, default)
    return turns.oriented(body, position, node.turns, base)


def _position(body: Body, node: nodes.Tuple) -> Expression:
    items = node.items
    numbers = [numerals.fitting_real(body, item.value, units.LENGTH) for item in items[:3]]
    known = tuple(number for number in numbers if number is not None and abs(number) <= LARGEST)
    if len(known) == 3:
        return fold.constant(known, ValueType.VEC)
    x = _length(body, items[0].value, "`x` of a location")
    y = _length(body, items[1].value, "`y` of a location")
    z = _length(body, items[2].value, "`z` of a location")
    return fold.vector(x, y, z)


def _length(body: Body, node: nodes.Node, what: str) -> Expression:
    """Return a length of a location; poses composed of these constants are always finite.

    Raises:
        RejectedError: it is none, or too large to mean anything.
    """
    expression = values.expect(body, node, LENGTH, what)
    number = fold.number_of(expression)
    if number is not None and abs(number) > LARGEST:
        message = f"{what} is {numerals.quoted(body, node, number, 'm')}, at most {LARGEST:g} m is allowed"
        body.fail(kinds.OUT_OF_RANGE, node, message, "check the numbers and their units")
    return expression


def _angle(body: Body, node: nodes.Tuple, index: int, word: str) -> Expression:
    return values.expect(body, node.items[index].value, ANGLE, f"`{word}` of a location")
