"""Section of a path of the joints, as a path of its own."""

from ropsim.motion.curves.path import JointPath, JointPoints
from ropsim.motion.curves.traits import constant_derivatives
from ropsim.motion.joint_paths.path_rows import PathRows, rows_of_path
from ropsim.spatial import Array, record


@record
class JointSection:
    """The path parameters `begin` to `end` of a path of the joints, counted from 0.

    Attributes:
        path: of the joints.
        begin: its path parameter at the start of the section.
        end: its path parameter at the end of the section, beyond `begin`.
    """

    path: JointPath
    begin: float
    end: float

    @property
    def length(self) -> float:
        """Return the length in the unit of the path."""
        return self.end - self.begin

    @property
    def constant_derivatives(self) -> Array | None:
        """Return the derivatives of the path, see `constant_derivatives`."""
        return constant_derivatives(self.path)

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at path parameters s, shape (k,)."""
        return self.path.joints(s + self.begin)

    def path_rows(self, begin: float) -> PathRows | None:
        """Return the data of the path for compiled loops; None if unsupported, or for a section of it."""
        return rows_of_path(self.path, self.begin) if begin == 0.0 else None
