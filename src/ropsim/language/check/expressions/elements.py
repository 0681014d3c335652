"""A point of a list as a location."""

from ropsim.language.check.expressions import frames
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import POSE, Value
from ropsim.language.check.scope.world import Listed
from ropsim.program import Element, Expression, ValueType, Variable

EACH = Variable("each", ValueType.INT)
"""Number of the point in hand of a motion along a list; it stands in no program."""


def element(body: Body, listed: Listed, index: Expression) -> Value:
    """Return a point of a list, read in the frame in force as if its numbers stood in this line."""
    number = fold.number_of(index)
    numbers = (
        Element(listed.name, index) if number is None else fold.pose(listed.table.points[int(number) - 1])
    )
    X_KC = frames.read(body)
    X_KT = numbers if X_KC == fold.IDENTITY else fold.compose(fold.pose(X_KC), numbers)
    moving = body.in_force.moving
    return Value(fold.in_frame(X_KT, moving) if moving else X_KT, POSE, X_KF=X_KC)
