"""Planners of one's own whose plan nobody can use, and entities that refuse without a word."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import pytest

from ropsim.flow import MoveInstruction
from ropsim.planning import MotionChain, PathRequest, PlannedPath, Refusal, StandardPathPlanner
from ropsim.planning.testing import PlannedMove, planned_move_of
from ropsim.spatial import Array, Pose
from support.motion import CHAIN, LINE, START, interface_pose, lin, ptp, shifted

THERE = lin(shifted(interface_pose(START), 0.05, 0.1, -0.06))
JOINTS = ptp((0.5, 1.0, -2.5, 0.5, 0.5, 0.0))


@dataclass(frozen=True)
class Theirs:
    """A planner that changes what the standard one plans."""

    change: Callable[[PlannedPath], PlannedPath | Refusal]

    def plan(self, move: MoveInstruction, q_start: Array) -> PlannedPath | Refusal:
        """Return the changed plan."""
        planned = CHAIN.planner.plan(move, q_start)
        assert isinstance(planned, PlannedPath), planned
        return self.change(planned)


def limits(part: str, name: str, value: object) -> Callable[[PlannedPath], PlannedPath]:
    """Return what puts something in the place of a limit."""

    def change(planned: PlannedPath) -> PlannedPath:
        there = planned.limits
        changed = replace(getattr(there, part), **{name: value})
        return replace(planned, limits=replace(there, **{part: changed}))

    return change


def part(**changes: object) -> Callable[[PlannedPath], PlannedPath]:
    """Return what puts something in the place of parts of a plan."""
    return lambda planned: replace(planned, **changes)  # type: ignore[arg-type]


@pytest.mark.parametrize("move", [THERE, JOINTS])
@pytest.mark.parametrize(
    ("change", "told"),
    [
        (limits("joints", "speed", np.full(6, np.nan)), "returned nan in `limits.joints.speed`"),
        (limits("joints", "jerk", np.full(6, np.inf)), "returned inf in `limits.joints.jerk`"),
        (limits("joints", "speed", np.zeros(6)), "returned 0 in `limits.joints.speed`"),
        (limits("joints", "acceleration", np.ones(5)), "of shape (5,) instead of (6,)"),
        (limits("tool", "speed", float("nan")), "returned nan in `limits.tool.speed`"),
        (limits("tool", "orientation_jerk", -1.0), "returned -1 in `limits.tool.orientation_jerk`"),
        (limits("tool", "speed", "x"), "returned a `str` in `limits.tool.speed`"),
        (part(stops="no"), "returned a `str` as `stops`"),
        (part(X_MT=None), "returned a `NoneType` as `X_MT`"),
        (part(X_MT=Pose(np.array([np.nan, 0.0, 0.0]))), "`X_MT` with numbers that are not finite"),
        (part(limits=None), "returned a `NoneType` as `limits`"),
        (part(coordination=1.0), "returned a `float` as `coordination`"),
        (part(findings=("x",)), "`findings` that are no tuple of Diagnostic"),
        (part(findings=None), "`findings` that are no tuple of Diagnostic"),
        (part(joints=None, tool=None), "returned no path for a target that is"),
        (lambda _: Refusal(()), "refused the move without a Diagnostic"),
        (lambda _: Refusal(("x",)), "refused the move without a Diagnostic"),  # type: ignore[arg-type]
    ],
)
def test_a_plan_that_nobody_can_use_is_told_at_the_line(
    move: MoveInstruction, change: Callable[[PlannedPath], PlannedPath | Refusal], told: str
) -> None:
    refusal = planned_move_of(replace(CHAIN, planner=Theirs(change)), move, START)
    assert isinstance(refusal, Refusal)
    found = refusal.diagnostics[0]
    assert (found.code, found.span) == ("C603", LINE)
    assert found.message.startswith("`Theirs` re")
    assert told in found.message


def test_a_plan_of_somebody_else_that_is_sound_is_used() -> None:
    chain = replace(CHAIN, planner=Theirs(lambda planned: planned))
    for move in (THERE, JOINTS, ptp(tuple(START.tolist())), lin(interface_pose(START)), ptp(None)):
        assert isinstance(planned_move_of(chain, move, START), PlannedMove)


class Silent:
    """Refuses all, and says nothing."""

    def solve(self, *_: object) -> Refusal:
        """Return a refusal without a reason."""
        return Refusal(())

    def sample(self, *_: object) -> Refusal:
        """Return a refusal without a reason."""
        return Refusal(())

    def refine(self, *_: object) -> Refusal:
        """Return a refusal without a reason."""
        return Refusal(())


def no_kind(request: PathRequest) -> tuple[()]:
    """Refuse a path, and say nothing."""
    del request
    return ()


def with_no_kind() -> MotionChain:
    """Return a chain whose lines are refused without a reason."""
    planner = CHAIN.planner
    assert isinstance(planner, StandardPathPlanner)
    return replace(CHAIN, planner=replace(planner, kinds={**planner.kinds, "LIN": no_kind}))


@pytest.mark.parametrize(
    ("chain", "who"),
    [
        (replace(CHAIN, inverse=Silent()), "Silent"),
        (replace(CHAIN, interpolator=Silent()), "Silent"),  # type: ignore[arg-type]
        (replace(CHAIN, joint_interpolator=Silent()), "Silent"),  # type: ignore[arg-type]
        (with_no_kind(), "no_kind"),
    ],
)
def test_a_refusal_without_a_reason_is_told_at_the_line(chain: MotionChain, who: str) -> None:
    refusal = planned_move_of(chain, THERE, START)
    assert isinstance(refusal, Refusal)
    found = refusal.diagnostics[0]
    assert (found.code, found.span) == ("C603", LINE)
    assert found.message == f"`{who}` refused the move without a Diagnostic that says why"
