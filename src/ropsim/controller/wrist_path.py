"""The path of a tool whose wrist joints turn evenly: the way of the TCP, and the joints that lead it."""

from ropsim.kinematics import forward_batch
from ropsim.model import RobotModel
from ropsim.motion import JointPath, ToolPath, ToolPoints, numeric_points
from ropsim.spatial import Array, Pose, record


@record
class WristPath:
    """The TCP goes along a way; how the tool turns follows from the joints.

    Attributes:
        robot: the arm.
        way: a path of the tool in the base frame, of which the positions count.
        joints: that take the TCP along it, over the same length.
        X_MT: the tool.
    """

    robot: RobotModel
    way: ToolPath
    joints: JointPath
    X_MT: Pose

    @property
    def length(self) -> float:
        """Return the length in the unit of the way."""
        return self.way.length

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at places s, shape (k,)."""
        turned, way = numeric_points(self._matrices, s, self.length), self.way.tool(s)
        d1, d2 = turned.d1.copy(), turned.d2.copy()
        d1[:, :3], d2[:, :3] = way.d1[:, :3], way.d2[:, :3]
        return ToolPoints(turned.matrices, d1, d2)

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at places s, shape (k,) to (k, 3) [m]."""
        return self.way.positions(s)

    def distance(self, points: Array) -> Array:
        """Return how far points, shape (k, 3) [m], are from the way of the TCP, shape (k,) [m]."""
        return self.way.distance(points)

    def _matrices(self, s: Array) -> Array:
        matrices: Array = forward_batch(self.robot, self.joints.joints(s).q) @ self.X_MT.matrix()
        matrices[:, :3, 3] = self.way.positions(s)
        return matrices
