"""What the geometry of a cell tells about tasks: where its arms can go."""

from collections.abc import Hashable
from typing import TYPE_CHECKING

from ropsim import icr, language
from ropsim.flow import MoveInstruction
from ropsim.kinematics import IkOptions, inverse
from ropsim.model import Cell, Station
from ropsim.spatial import Pose
from ropsim.workbench.environment import environment_of

if TYPE_CHECKING:  # knowledge bases and their engine are loaded by who asks one
    from ropsim.tasks import Point

ARM = "arm"
"""How tasks call the first robot of a cell; others have the names of their stations."""


class CellGeometry:
    """Answers by inverse kinematics, for the tool that a robot has at the start; it knows no collisions."""

    unchecked = ("collisions",)

    def __init__(self, cell: Cell) -> None:
        self._cell = cell
        self._environments: dict[str, language.Environment] = {}
        self.revision: Hashable = id(cell)

    def reachable(self, robot: str, location: "Point") -> bool:
        """Return whether a robot has joint coordinates inside its limits for a location.

        Args:
            robot: `arm`, or the name of a station; no other is there.
            location: name of the cell, or numbers in millimetres and degrees, read as task text reads
                them. One that has joint values, or lies in a frame that moves, is taken to be in reach.
        """
        station = self._cell.first if robot == ARM else self._cell.stations.get(robot)
        if station is None:
            return False
        move = self._move(station, location)
        if move is None:
            return False
        X_BT = self._pose(station, move)
        if X_BT is None:
            return True
        X_BM = X_BT @ (move.modal.X_MT or Pose()).inverse()
        return len(inverse(station.robot, X_BM, _near(station, move.external)).solutions) > 0

    def pose(self, location: "Point") -> Pose | None:
        """Return X_BT of a location for the first robot of the cell.

        Args:
            location: as for `reachable`.

        Returns:
            None where there is no such location, it has joint values, or lies in a frame that moves.
        """
        move = self._move(self._cell.first, location)
        return None if move is None else self._pose(self._cell.first, move)

    def _move(self, station: Station, location: "Point") -> MoveInstruction | None:
        """Return the move to a location, as a program of this station would make it."""
        from ropsim.tasks import TaskCall

        text = f"program reach\nunits mm, deg, s\nmov {TaskCall('', (location,))}\n"
        code = language.compile(text, self._environment(station)).icr
        return icr.run(code).moves[0] if code is not None else None

    def _pose(self, station: Station, move: MoveInstruction) -> Pose | None:
        """Return X_BT of the target of a move, None where it is not known before the program runs."""
        if not isinstance(move.target, Pose) or move.modal.frame in self._environment(station).moving:
            return None
        return move.modal.X_BK @ move.target

    def _environment(self, station: Station) -> language.Environment:
        if station.name not in self._environments:
            self._environments[station.name] = environment_of(self._cell, station)
        return self._environments[station.name]

    def collision_free(self, robot: str, part: str, location: "Point") -> bool:  # noqa: ARG002 - protocol
        """Return True: nothing looks for collisions yet."""
        return True


def _near(station: Station, external: tuple[float, ...]) -> IkOptions:
    """Return that the arm is near its start, with external axes [rad | m] where a location has them."""
    q = station.q_start.copy()
    if external:
        q[list(station.robot.external)] = external
    return IkOptions(near=q)
