"""Legs along straight lines that are led all at once, each from where the one before ends."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.controller.branch_following import CLOSE
from ropsim.controller.by_identity import ByIdentity
from ropsim.controller.guide import guide_of
from ropsim.controller.kinds import TOOL_PATHS
from ropsim.controller.leg import Leg
from ropsim.controller.line_legs_kernel import ROOM, SHEETS, lead_lines
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.move_check import MAX_DURATION
from ropsim.controller.path_planner import StandardPathPlanner
from ropsim.controller.plain_run import MoveWork, Works, run_of, targets_of
from ropsim.controller.planned_path import PlannedPath
from ropsim.controller.posture_choice import LIMIT_SLACK
from ropsim.controller.posture_trouble import max_speeds_of
from ropsim.controller.posture_wish import other_posture
from ropsim.core import maker
from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.kinematics import chain_arrays, exact_arm, solver_of
from ropsim.model import OrientationMode, RobotModel
from ropsim.motion import LINE_SIZE, Line, Traced, stencils
from ropsim.spatial import Array, Pose, frozen

_MOST = 129
"""Rows for which there is room on one line; a longer one is led by itself."""
_EACH = 33
"""Rows for which there is room on each line, when they are many."""
_traced, _planned, _leg = maker(Traced), maker(PlannedPath), maker(Leg)
_Room = tuple[Array, Array, Array]
_BASE = frozen([])
"""Stands for the base frame."""


@dataclass(frozen=True, slots=True, eq=False)
class LineLegs:
    """What makes legs of lines where standard entities lead an arm with spherical wrist.

    Attributes:
        robot: the arm.
        mode: how the tool turns.
        works: what is known of modal states.
        rooms: to work in, of which each call takes one.
    """

    robot: RobotModel
    mode: OrientationMode
    works: Works
    rooms: list[_Room]

    def legs(self, moves: Sequence[MoveInstruction], first: int, q_start: Array) -> list[Leg]:
        """Return the legs of lines from a move on, as far as they can be made so; none where another is next.

        Args:
            moves: in order.
            first: number of the first one of which a leg is asked.
            q_start: command joint coordinates at its start [rad], shape (n,).
        """
        works = run_of(moves, first, MotionKind.LIN, self.works)
        return self._led(moves[first : first + len(works)], works, q_start) if works else []

    def _led(self, moves: Sequence[MoveInstruction], works: Sequence[MoveWork], q_start: Array) -> list[Leg]:
        count = len(moves)
        rows = _MOST + _EACH * (count - 1)
        poses, numbers, told = np.empty((count + 1, 7)), np.empty((count, LINE_SIZE)), np.empty((count, 2))
        q, derivatives = np.empty((rows, 6)), np.empty(12 * rows)
        room = self.rooms.pop() if self.rooms else _room()
        works[0].lead(targets_of(moves), q_start, poses, numbers, q, derivatives, told, *room)
        self.rooms.append(room)
        numbers.flags.writeable = q.flags.writeable = derivatives.flags.writeable = False
        legs, at, X_start = list[Leg](), 0, Pose.of_units(poses[0])
        for number, (each, longest) in enumerate(told.tolist()):
            if not each:
                break
            move, until = moves[number], at + int(each)
            known = works[number].begun.plan
            X_end = move.target if works[number].in_base else Pose.of_units(poses[number + 1])
            assert isinstance(X_end, Pose)
            line = Line.of_numbers(X_start, X_end, self.mode, numbers[number])
            planned = _planned(None, line, known.limits, known.X_MT, (), None)
            if planned.least_time > MAX_DURATION:
                break
            slopes = derivatives[12 * at : 12 * until].reshape(2, until - at, 6)
            joints = _traced(line.length, q[at:until], slopes)
            q_end = joints.q[-1]
            findings = other_posture(move, self.robot, q_end)
            legs.append(_leg(move, planned, joints, q_end, findings, longest))
            at, X_start = until, X_end
        return legs


@lru_cache(maxsize=16)
def line_legs_of(chain: MotionChain) -> LineLegs | None:
    """Return what makes legs of lines of a chain, None where each is to be made by itself."""
    guide, planner, robot = guide_of(chain), chain.planner, chain.robot
    if guide is None or type(planner) is not StandardPathPlanner or planner.robot is not robot:
        return None
    arm, steps = exact_arm(solver_of(robot)), chain_arrays(robot)
    mode = planner.controller.orientation
    if arm is None or not steps.parallel or mode is OrientationMode.WRIST_ANGLES:
        return None
    if planner.kinds is not TOOL_PATHS or guide.inverse.robot is not robot:
        return None
    inner, sided = stencils()
    drives = int(mode is OrientationMode.DRIVE_TRANSFORM)
    own = bound(
        lead_lines, steps.flat, arm, guide.inverse.axes, inner, sided, max_speeds_of(robot),
        CLOSE, LIMIT_SLACK, guide.interpolator.way, guide.interpolator.turn, drives,
    )  # fmt: skip

    @lru_cache(maxsize=64)
    def lead(X_BK: Pose, X_MT: Pose) -> Compiled:
        frame = _BASE if X_BK.is_identity else frozen(X_BK.as_tuple())
        return bound(own, frame, frozen(X_MT.as_tuple()), frozen(X_MT.inverse().matrix()))

    def work(modal: ModalState) -> MoveWork | None:
        begun, X_TM = planner.begun(modal), guide.inverse.backwards(modal)
        if begun is None or X_TM is None or not np.array_equal(X_TM, begun.plan.X_MT.inverse().matrix()):
            return None
        return MoveWork(begun, lead(begun.X_BK, begun.plan.X_MT), begun.X_BK.is_identity)

    return LineLegs(robot, mode, ByIdentity(work), [])


def _room() -> _Room:
    return np.empty((SHEETS, _MOST, 6)), np.empty((_MOST, 4, 4)), np.empty(ROOM + 2 * _MOST)
