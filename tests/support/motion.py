"""The PUMA 560 with its controller, two tools and a frame; helpers that plan moves and stretches."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ropsim import robots
from ropsim.core import Diagnostic, Span
from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin
from ropsim.kinematics import forward_batch
from ropsim.model import Frame, LookAhead, Tool
from ropsim.motion import JERK_LIMITED, TIME_LAWS
from ropsim.planning import MotionChain, MotionPlan, MotionState, Refusal, TimingRules, plan, plan_move
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station

LINE = Span.on_line("cell.task", 14, 3, 14)
PASS = 17
FINE = ModalState()

PUMA = robots.load("puma560")
START: Array = np.array([0.2, 1.1, -2.9, -0.4, -0.9, 0.3])  # far from limits and singularities
CELL = one_station(
    "test",
    PUMA,
    robots.default_controller("puma560"),
    tools={
        "gripper": Tool("gripper", Pose(np.array([0.0, 0.0, 0.1]))),
        "torch": Tool("torch", Pose(np.array([0.02, -0.03, 0.15]), np.array([0.9, 0.1, 0.2, 0.3]))),
    },
    frames={"pallet": Frame(Pose(np.array([0.4, -0.2, 0.1]), np.array([0.0, 1.0, 0.2, 0.0])))},
)
CHAIN = chain_of(CELL)

Target = Pose | tuple[float, ...] | None
AHEAD = LookAhead()
RULES = TimingRules(TIME_LAWS[JERK_LIMITED], AHEAD)  # of sections of a motion sequence


def ptp(target: Target, modal: ModalState = FINE, visit: int = PASS) -> MoveInstruction:
    """Return a PTP move that stands in line 14."""
    return MoveInstruction(MotionKind.PTP, target, modal, Origin(LINE, visit))


def lin(target: Target, modal: ModalState = FINE, visit: int = PASS) -> MoveInstruction:
    """Return a LIN move that stands in line 14."""
    return MoveInstruction(MotionKind.LIN, target, modal, Origin(LINE, visit))


def planned(move: MoveInstruction, q_start: Array = START, chain: MotionChain = CHAIN) -> MotionPlan:
    """Return the plan of the move; fail where it is refused."""
    result = plan_move(chain, move, q_start)
    assert isinstance(result, MotionPlan), result
    return result


def refused(move: MoveInstruction, q_start: Array = START, chain: MotionChain = CHAIN) -> Diagnostic:
    """Return the one reason why a move is refused; fail where it is planned."""
    result = plan_move(chain, move, q_start)
    assert isinstance(result, Refusal)
    assert len(result.diagnostics) == 1
    return result.diagnostics[0]


def planned_stretch(
    moves: Sequence[MoveInstruction], q_start: Array = START, chain: MotionChain = CHAIN
) -> MotionPlan:
    """Return the plan through moves; fail where one is refused."""
    result, refusal = plan(chain, moves, MotionState.at_rest(q_start))
    assert refusal is None, refusal
    assert result is not None
    return result


def references(plan: MotionPlan) -> tuple[Array, Array, Array]:
    """Return q, qd and qdd of a plan at its control ticks with those of its start, each (ticks + 1, n)."""
    q = np.concatenate((plan.q_start[None], plan.reference.q))
    rest = np.zeros((1, len(plan.q_start)))
    return q, np.concatenate((rest, plan.reference.qd)), np.concatenate((rest, plan.reference.qdd))


def interface_pose(q: Array) -> Pose:
    """Return X_BM of the PUMA."""
    return Pose.from_matrix(forward_batch(PUMA, q[None])[0])


def shifted(pose: Pose, x: float, y: float, z: float) -> Pose:
    """Return the pose moved by (x, y, z) [m] in base axes."""
    return replace(pose, position=pose.position + np.array([x, y, z]))
