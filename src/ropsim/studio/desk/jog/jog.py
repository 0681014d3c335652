"""The jogged arm: it stands where its joint coordinates say and tells in words what limits it."""

from dataclasses import dataclass

import numpy as np

from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    Method,
    body_poses,
    forward,
    inverse,
    solver_of,
)
from ropsim.model import ROBOT, BodyKind, BodyTree, Cell, body_tree, link_name
from ropsim.spatial import Array, Pose
from ropsim.studio.desk.jog.choice import nearest
from ropsim.studio.desk.jog.words import Words, limit_words, refusal_words, singularity_words, worst_first
from ropsim.studio.jobs import Failed, JogJoints, JogReply, JogTcp


@dataclass(frozen=True, slots=True)
class JoggedArm:
    """The arm of a cell with everything that a jog needs at once.

    Attributes:
        cell: the cell.
        tree: its bodies.
    """

    cell: Cell
    tree: BodyTree

    @classmethod
    def of(cls, cell: Cell) -> "JoggedArm":
        """Return the arm of a cell."""
        return cls(cell, body_tree(cell))

    def warm(self) -> None:
        """Load the compiled kinematics."""
        robot = self.cell.first.robot
        inverse(robot, forward(robot, robot.home), IkOptions(near=robot.home))

    def to_joints(self, job: JogJoints) -> JogReply | Failed:
        """Put the arm at joint coordinates; a joint stops at its limit."""
        X_MT = self._tool(job.tool)
        wrong = self._wrong(job.q)
        if wrong or X_MT is None:
            return Failed(wrong or self._no_tool(job.tool))
        wanted = np.array(job.q, dtype=np.float64)
        robot = self.cell.first.robot
        q = np.clip(wanted, robot.lower_limits, robot.upper_limits)
        return self._reply(q, X_MT, limit_words(robot, q, wanted))

    def to_pose(self, job: JogTcp) -> JogReply | Failed:
        """Move the TCP to a pose on the branch that is nearest; where there is none, the arm stays."""
        X_MT = self._tool(job.tool)
        wrong = self._wrong(job.q)
        if wrong or X_MT is None:
            return Failed(wrong or self._no_tool(job.tool))
        here = np.array(job.q, dtype=np.float64)
        robot = self.cell.first.robot
        X_BM = self.cell.first.X_WB.inverse() @ Pose.from_tuple(job.target) @ X_MT.inverse()
        found = inverse(robot, X_BM, IkOptions(near=here))
        if found.status is not IkStatus.FOUND:
            return self._reply(here, X_MT, refusal_words(robot, found))
        choice = nearest(robot, found, here)
        words: Words = [*choice.words, *limit_words(robot, choice.q, choice.q)]
        if solver_of(robot).method is Method.NUMERIC:
            words.append(("info", "found numerically, further branches may exist"))
        return self._reply(choice.q, X_MT, words)

    def _reply(self, q: Array, X_MT: Pose, words: Words) -> JogReply:
        robot, places = self.cell.first.robot, self.tree.places()
        moving = self.tree.names(BodyKind.BASE, BodyKind.LINK)
        found = body_poses(self.tree, {ROBOT: q[None]}, moving)
        poses = {name: Pose.from_matrix(matrix[0]) for name, matrix in found.items()}
        bodies = tuple((places[name], pose.as_tuple()) for name, pose in poses.items())
        X_WT = poses[link_name(robot.tip + 1)] @ robot.X_nM @ X_MT
        all_words = worst_first([*words, *singularity_words(robot, q)])
        reached = all(level != "error" for level, _ in words)
        return JogReply(tuple(q.tolist()), X_WT.as_tuple(), bodies, reached, all_words)

    def _tool(self, name: str) -> Pose | None:
        """Return X_MT of a tool; without a name that of the cell's default tool."""
        tool = self.cell.first.tools.get(name or self.cell.first.default_tool)
        if tool is not None:
            return tool.X_MT
        return None if name else Pose()

    def _no_tool(self, name: str) -> str:
        known = ", ".join(f"`{one}`" for one in self.cell.first.tools) or "none"
        return f"the cell has no tool `{name[:60]}`, it has {known}"

    def _wrong(self, q: tuple[float, ...]) -> str:
        n = self.cell.first.robot.n
        if len(q) != n:
            return f"{len(q)} joint coordinates were given, the arm has {n} joints"
        return "" if np.isfinite(q).all() else "a joint coordinate is no finite number"
