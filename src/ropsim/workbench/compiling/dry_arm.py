"""The arm of a station in dry runs: it stands exactly where its moves lead, without time and drives."""

from dataclasses import replace

import numpy as np

from ropsim import icr
from ropsim.controller import ArmPoses
from ropsim.flow import ModalState, MoveInstruction
from ropsim.icr import Target
from ropsim.model import Cell, OrientationMode, Station
from ropsim.motion import ToolPath
from ropsim.planning import TOOL_PATHS, PathRequest, work_frames
from ropsim.spatial import Array, Pose, frozen, record


@record
class DryArm:
    """An arm behind some moves.

    Attributes:
        poses: returns the pose of its tool.
        orientation: how the tool turns on paths.
        target: of the last move; coordinates of the axes at the start; None for the home position.
        modal: modal state of that move; None where the pose at the end of the last move is not known.
        axes: coordinates of the axes [rad | m], shape (n,), of which only the external axes count.
    """

    poses: ArmPoses
    orientation: OrientationMode
    target: Target
    modal: ModalState | None
    axes: Array

    def after(self, move: MoveInstruction) -> "DryArm":
        """Return the arm behind one more move."""
        target = move.target if move.angle is None else self._end_of_arc(move)
        if move.has_free_orientation and isinstance(target, Pose):
            target = self._turned_as_before(target, move.modal)
        is_known = move.angle is None or target is not None
        return replace(
            self, target=target, modal=move.modal if is_known else None, axes=self._axes_after(move)
        )

    def standing(self, modal: ModalState) -> Pose | None:
        """Return the pose X_KT of the tool of a modal state at which the arm stands; None if not known."""
        return None if self.modal is None else self.poses.reached(self.target, self.modal, modal, self.axes)

    def reached(self, target: Target, then: ModalState, now: ModalState) -> Pose | None:
        """Return where a move leads; None for a pose of which the frame moves: see `ArmPoses.reached`."""
        return self.poses.reached(target, then, now)

    def _turned_as_before(self, target: Pose, modal: ModalState) -> Pose:
        """Return a target turned as the tool was before, though an arm with few axes may turn it."""
        X_KT = self.standing(modal)
        return target if X_KT is None else Pose(target.position, X_KT.orientation)

    def _axes_after(self, move: MoveInstruction) -> Array:
        robot = self.poses.robot
        if not isinstance(move.target, Pose):
            q = robot.home if move.target is None else frozen(move.target)
            return q if len(q) == robot.n else self.axes
        if not move.external or len(move.external) != len(robot.external):
            return self.axes
        there = self.axes.copy()
        there[list(robot.external)] = move.external
        return frozen(there)

    def _end_of_arc(self, move: MoveInstruction) -> Pose | None:
        """Return X_KT at the end of an arc that goes on for an angle; None if the arc does not exist."""
        X_start = self.standing(move.modal)
        if X_start is None or not isinstance(move.target, Pose):
            return None
        request = PathRequest(move, X_start, move.via, move.target, self.orientation)
        path = TOOL_PATHS[move.kind](request)
        if path is None or isinstance(path, tuple):
            return None
        return _end(path)


def dry_arm(cell: Cell, station: Station) -> DryArm:
    """Return the arm of a station at the start of its program."""
    poses = ArmPoses(station.robot, work_frames(cell, station))
    q = station.q_start
    return DryArm(poses, station.controller.orientation, tuple(q.tolist()), ModalState(), q)


def _end(path: ToolPath) -> Pose:
    return Pose.from_matrix(path.tool(np.array([path.length])).matrices[0])


_READING = frozenset({"ATTAINED", "CURPOSE"})
"""Instructions that read where the arm is."""


def program_arm(code: icr.Program, cell: Cell | None, station: Station | None) -> icr.Arm | None:
    """Return the arm of a station at the start of a dry run.

    Args:
        code: of the program.
        cell: None for a program without one.
        station: that runs the program; None without a cell.

    Returns:
        None without a cell, and if the program never reads where its arm is.
    """
    if cell is None or station is None:
        return None
    if not any(step.mnemonic in _READING for one in code.procedures for step in one.code):
        return None
    from ropsim.workbench.compiling.dry_arm import dry_arm

    return dry_arm(cell, station)
