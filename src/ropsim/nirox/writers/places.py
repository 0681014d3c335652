"""Placements as instances: a point, two directions, and the orientation if these lose bits."""

from ropsim.model import JointType
from ropsim.nirox.building import UNSET, Building, Key, reals
from ropsim.nirox.orientations import (
    X,
    Z,
    columns_of,
    columns_of_pose,
    exact_quaternion,
    moved_frame,
    placed_frame,
    quaternion_of,
)
from ropsim.part21 import Reference, Value
from ropsim.spatial import Pose


def write_placement(
    building: Building, key: Key, pose: Pose, type_: JointType = JointType.FIXED
) -> Reference:
    """Return the placement of a frame.

    Args:
        building: takes the instances.
        key: of the placement.
        pose: of the frame; of a pair the one whose z axis is that of the motion.
        type_: of the pair that is placed; FIXED for none.
    """
    x, _, z = placed_frame(columns_of_pose(pose), type_)
    axis: Value = UNSET
    reference: Value = UNSET
    if (z, x) != (Z, X):
        axis, reference = (building.add(("direction", *one), "DIRECTION", "", reals(one)) for one in (z, x))
    px, py, pz = pose.position.tolist()
    point = (px, py, pz)
    at = building.add(("point", *point), "CARTESIAN_POINT", "", reals(point))
    made = building.add(key, "AXIS2_PLACEMENT_3D", "", at, axis, reference)
    columns = columns_of(z, x)
    found = quaternion_of(moved_frame(columns, type_)) if columns else None
    if found is None or Pose.from_tuple((*point, *found)) != pose:
        exact = reals(exact_quaternion(pose))
        building.add((*key, "orientation"), "PLACEMENT_ORIENTATION", made, exact)
    return made
