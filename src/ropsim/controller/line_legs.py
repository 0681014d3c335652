"""Legs along straight lines that are led all at once, each from where the one before ends."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import takewhile

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.controller.begun import Begun
from ropsim.controller.branch_following import CLOSE
from ropsim.controller.by_identity import ByIdentity
from ropsim.controller.guide import guide_of
from ropsim.controller.kinds import TOOL_PATHS
from ropsim.controller.leg import Leg
from ropsim.controller.line_legs_kernel import ROOM, SHEETS, lead_lines
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.move_check import MAX_DURATION
from ropsim.controller.path_planner import StandardPathPlanner
from ropsim.controller.planned_path import PlannedPath
from ropsim.controller.posture_choice import LIMIT_SLACK
from ropsim.controller.posture_trouble import max_speeds_of
from ropsim.controller.posture_wish import other_posture
from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.kinematics import chain_arrays, exact_arm, solver_of
from ropsim.model import OrientationMode, RobotModel
from ropsim.motion import LINE_SIZE, Line, Traced, stencils
from ropsim.spatial import Array, Pose, frozen

_MOST = 129
"""Rows for which there is room on one line; a longer one is led by itself."""
_EACH = 33
"""Rows for which there is room on each line, when they are many."""
_Room = tuple[Array, Array, Array]
_BASE = frozen([])
"""Stands for the base frame."""


@dataclass(frozen=True, slots=True, eq=False)
class LineWork:
    """What lines of one modal state have in common.

    Attributes:
        begun: limits and tool.
        lead: the rest of `lead_lines` behind the task frame and the tool; one and the same for equal ones.
        in_base: whether targets are given in the base frame.
    """

    begun: Begun
    lead: Compiled
    in_base: bool


@dataclass(frozen=True, slots=True, eq=False)
class LineLegs:
    """What makes legs of lines where standard entities lead an arm with spherical wrist.

    Attributes:
        robot: the arm.
        mode: how the tool turns.
        works: what is known of modal states; None where lines are to be planned one by one.
        rooms: to work in, of which each call takes one.
    """

    robot: RobotModel
    mode: OrientationMode
    works: ByIdentity[ModalState, LineWork | None]
    rooms: list[_Room]

    def legs(self, moves: Sequence[MoveInstruction], first: int, q_start: Array) -> list[Leg]:
        """Return the legs of lines from a move on, as far as they can be made so; none where another is next.

        Args:
            moves: in order.
            first: number of the first one of which a leg is asked.
            q_start: command joint coordinates at its start [rad], shape (n,).
        """
        work = self._work(moves[first])
        if work is None:
            return []
        run = [moves[first], *takewhile(lambda move: self._goes_on(work, move), moves[first + 1 :])]
        return self._led(run, work, q_start)

    def _work(self, move: MoveInstruction) -> LineWork | None:
        is_plain = move.kind == MotionKind.LIN and isinstance(move.target, Pose) and not move.external
        return self.works(move.modal) if is_plain else None

    def _goes_on(self, work: LineWork, move: MoveInstruction) -> bool:
        other = self._work(move)
        return other is not None and other.lead is work.lead

    def _led(self, moves: Sequence[MoveInstruction], work: LineWork, q_start: Array) -> list[Leg]:
        count, parts = len(moves), list[Array]()
        for move in moves:
            target = move.target
            assert isinstance(target, Pose)
            parts += target.position, target.orientation
        rows = _MOST + _EACH * (count - 1)
        targets, poses = np.concatenate(parts).reshape(count, 7), np.empty((count + 1, 7))
        numbers, told = np.empty((count, LINE_SIZE)), np.empty((count, 2))
        q, derivatives = np.empty((rows, 6)), np.empty(12 * rows)
        room = self.rooms.pop() if self.rooms else _room()
        work.lead(targets, q_start, poses, numbers, q, derivatives, told, *room)
        self.rooms.append(room)
        legs, at, X_start = list[Leg](), 0, Pose.of_units(poses[0])
        for number, (each, longest) in enumerate(told.tolist()):
            if not each:
                break
            move, until = moves[number], at + int(each)
            known = (work if number == 0 else self.works(move.modal) or work).begun.plan
            X_end = move.target if work.in_base else Pose.of_units(poses[number + 1])
            assert isinstance(X_end, Pose)
            line = Line.of_numbers(X_start, X_end, self.mode, numbers[number])
            planned = PlannedPath(None, line, known.limits, known.X_MT)
            if planned.least_time > MAX_DURATION:
                break
            slopes = derivatives[12 * at : 12 * until].reshape(2, until - at, 6)
            joints = Traced.of_rows(line.length, q[at:until], slopes)
            q_end = joints.q[-1]
            findings = other_posture(move, self.robot, q_end)
            legs.append(Leg(move, planned, joints, q_end, findings, longest))
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

    def work(modal: ModalState) -> LineWork | None:
        begun, X_TM = planner.begun(modal), guide.inverse.backwards(modal)
        if begun is None or X_TM is None or not np.array_equal(X_TM, begun.plan.X_MT.inverse().matrix()):
            return None
        return LineWork(begun, lead(begun.X_BK, begun.plan.X_MT), begun.X_BK.is_identity)

    return LineLegs(robot, mode, ByIdentity(work), [])


def _room() -> _Room:
    return np.empty((SHEETS, _MOST, 6)), np.empty((_MOST, 4, 4)), np.empty(ROOM + 2 * _MOST)
