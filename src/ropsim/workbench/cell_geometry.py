"""What the geometry of a cell tells about tasks: where its arms can go."""

from collections.abc import Hashable
from typing import TYPE_CHECKING

from ropsim import icr, language
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
        self.revision: Hashable = id(cell)

    def reachable(self, robot: str, location: "Point") -> bool:
        """Return whether a robot has joint coordinates inside its limits for a location.

        Args:
            robot: `arm`, or the name of a station; no other is there.
            location: name of the cell, or numbers in millimetres and degrees, read as task text reads
                them. One that has joint values, or lies in a frame that moves, is taken to be in reach.
        """
        from ropsim.tasks import TaskCall

        station = self._cell.first if robot == ARM else self._cell.stations.get(robot)
        if station is None:
            return False
        text = f"program reach\nunits mm, deg, s\nmov {TaskCall('', (location,))}\n"
        environment = environment_of(self._cell, station)
        code = language.compile(text, environment).icr
        if code is None:
            return False
        (move,) = icr.run(code).moves
        if not isinstance(move.target, Pose) or move.modal.frame in environment.moving:
            return True
        X_MT = move.modal.X_MT or Pose()
        X_BM = move.modal.X_BK @ move.target @ X_MT.inverse()
        return len(inverse(station.robot, X_BM, _near(station, move.external)).solutions) > 0

    def collision_free(self, robot: str, part: str, location: "Point") -> bool:  # noqa: ARG002 - protocol
        """Return True: nothing looks for collisions yet."""
        return True


def _near(station: Station, external: tuple[float, ...]) -> IkOptions:
    """Return that the arm is near its start, with external axes [rad | m] where a location has them."""
    q = station.q_start.copy()
    if external:
        q[list(station.robot.external)] = external
    return IkOptions(near=q)
