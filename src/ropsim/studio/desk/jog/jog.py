"""Arms moved by hand: each has its joint coordinates and reports its limits in words."""

from collections.abc import Mapping

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.kinematics import IkOptions, IkStatus, Method, body_poses, forward, inverse, solver_of
from ropsim.model import BodyTree, Cell, RobotModel, Station, body_tree, coupled_limits, link_name, tool_body
from ropsim.spatial import Array, Pose
from ropsim.studio.desk.jog.choice import nearest
from ropsim.studio.desk.jog.location import location_text, typed_text
from ropsim.studio.desk.jog.words import Words, limit_words, refusal_words, singularity_words, worst_first
from ropsim.studio.wire.jobs import JogJoints, JogTcp
from ropsim.studio.wire.replies import Failed, JogReply

ROUNDS = 50
"""How often limits of axes and of joints that follow them are met in turn."""


@frozen_dataclass
class JoggedArm:
    """The arm of a station with everything that a jog needs at once.

    Attributes:
        station: whose arm it is.
        tree: the bodies of its cell.
    """

    station: Station
    tree: BodyTree

    def warm(self) -> None:
        """Load the compiled kinematics."""
        robot = self.station.robot
        if not robot.has_arm:
            return
        inverse(robot, forward(robot, robot.home), IkOptions(near=robot.home))

    def to_joints(self, job: JogJoints) -> JogReply | Failed:
        """Put the arm at joint coordinates; a joint stops at its limit."""
        X_MT = self._tool(job.tool)
        wrong = self._wrong(job.q)
        if wrong or X_MT is None:
            return Failed(wrong or self._no_tool(job.tool))
        wanted = np.array(job.q, dtype=np.float64)
        robot = self.station.robot
        q = within_limits(robot, wanted)
        return self._reply(q, X_MT, limit_words(robot, q, wanted))

    def to_pose(self, job: JogTcp) -> JogReply | Failed:
        """Move the TCP to a pose on the branch that is nearest; where there is none, the arm stays."""
        X_MT = self._tool(job.tool)
        wrong = self._wrong(job.q)
        if wrong or X_MT is None:
            return Failed(wrong or self._no_tool(job.tool))
        here = np.array(job.q, dtype=np.float64)
        robot = self.station.robot
        if not robot.has_arm:
            return self._reply(here, X_MT, [("error", "there is no arm to move, only an axis")])
        X_BM = self.station.X_WB.inverse() @ Pose.from_tuple(job.target) @ X_MT.inverse()
        found = inverse(robot, X_BM, IkOptions(near=here))
        if found.status is not IkStatus.FOUND:
            return self._reply(here, X_MT, refusal_words(robot, found, here))
        choice = nearest(robot, found, here)
        words: Words = [*choice.words, *limit_words(robot, choice.q, choice.q)]
        if solver_of(robot).method is Method.NUMERIC:
            words.append(("info", "found numerically, further branches may exist"))
        return self._reply(choice.q, X_MT, words)

    def _reply(self, q: Array, X_MT: Pose, words: Words) -> JogReply:
        robot, name, places = self.station.robot, self.station.name, self.tree.places()
        hands = {
            tool_body(tool, name): one.fingers for tool, one in self.station.tools.items() if one.fingers
        }
        own = (link_name(0, name), *(body for one in (name, *hands) for body in self.tree.of_mechanism(one)))
        opened = {hand: np.array([[fingers.opened]]) for hand, fingers in hands.items()}
        found = body_poses(self.tree, {name: q[None], **opened}, own)
        poses = {body: Pose.from_matrix(matrix[0]) for body, matrix in found.items()}
        bodies = tuple((places[body], pose.as_tuple()) for body, pose in poses.items())
        X_WT = poses[link_name(robot.tip + 1, name)] @ robot.X_nM @ X_MT
        all_words = worst_first([*words, *singularity_words(robot, q)])
        reached = all(level != "error" for level, _ in words)
        location = location_text(robot, X_MT, q) if robot.has_arm else ""
        typed = typed_text(robot, X_MT, q) if robot.has_arm else ""
        return JogReply(tuple(q.tolist()), X_WT.as_tuple(), bodies, reached, all_words, location, typed)

    def _tool(self, name: str) -> Pose | None:
        """Return X_MT of a tool; without a name that of the station's default tool."""
        tool = self.station.tools.get(name or self.station.default_tool)
        if tool is not None:
            return tool.X_MT
        return None if name else Pose()

    def _no_tool(self, name: str) -> str:
        return f"the cell has no tool `{name[:60]}`, it has {_known(self.station.tools)}"

    def _wrong(self, q: tuple[float, ...]) -> str:
        n = self.station.robot.n
        if len(q) != n:
            return f"{len(q)} joint coordinates were given, the arm has {n} joints"
        return "" if np.isfinite(q).all() else "a joint coordinate is no finite number"


@frozen_dataclass
class JoggedArms:
    """The arms of a cell.

    Attributes:
        arms: by the name of their station.
    """

    arms: Mapping[str, JoggedArm]

    @classmethod
    def of(cls, cell: Cell) -> "JoggedArms":
        """Return the arms of a cell."""
        tree = body_tree(cell)
        return cls({name: JoggedArm(station, tree) for name, station in cell.stations.items()})

    def warm(self) -> None:
        """Load the compiled kinematics of all arms."""
        for arm in self.arms.values():
            arm.warm()

    def move(self, job: JogJoints | JogTcp) -> JogReply | Failed:
        """Move the arm of the station that the job names."""
        arm = self.arms.get(job.station)
        if arm is None:
            return Failed(f"the cell has no station `{job.station[:60]}`, it has {_known(self.arms)}")
        return arm.to_joints(job) if isinstance(job, JogJoints) else arm.to_pose(job)


def _known(names: Mapping[str, object]) -> str:
    return ", ".join(f"`{one}`" for one in names) or "none"


def within_limits(robot: RobotModel, wanted: Array) -> Array:
    """Return the coordinates within all limits that are near to some [rad | m], shape (n,).

    Each axis stops at its limit. A joint that follows several axes stops at its own, by the least motion of
    these axes; where that takes one of them beyond its limit, the others move instead.

    Args:
        robot: the arm.
        wanted: requested [rad | m], shape (n,).
    """
    lower, upper, coupled = robot.lower_limits, robot.upper_limits, coupled_limits(robot)
    q = np.clip(wanted, lower, upper)
    for _ in range(ROUNDS if coupled.joints else 0):
        values = coupled.values(q)
        over = np.clip(values, coupled.lower, coupled.upper) - values
        if not over.any():
            break
        worst = int(np.argmax(np.abs(over)))
        row = coupled.T[worst]
        q = np.clip(q + row * (over[worst] / float(row @ row)), lower, upper)
    return np.asarray(q)
