"""Grids of locations: the declaration `pattern`."""

from ropsim.icr import external_part, pose_part
from ropsim.language.check.doubts import facing
from ropsim.language.check.expressions import convert, poses, values
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import INT, POSE
from ropsim.language.check.scope.world import Pattern
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import statements as syntax
from ropsim.spatial import quaternion


def pattern(body: Body, node: syntax.PatternDeclaration) -> Pattern:
    """Return the pattern of a declaration.

    Raises:
        RejectedError: a count, the first location or a step is wrong.
    """
    counts = [1, 1, 1]
    for k, count in enumerate(node.counts):
        expression = values.expect(body, count, INT, "a count of a grid")
        number = fold.number_of(convert.constant(body, expression, count, "a count of a grid"))
        if number is None or not 1 <= number <= 10_000:
            body.fail(kinds.OUT_OF_RANGE, count, f"a count of a grid must be 1 to 10000, found {number:g}")
        counts[k] = int(number)
    first = values.expect(body, node.origin, POSE, "the first location")
    facing.check_target(body, node.origin)
    inner, posture, moving = fold.opened(first)
    numbers = convert.constant(body, inner, node.origin, "the first location")
    origin = fold.location_of(numbers)
    assert origin is not None
    checked = values.check(body, node.origin)
    X_KF = checked.X_KF if checked.X_KF is not None else body.in_force.X_KC
    steps = []
    for step in node.steps:
        vector = convert.constant(body, poses.shift(body, step, "a step of a grid"), step, "a step of a grid")
        assert isinstance(vector.value, tuple)
        x, y, z = vector.value
        turned = quaternion.rotate(X_KF[3:], (x, y, z))
        steps.append((_snapped(turned[0]), _snapped(turned[1]), _snapped(turned[2])))
    order = node.order.text if node.order is not None else "row"
    size = (counts[0], counts[1], counts[2])
    return Pattern(size, pose_part(origin), tuple(steps), order, external_part(origin), moving, posture, X_KF)


def _snapped(length: float) -> float:
    """Return 0 for the rounding error of a rotated zero; a step of less than 1 pm is none."""
    return 0.0 if abs(length) < 1e-12 else length
