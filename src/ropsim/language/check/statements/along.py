"""Motions along a list of points: where the list lies, and which of its points are one."""

from itertools import pairwise
from math import dist

from ropsim.core import plural
from ropsim.language.check.expressions import convert, values
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body, RejectedError
from ropsim.language.check.scope.types import POSE
from ropsim.language.check.scope.world import Listed, Poison
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import points as point_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.nodes import Name
from ropsim.program import (
    IMPOSSIBLE_PATH,
    SAME_PLACE,
    Along,
    Binary,
    Element,
    Expression,
    InAxes,
    InFrame,
    InPosture,
    MakeExternal,
)

_Sides = tuple[Expression, Expression]


def listed(body: Body, name: Name) -> Listed:
    """Return the list of a name.

    Raises:
        RejectedError: there is none.
    """
    symbol = body.find(name.text)
    if isinstance(symbol, Poison):
        raise RejectedError
    if not isinstance(symbol, Listed):
        lists = [one for one, found in body.world.symbols.items() if isinstance(found, Listed)]
        body.unknown(name_kinds.UNKNOWN_LIST, name, "list of points", lists)
    return body.with_points(symbol, name)


def along(body: Body, node: syntax.Motion, name: Name) -> tuple[Along, Expression]:
    """Return the list of a motion with the place where it lies, and its last point there.

    Raises:
        RejectedError: there is no such list, or its place is not the same for all points.
    """
    found = listed(body, name)
    count = len(found.table.points)
    if node.word == "spline" and count < 2:
        message = f"a curve leads through two points or more, `{name.text}` has {count}"
        body.fail(kinds.OUT_OF_RANGE, name, message, "write `lin` to reach one point")
    _check_coincident(body, node, name, found)
    body.each = found
    try:
        value = values.check(body, node.target)
    finally:
        body.each = None
    target = convert.to(body, value, POSE, node.target, f"the points of `{node.word} along`")
    sides = _sides(target)
    if sides is None:
        message = "the points of a list are moved together, by the same for all"
        hint = "write `in`, `above`, `offset` or `rel` behind the list, or `for each`"
        body.fail(kinds.WRONG_TYPE, node.target, message, hint)
    before, behind = sides
    last = fold.compose(fold.compose(before, fold.pose(found.table.points[-1])), behind)
    return Along(found.name, count, before, behind), last


def _check_coincident(body: Body, node: syntax.Motion, name: Name, found: Listed) -> None:
    """Report points that follow each other at one place: no curve leads on there, and a chain stops.

    Raises:
        RejectedError: the motion is a curve.
    """
    table, is_curve = found.table, node.word == "spline"
    numbers = [
        number
        for number, (one, other) in enumerate(pairwise(table.points), 1)
        if dist(one[:3], other[:3]) <= SAME_PLACE and (is_curve or one[3:] == other[3:])
    ]
    if not numbers:
        return
    first = numbers[0]
    message = f"the points {first} and {first + 1} of `{found.name}` are at one place"
    if len(numbers) > 1:
        message += f", and so are {plural(len(numbers) - 1, 'further pair')}"
    hint = "leave one of them out of the list"
    if table.places:
        lines = table.places[first - 1 : first + 1]
        hint = f"leave one of them out: lines {lines[0]} and {lines[1]} of `{table.source}`"
    if is_curve:
        body.fail(IMPOSSIBLE_PATH, name, message, hint)
    body.warn(point_kinds.POINTS_AT_ONE_PLACE, name, message, hint)


def _sides(target: Expression) -> _Sides | None:
    """Return X_AB and X_CD of a point X_AB·X_BC·X_CD of a list; None where it is no such product."""
    nothing = fold.pose(fold.IDENTITY)
    match target:
        case Element():
            return nothing, nothing
        case Binary(op="compose" | "reframe", left=left, right=right):
            if (inner := _sides(left)) is not None:
                return inner[0], fold.compose(inner[1], right)
            if (inner := _sides(right)) is not None:
                return fold.compose(left, inner[0]), inner[1]
        case InFrame(operand=operand, frame=frame):
            if (inner := _sides(operand)) is not None:
                return fold.in_frame(inner[0], frame), inner[1]
        case InPosture(operand=operand, request=request):
            if (inner := _sides(operand)) is not None:
                return fold.in_posture(inner[0], request), inner[1]
        case MakeExternal(pose=pose, values=numbers):
            if (inner := _sides(pose)) is not None:
                return fold.external(inner[0], numbers), inner[1]
        case InAxes(operand=operand):
            return _sides(operand)
    return None
