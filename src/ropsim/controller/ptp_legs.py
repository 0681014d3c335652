"""Legs from pose to pose that are chosen all at once, each in the posture in which the one before ends."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.controller.by_identity import ByIdentity
from ropsim.controller.leg import Leg
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.path_planner import StandardPathPlanner
from ropsim.controller.plain_run import MoveWork, Works, run_of, targets_of
from ropsim.controller.planned_path import PlannedPath
from ropsim.controller.posture_choice import LIMIT_SLACK, JointRange
from ropsim.controller.ptp_legs_kernel import ROOM, SHEETS, choose_ends
from ropsim.controller.work_frames import inverted
from ropsim.core import maker
from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.kinematics import chain_arrays, exact_arm, solver_of
from ropsim.model import RobotModel, Synchronisation
from ropsim.motion import JointLine, JointMotionLimits, JointPath, SynchronisedJoints
from ropsim.spatial import Array, Pose, frozen

_Room = tuple[Array, Array, Array]
_planned, _leg = maker(PlannedPath), maker(Leg)
_NONE = frozen([])
"""Stands for the base frame, and for no tool."""


@dataclass(frozen=True, slots=True, eq=False)
class PtpLegs:
    """What makes legs from pose to pose for an arm with spherical wrist, where the standard planner does.

    Attributes:
        in_time: whether joints have profiles of their own.
        works: what is known of modal states.
        rooms: to work in, of which each call takes one.
    """

    in_time: bool
    works: Works
    rooms: list[_Room]

    def legs(self, moves: Sequence[MoveInstruction], first: int, q_start: Array) -> list[Leg]:
        """Return legs from a move on, as far as they can be made so; none where another is next.

        Args:
            moves: in order.
            first: number of the first one of which a leg is asked.
            q_start: command joint coordinates at its start [rad], shape (n,).
        """
        if moves[first].kind != MotionKind.PTP:
            return []
        works = run_of(moves, first, MotionKind.PTP, self.works)
        count = next((k for k in range(len(works)) if moves[first + k].posture is not None), len(works))
        if count == 0:
            return []
        run, plans = moves[first : first + count], [work.begun.plan for work in works[:count]]
        bounds = _bounds([plan.limits.joints for plan in plans])
        q, shapes, told = np.empty((count + 1, 6)), np.empty((count, 3, 6)), np.empty(count)
        q[0] = q_start
        room = self.rooms.pop() if self.rooms else _room()
        works[0].lead(targets_of(run), bounds, q, shapes, told, *room)
        self.rooms.append(room)
        q.flags.writeable = shapes.flags.writeable = False
        legs, begin = list[Leg](), q[0]
        for number, time in enumerate(told.tolist()):
            if not time:
                break
            plan, end = plans[number], q[number + 1]
            joints: JointPath
            if self.in_time:
                joints = SynchronisedJoints.of_shapes(begin, end, plan.limits.joints, time, shapes[number])
            else:
                joints = JointLine.of_ends(begin, end)
            planned = _planned(joints, None, plan.limits, plan.X_MT, (), None)
            legs.append(_leg(run[number], planned, joints, end, (), None))
            begin = end
        return legs


def _bounds(limits: Sequence[JointMotionLimits]) -> Array:
    """Return speed, acceleration and jerk of every joint for each of k moves, shape (k, 3, n)."""
    rows = [row for each in limits for row in (each.speed, each.acceleration, each.jerk)]
    return np.concatenate(rows).reshape(len(limits), 3, -1)


@lru_cache(maxsize=16)
def ptp_legs_of(chain: MotionChain) -> PtpLegs | None:
    """Return what makes legs from pose to pose of a chain, None where each is to be made by itself."""
    planner, robot = chain.planner, chain.robot
    if type(planner) is not StandardPathPlanner or planner.robot is not robot or robot.external:
        return None
    arm, limits = _arm(robot), JointRange.of(robot)
    if arm is None or limits.coupled.joints or MotionKind.PTP in planner.kinds:
        return None
    in_time = planner.controller.ptp is Synchronisation.TIME
    axes = frozen((limits.lower, limits.upper, limits.revolute))
    own = bound(choose_ends, chain_arrays(robot).flat, arm, axes, LIMIT_SLACK, int(in_time))

    @lru_cache(maxsize=64)
    def lead(X_BK: Pose, X_MT: Pose) -> Compiled:
        return bound(own, _numbers(X_BK), _numbers(inverted(X_MT)))

    def work(modal: ModalState) -> MoveWork | None:
        begun = planner.begun(modal)
        return MoveWork(begun, lead(begun.X_BK, begun.plan.X_MT), begun.X_BK.is_identity) if begun else None

    return PtpLegs(in_time, ByIdentity(work), [])


def _arm(robot: RobotModel) -> Array | None:
    """Return the arm for `inverse_rows`, None where more than that solves it."""
    if not robot.has_arm or robot.cuts or not chain_arrays(robot).parallel:
        return None
    return exact_arm(solver_of(robot))


def _numbers(X: Pose) -> Array:
    return _NONE if X.is_identity else frozen(X.as_tuple())


def _room() -> _Room:
    return np.empty((SHEETS, 8, 6)), np.empty((2, 4, 4)), np.empty(ROOM)
