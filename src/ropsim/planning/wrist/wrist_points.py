"""The points of a path with wrist angles, at which the joints of the wrist are prescribed."""

from ropsim.motion import ToolPath, knots_of
from ropsim.planning.records.coordination import Coordination
from ropsim.planning.wrist.wrist_motion import standing
from ropsim.spatial import Array, record


@record
class WristPoints:
    """Start, points on the way and end of a path.

    Attributes:
        parameters: on the path, rising from 0 to its length, shape (k,).
        X_BT: the tool there, shape (k, 4, 4).
        q: coordinates of all axes at the start, the external ones as they go along [rad | m], shape (k, n).
    """

    parameters: Array
    X_BT: Array
    q: Array

    @property
    def end(self) -> int:
        """Return the number of the last one, from 0 for the start."""
        return len(self.parameters) - 1

    def name(self, number: int) -> str:
        """Return in words which point one is."""
        if number == self.end:
            return "its end"
        x, y, z = (1e3 * self.X_BT[number, :3, 3]).tolist()
        share = self.parameters[number] / self.parameters[-1]
        return f"its point at {share:.0%} of the way, ({x:.1f}, {y:.1f}, {z:.1f}) mm in the base frame,"


def points_of(path: ToolPath, q_start: Array, coordination: Coordination | None) -> WristPoints:
    """Return the points of a path: of a curve the points that it passes, of others their ends.

    Args:
        path: in the base frame or that of the coordination.
        q_start: coordinates of all axes at its start [rad | m], shape (n,).
        coordination: external axes that go along; None where they stand.
    """
    parameters = knots_of(path)
    q, X = standing(q_start, coordination, parameters), path.tool(parameters).matrices
    if coordination and coordination.frame:
        X = coordination.frame.matrices(q) @ X
    return WristPoints(parameters, X, q)
