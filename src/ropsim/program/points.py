"""Points of arcs and curves that define no path, if they are constants."""

import math
from dataclasses import dataclass, field
from itertools import pairwise

from ropsim.core import Diagnostic, frozen_dataclass, maker
from ropsim.flow import MotionKind
from ropsim.program import statements as st
from ropsim.program.diagnostics import IMPOSSIBLE_PATH
from ropsim.program.expressions import Constant, Expression, InFrame, InPosture
from ropsim.program.move import Move
from ropsim.program.program import Program
from ropsim.program.types import ValueType

SAME_PLACE = 1e-6
"""Points nearer to each other, or to a line, than this are taken for one, or for points of it [m]."""

_Point = tuple[float, float, float]


@frozen_dataclass
class KnownPlace:
    """Where a location is known to be: a point in the work frame, or in a frame that moves."""

    frame: str
    point: _Point


_known = maker(KnownPlace)
_STILL = frozenset({st.Assign, st.AssignComponent, st.Message, st.Output, st.Wait, st.Grip})
"""Statements that leave the TCP where it is."""


def check_points(program: Program) -> tuple[Diagnostic, ...]:
    """Return an error for each arc and each curve whose constant points define no path."""
    blocks = (program.main, *(task.body for task in program.tasks))
    return tuple(found for block in blocks for found in points_of(block))


def points_of(block: st.Block) -> tuple[Diagnostic, ...]:
    """Return the same for one task, or for the control statements."""
    return points_from(block, None)[0]


def points_from(
    block: st.Block, place: KnownPlace | None
) -> tuple[tuple[Diagnostic, ...], KnownPlace | None]:
    """Return the same for statements that begin with the TCP at a place, and the place where they end."""
    check = _Check()
    after = check.block(block, place)
    return tuple(check.found), after


@dataclass(slots=True)
class _Check:
    """Follows the place of the TCP through blocks; None where it is not known."""

    found: list[Diagnostic] = field(default_factory=list)

    def block(self, block: st.Block, place: KnownPlace | None) -> KnownPlace | None:
        for statement in block:
            place = self.statement(statement, place)
        return place

    def statement(self, statement: st.Statement, place: KnownPlace | None) -> KnownPlace | None:
        """Return the place after a statement; unknown after control flow."""
        if type(statement) in _STILL:
            return place
        match statement:
            case Move():
                return self.move(statement, place)
            case st.With(settings=settings, body=body):
                is_other = settings.tool is not None
                after = self.block(body, None if is_other else place)
                return None if is_other else after
            case st.Set(settings=settings):
                return place if settings.tool is None else None
            case st.If(branches=branches, otherwise=otherwise):
                return _joined([self.block(one, place) for one in (*(b for _, b in branches), otherwise)])
            case st.WaitUntil(otherwise=otherwise):
                return _joined([place, self.block(otherwise, place)])
            case st.While(body=body) | st.Repeat(body=body) | st.For(body=body):
                self.block(body, None)
                return None
            case st.Call() | st.Break() | st.Continue() | st.Return() | st.Stop():
                return None
        return place

    def move(self, move: Move, start: KnownPlace | None) -> KnownPlace | None:
        is_other = move.settings.tool is not None
        if move.via:
            self.through(move, None if is_other else start)
        ends_there = move.angle is None and move.guard is None and move.tracking is None
        return _place(move.target) if ends_there and not is_other else None

    def through(self, move: Move, start: KnownPlace | None) -> None:
        """Note the fault of the points of an arc or a curve."""
        places = [start, *map(_place, (*move.via, move.target))]
        if move.kind == MotionKind.CIRC and len(places) == 3:
            fault = _arc_fault(places)
        elif move.kind == MotionKind.SPLINE:
            fault = _curve_fault(places)
        else:
            fault = None
        if fault is not None:
            self.found.append(IMPOSSIBLE_PATH.at(move.span, fault[0], hint=fault[1]))


def _place(location: Expression) -> KnownPlace | None:
    """Return a constant location, None if only a run determines it."""
    frame = location.frame if isinstance(location, InFrame) else ""
    inner = location.operand if isinstance(location, InFrame) else location
    if isinstance(inner, InPosture):
        inner = inner.operand
    if isinstance(inner, Constant) and inner.type is ValueType.POSE and isinstance(inner.value, tuple):
        x, y, z = inner.value[:3]
        return _known(frame, (x, y, z))
    return None


def _arc_fault(places: list[KnownPlace | None]) -> tuple[str, str] | None:
    """Return the fault of the points of an arc, and the hint."""
    start, via, target = places
    if _is_one(via, target):
        return "the via point of the arc is its target", "choose a point between start and target"
    if _is_one(start, via):
        return "the via point of the arc is its start", "choose a point between start and target"
    if _is_one(start, target):
        hint = "for a full circle choose another target on it and write `angle 360 deg`"
        return "the arc begins at its target", hint
    if start and via and target and start.frame == via.frame == target.frame:
        along, across = _way(start, target), _way(start, via)
        height = math.hypot(*_cross(along, across)) / math.hypot(*along)
        if height <= SAME_PLACE:
            hint = "write `lin`, or choose a via point beside the line"
            return "start, via point and target of the arc lie on one line", hint
    return None


def _curve_fault(places: list[KnownPlace | None]) -> tuple[str, str] | None:
    """Return which points of a curve are one; a first point at the start is no further one."""
    points = places[1:]
    for number, (one, other) in enumerate(pairwise(points), 1):
        if _is_one(one, other):
            last = "the target" if number + 1 == len(points) else f"point {number + 1}"
            return f"point {number} of the curve and {last} are at one place", "leave one of them out"
    return None


def _joined(places: list[KnownPlace | None]) -> KnownPlace | None:
    first, *others = places
    return first if all(one == first for one in others) else None


def _is_one(one: KnownPlace | None, other: KnownPlace | None) -> bool:
    if one is None or other is None or one.frame != other.frame:
        return False
    return math.dist(one.point, other.point) <= SAME_PLACE


def _way(start: KnownPlace, end: KnownPlace) -> _Point:
    a, b = start.point, end.point
    return b[0] - a[0], b[1] - a[1], b[2] - a[2]


def _cross(a: _Point, b: _Point) -> _Point:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
