"""The frame in force: locations read in it, its duration, and probable mistakes for another frame."""

from collections.abc import Iterator
from contextlib import contextmanager

from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.in_force import FrameInForce
from ropsim.language.check.scope.types import POSE, Value
from ropsim.language.check.scope.world import Listed
from ropsim.language.findings import types as kinds
from ropsim.language.syntax.nodes import Name
from ropsim.program import Element, Expression, ValueType, Variable
from ropsim.spatial import PoseTuple

EACH = Variable("each", ValueType.INT)
"""Number of the point in hand of a motion along a list; it stands in no program."""


def read(body: Body) -> PoseTuple:
    """Return X_KC for a location of the line in hand that is read in the frame in force."""
    body.in_force.is_read = True
    if body.ended:
        _warn_of_ended(body)
    return body.in_force.X_KC


def listed_point(body: Body, listed: Listed, index: Expression) -> Value:
    """Return a point of a list, read in the frame in force as if its numbers stood in this line."""
    number = fold.number_of(index)
    numbers = (
        Element(listed.name, index) if number is None else fold.pose(listed.table.points[int(number) - 1])
    )
    X_KC = read(body)
    X_KT = numbers if X_KC == fold.IDENTITY else fold.compose(fold.pose(X_KC), numbers)
    moving = body.in_force.moving
    return Value(fold.in_frame(X_KT, moving) if moving else X_KT, POSE, X_KF=X_KC)


def set_frame(body: Body, name: Name) -> None:
    """Read locations in another frame from here to the end of the block or body.

    Raises:
        RejectedError: the frame is unknown.
    """
    body.in_force = FrameInForce(*body.frame(name), (body.line, name))
    body.ended = ""


@contextmanager
def in_frame(body: Body, X_KC: PoseTuple, moving: str) -> Iterator[None]:
    """Read locations in another frame for a while, as `Body.frame` returns it."""
    before, ended = body.in_force, body.ended
    body.in_force, body.ended = FrameInForce(X_KC, moving), ""
    try:
        yield
    finally:
        body.in_force, body.ended = before, ended


@contextmanager
def in_block(body: Body) -> Iterator[None]:
    """End a `set frame` with the statements of a block, or with the one behind `then` or `else` on a line."""
    before = body.in_force
    try:
        yield
    finally:
        inner, body.in_force = body.in_force, before
        if inner is not before and not body.report.muted:
            _end(body, inner)


def _end(body: Body, inner: FrameInForce) -> None:
    """Warn of a frame in which nothing was read (T314), or remember its name for the lines below."""
    if inner.setting is None:
        return
    line, name = inner.setting
    if inner.is_read:
        body.ended = "" if inner.is_like(body.in_force) else name.text
        return
    message = f"`set frame {name.text}` ends with its block, and nothing in the block is read in that frame"
    hint = f"write it before the block, or `with frame {name.text}` … `endwith` around the lines it is for"
    body.report.at(kinds.FRAME_WITHOUT_LINES, line, name, message, hint)


def _warn_of_ended(body: Body) -> None:
    """Warn of a location below a block in which another frame was set (T315)."""
    name, body.ended = body.ended, ""
    message = f"the frame `{name}` was set in a block above and ended with it: this line is not read in it"
    hint = f"write `set frame {name}` before the block or behind it, or `with frame {name}` inside it"
    body.warn(kinds.FRAME_ENDED, body.line.statement or body.line, message, hint)
