"""Values of space: poses and rotations; no robot, no time."""

from ropsim.spatial import quaternion as quaternion
from ropsim.spatial.angles import ALONG_X as ALONG_X
from ropsim.spatial.angles import ALONG_Y as ALONG_Y
from ropsim.spatial.angles import TOOL_FROM_APPROACH as TOOL_FROM_APPROACH
from ropsim.spatial.angles import approach_orientation as approach_orientation
from ropsim.spatial.angles import pitch_roll_yaw as pitch_roll_yaw
from ropsim.spatial.angles import roll_pitch_yaw as roll_pitch_yaw
from ropsim.spatial.bits import bits_of as bits_of
from ropsim.spatial.bits import bits_without as bits_without
from ropsim.spatial.diagnostics import PoseError as PoseError
from ropsim.spatial.numbers import cross as cross
from ropsim.spatial.numbers import real_numbers as real_numbers
from ropsim.spatial.numbers import significant as significant
from ropsim.spatial.numbers import without_residues as without_residues
from ropsim.spatial.pose import Array as Array
from ropsim.spatial.pose import Pose as Pose
from ropsim.spatial.pose import frozen as frozen
from ropsim.spatial.pose import quaternion_from_matrix as quaternion_from_matrix
from ropsim.spatial.pose import quaternions_from_matrices as quaternions_from_matrices
from ropsim.spatial.pose import translation as translation
from ropsim.spatial.quaternion import PoseTuple as PoseTuple
from ropsim.spatial.record import fingerprint as fingerprint
from ropsim.spatial.record import record as record
