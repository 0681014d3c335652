"""Complete study of arms: their workspaces, and results for the points of a task."""

from collections.abc import Sequence

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.model import RobotModel
from ropsim.spatial import Pose
from ropsim.workspace.comparing import Candidate, Standing, compared
from ropsim.workspace.dexterity import Dexterity, dexterity
from ropsim.workspace.diagnostics import WorkspaceError
from ropsim.workspace.point import PointKind, moved_point
from ropsim.workspace.task_point import TaskPoint
from ropsim.workspace.volume.reachable import Reachable, reachable


@frozen_dataclass
class ArmStudy:
    """A single arm.

    Attributes:
        robot: the arm.
        workspace: of the requested point; None where it cannot be computed.
        dexterity: of its tool; None where it cannot be computed, or another point was requested.
        findings: reasons, and assumptions.
    """

    robot: RobotModel
    workspace: Reachable | None
    dexterity: Dexterity | None
    findings: tuple[Diagnostic, ...]


@frozen_dataclass
class Study:
    """Arms, and their results for a task.

    Attributes:
        kind: which point the workspaces are of.
        X_MT: tool frame in the frame of the mechanical interface.
        arms: each once.
        points: of the task.
        standings: arms and places of their bases, the best one first; none without points.
    """

    kind: PointKind
    X_MT: Pose
    arms: tuple[ArmStudy, ...]
    points: tuple[TaskPoint, ...]
    standings: tuple[Standing, ...]


def studied(
    candidates: Sequence[Candidate], kind: PointKind, X_MT: Pose, points: Sequence[TaskPoint]
) -> Study:
    """Return the workspaces of arms and, where there are points, the results for these.

    Args:
        candidates: arms and places of their bases; an arm may stand in several.
        kind: which point the workspaces are of.
        X_MT: tool frame in the frame of the mechanical interface.
        points: of a task; the TCP is to come to them.

    Raises:
        MechanismError: an arm cannot be.
    """
    robots = list(dict.fromkeys(one.robot for one in candidates))
    arms = tuple(_studied(robot, kind, X_MT) for robot in robots)
    standings = compared(candidates, points, X_MT) if points else ()
    return Study(kind, X_MT, arms, tuple(points), standings)


def _studied(robot: RobotModel, kind: PointKind, X_MT: Pose) -> ArmStudy:
    try:
        workspace = reachable(robot, moved_point(robot, kind, X_MT))
    except WorkspaceError as error:
        return ArmStudy(robot, None, None, (error.diagnostic,))
    findings, turned = workspace.findings, None
    if kind is not PointKind.WRIST_CENTRE:
        try:
            turned = dexterity(robot, workspace, X_MT)
        except WorkspaceError as error:
            findings += (error.diagnostic,)
    return ArmStudy(robot, workspace, turned, findings)
