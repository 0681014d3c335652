"""Ways into and out of zones: where the TCP leaves and enters one along the path of a move."""

from typing import Protocol

import numpy as np

from ropsim.kinematics import chain_arrays, forward_batch
from ropsim.model import RobotModel
from ropsim.motion import (
    TRACED,
    ZONE_NODES,
    ZONE_SHARES,
    JointPath,
    PathRows,
    ToolPath,
    enter,
    has_straight_tcp,
    leave,
    rows_of_path,
)
from ropsim.planning.blends.zone_search_kernel import SearchPaths, SearchWork, zones_of_arm
from ropsim.spatial import Array, Pose

Crossing = tuple[float, float]
"""A path parameter in the unit of the path, and how far the TCP is from the blend there [m]."""


class TcpPath(Protocol):
    """Path of the TCP along a move, with the centre of a zone at one end."""

    @property
    def length(self) -> float:
        """Return the length of the path, in its own unit."""

    def leave(self, zone: float, clip: float) -> Crossing:
        """Return the parameter, at least `clip`, behind which the TCP stays in a zone [m] round the end."""

    def enter(self, zone: float, clip: float) -> Crossing:
        """Return the parameter, at most `clip`, before which the TCP stays in a zone [m] round the start."""

    def distance(self, s: float, other: float) -> float:
        """Return the distance of the TCP between two path parameters [m]."""


def tcp_path_of(robot: RobotModel, joints: JointPath, X_MT: Pose, tool: ToolPath | None) -> TcpPath:
    """Return the path of the TCP along a move.

    Args:
        robot: the arm.
        joints: its path.
        X_MT: the tool.
        tool: the path of the tool, if any; positions are in its frame, else in the base frame.
    """
    if has_straight_tcp(tool):
        return StraightTcpPath(joints.length)
    rows = None if tool or robot.cuts else rows_of_path(joints)
    if rows is None or rows.kind == TRACED:
        return _EvaluatedTcpPath(robot, joints, X_MT, tool)
    return _ArmTcpPath(robot, joints, X_MT, rows)


class StraightTcpPath:
    """Along a straight line, with the path parameters of both ends in closed form, without a search.

    Args:
        length: of the line [m].
    """

    def __init__(self, length: float) -> None:
        self.length = length

    def leave(self, zone: float, clip: float) -> Crossing:
        """Return the path parameter at which a zone [m] round the end begins, at least `clip`."""
        s = max(clip, self.length - zone)
        return s, abs(s - self.length)

    def enter(self, zone: float, clip: float) -> Crossing:
        """Return the path parameter at which a zone [m] round the start ends, at most `clip`."""
        s = min(clip, zone)
        return s, s

    def distance(self, s: float, other: float) -> float:
        """Return the distance of two path parameters [m]."""
        return abs(s - other)


class _EvaluatedTcpPath:
    """Along a path of the tool, or one of the joints that only the path itself can evaluate."""

    def __init__(self, robot: RobotModel, joints: JointPath, X_MT: Pose, tool: ToolPath | None) -> None:
        self._robot, self._joints, self._X_MT, self._tool = robot, joints, X_MT, tool
        self.length = joints.length

    def _positions(self, s: Array) -> Array:
        """Return TCP positions [m] at path parameters, (k,) to (k, 3)."""
        if self._tool is not None:
            return self._tool.positions(s)
        matrices = forward_batch(self._robot, self._joints.joints(s).q)
        return np.asarray((matrices @ self._X_MT.matrix())[:, :3, 3])

    def leave(self, zone: float, clip: float) -> Crossing:
        s = leave(self._positions, self.length, zone, clip)
        return s, self.distance(s, self.length)

    def enter(self, zone: float, clip: float) -> Crossing:
        s = enter(self._positions, self.length, zone, clip)
        return s, self.distance(s, 0.0)

    def distance(self, s: float, other: float) -> float:
        a, b = self._positions(np.array([s, other]))
        return float(np.linalg.norm(a - b))


class _ArmTcpPath(_EvaluatedTcpPath):
    """Along a path of the joints from one row of coordinates to another."""

    def __init__(self, robot: RobotModel, joints: JointPath, X_MT: Pose, rows: PathRows) -> None:
        super().__init__(robot, joints, X_MT, None)
        self._chain, self._rows = chain_arrays(robot), rows

    def leave(self, zone: float, clip: float) -> Crossing:
        return self._searched(zone, self.length - clip, 1.0)

    def enter(self, zone: float, clip: float) -> Crossing:
        return self._searched(zone, min(clip, self.length), 0.0)

    def _searched(self, zone: float, clip: float, from_end: float) -> Crossing:
        """Return where the path is in a zone at most `clip` from the end (1.0) or the start (0.0)."""
        kind, begin, length, size, flat, *_ = self._rows
        chain, rows = self._chain, np.concatenate(flat).reshape(size, -1)
        requested = np.array([(self.length, zone, clip, from_end, kind, begin, length, 0.0, size)])
        tcps = self._X_MT.position[np.newaxis]
        paths = SearchPaths(ZONE_SHARES, ZONE_NODES, chain.flat, chain.spread, rows, tcps)
        zones_of_arm(paths, requested, SearchWork.of(1, self._robot.n, len(chain.slides)))
        s, distance, *_ = requested[0].tolist()
        return s, distance
