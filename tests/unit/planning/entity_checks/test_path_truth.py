"""Paths of one's own that say something else than they do; starts that are none."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.motion import Line, OrientationMode, ToolPoints
from ropsim.planning import (
    TOOL_PATHS,
    MotionChain,
    MotionPlan,
    MotionState,
    PathRequest,
    Refusal,
    StandardPathPlanner,
    plan,
    plan_move,
)
from ropsim.planning.testing import faults_of_tool_path, wrong_tool_derivatives
from ropsim.spatial import Array, Pose
from support.motion import CHAIN, LINE, START, interface_pose, lin, shifted

HERE = interface_pose(START)
THERE = shifted(HERE, -0.1, 0.1, 0.0)


@dataclass(frozen=True)
class Told:
    """A line of somebody else's that says its derivatives are other ones."""

    line: Line
    first: float = 1.0
    second: float = 0.0

    @property
    def length(self) -> float:
        return self.line.length

    def tool(self, s: Array) -> ToolPoints:
        points = self.line.tool(s)
        return ToolPoints(points.matrices, points.d1 * self.first, points.d2 + self.second)

    def positions(self, s: Array) -> Array:
        return self.line.positions(s)

    def distance(self, points: Array) -> Array:
        return self.line.distance(points)


def chain_with(first: float = 1.0, second: float = 0.0, start: float = 0.0, end: float = 0.0) -> MotionChain:
    """Return a chain whose lines are somebody else's, moved at their ends [m]."""

    def make(request: PathRequest) -> Told:
        ends = (shifted(request.X_start, 0.0, 0.0, start), shifted(request.X_end, 0.0, 0.0, end))
        return Told(Line(*ends), first, second)

    planner = CHAIN.planner
    assert isinstance(planner, StandardPathPlanner)
    return replace(CHAIN, planner=replace(planner, kinds={**planner.kinds, "LIN": make}))


@dataclass(frozen=True)
class Woven(Told):
    """A line that goes up and down 2 mm a hundred times, as a weld is woven, and tells that exactly."""

    def tool(self, s: Array) -> ToolPoints:
        points, k = super().tool(s), 2.0 * np.pi * 100.0 / self.length
        shifts = (1.0 - np.cos(k * s), k * np.sin(k * s), k * k * np.cos(k * s))
        woven = ToolPoints(*(np.array(one) for one in (points.matrices, points.d1, points.d2)))
        woven.matrices[:, 2, 3] += 1e-3 * shifts[0]
        woven.d1[:, 2] += 1e-3 * shifts[1]
        woven.d2[:, 2] += 1e-3 * shifts[2]
        return woven


@pytest.mark.parametrize(("first", "second"), [(1.0, 0.0), (1.5, 0.0), (1.0, 1e4)])
def test_a_woven_path_is_refused_only_where_its_derivatives_are_others(first: float, second: float) -> None:
    line, move = Line(HERE, THERE), lin(THERE)
    path = Woven(line, first, second)
    found = wrong_tool_derivatives(path, path, path.tool(np.linspace(0.0, path.length, 997)), move)
    assert (found is None) == ((first, second) == (1.0, 0.0))


def test_a_path_that_is_what_it_says_is_flown() -> None:
    assert isinstance(plan_move(chain_with(), lin(THERE), START), MotionPlan)


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"first": 0.5}, "returned `d1` that is not the derivative"),
        ({"first": 1.05}, "returned `d1` that is not the derivative"),
        ({"second": 1.0}, "returned `d2` that is not the derivative"),
        ({"start": 1e-3}, "`Told` is a path that begins 1 mm from where the tool is"),
        ({"end": 0.05}, "`Told` is a path that ends 50 mm from its target"),
    ],
)
def test_a_path_that_is_another_one_than_it_says_is_refused(wrong: dict[str, float], told: str) -> None:
    found = plan_move(chain_with(**wrong), lin(THERE), START)
    assert isinstance(found, Refusal)
    assert found.diagnostics[0].code == "C603"
    assert told in found.diagnostics[0].message


def test_a_path_of_ours_that_code_of_a_user_has_made_is_looked_at() -> None:
    """Whose class it is says nothing about the points it was given."""

    def astray(request: PathRequest) -> Line:
        return Line(shifted(request.X_start, 0.02, 0.0, 0.0), request.X_end)

    planner = CHAIN.planner
    assert isinstance(planner, StandardPathPlanner)
    chain = replace(CHAIN, planner=replace(planner, kinds={"LIN": astray}))
    found = plan_move(chain, lin(THERE), START)
    assert isinstance(found, Refusal)
    assert "`astray` made a path that begins 20 mm from where the tool is" in found.diagnostics[0].message


VIA = (shifted(HERE, -0.05, 0.08, 0.0), shifted(HERE, -0.08, 0.02, 0.05))


def turned(z: float, angle: float) -> Pose:
    """Return the pose where the tool is, moved by z [m] and turned about the vertical [rad]."""
    c, s = np.cos(angle), np.sin(angle)
    X = shifted(HERE, 0.0, 0.0, z).matrix()
    X[:3, :3] = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]) @ X[:3, :3]
    return Pose.from_matrix(X)


WAYS: dict[str, tuple[Pose, ...]] = {"LIN": (), "CIRC": VIA[:1], "SPLINE": VIA}
"""Points on the way of a move of each kind."""


@pytest.mark.parametrize("kind", TOOL_PATHS)
def test_each_kind_of_path_of_the_house_stands_the_look_that_those_of_users_get(kind: str) -> None:
    """A new kind needs an entry in `WAYS`: our own paths are not looked at while we plan."""
    move = MoveInstruction(kind, THERE, ModalState(), via=WAYS[kind])
    request = PathRequest(move, HERE, WAYS[kind], THERE, OrientationMode.FIXED_AXIS)
    path = TOOL_PATHS[kind](request)
    assert path is not None
    assert not isinstance(path, tuple)
    assert faults_of_tool_path(path, path, move) is None


def test_a_curve_of_another_kind_that_turns_back_in_a_point_is_refused_like_a_spline() -> None:
    planner = CHAIN.planner
    assert isinstance(planner, StandardPathPlanner)
    chain = replace(CHAIN, planner=replace(planner, kinds={"WAVE": TOOL_PATHS["SPLINE"]}))
    ends = ((0.0, -21.0), (-0.000072579, -22.559461), (-0.000004723, -24.361847), (-0.000093222, -31.830284))
    _, *via, target = (turned(z, np.radians(angle + 21.0)) for z, angle in ends)
    wave = MoveInstruction("WAVE", target, ModalState(), via=tuple(via))
    _, refusal = plan(chain, [wave], MotionState.at_rest(START))
    assert refusal is not None
    assert [one.code for one in refusal.diagnostics] == ["M567"]


@pytest.mark.parametrize(
    ("state", "told"),
    [
        (MotionState(START, np.full(6, 0.5), np.zeros(6)), "allowed are zeros"),
        (MotionState(START, np.zeros(6), np.full(6, 1.0)), "allowed are zeros"),
        (MotionState(START, np.full(6, np.nan), np.zeros(6)), "allowed are finite numbers"),
        (MotionState(START * np.nan, np.zeros(6), np.zeros(6)), "allowed are finite numbers"),
        (MotionState(START, np.zeros(3), np.zeros(6)), "speeds of shape (3,), allowed is (6,)"),
    ],
)
def test_a_stretch_is_planned_from_rest_only(state: MotionState, told: str) -> None:
    found, refusal = plan(CHAIN, [lin(THERE)], state)
    assert found is None
    assert refusal is not None
    assert refusal.diagnostics[0].code == "C605"
    assert told in refusal.diagnostics[0].message
    assert refusal.diagnostics[0].span == LINE


def test_the_target_of_an_arc_with_an_angle_may_be_out_of_reach() -> None:
    """It tells where the circle lies; the arc ends before."""
    far = Pose(HERE.position + np.array([3.0, 0.1, 0.0]), HERE.orientation)
    near = shifted(HERE, 0.01, 0.05, 0.0)
    arc = MoveInstruction(MotionKind.CIRC, far, ModalState(), via=(near,), angle=0.02)
    assert isinstance(plan_move(CHAIN, arc, START), MotionPlan)
    to_its_end = plan_move(CHAIN, replace(arc, angle=None), START)
    assert isinstance(to_its_end, Refusal)
