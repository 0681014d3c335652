"""The names that pairs have in files, by the types of joints, and their freedoms."""

from collections.abc import Mapping
from types import MappingProxyType

from ropsim.model import ALL_DIRECTIONS, Direction, JointType

PAIRS: Mapping[JointType, str] = MappingProxyType(
    {
        JointType.REVOLUTE: "revolute_pair",
        JointType.PRISMATIC: "prismatic_pair",
        JointType.SCREW: "screw_pair",
        JointType.CYLINDRICAL: "cylindrical_pair",
        JointType.UNIVERSAL: "universal_pair",
        JointType.SPHERICAL: "spherical_pair",
        JointType.PLANAR: "planar_pair",
        JointType.FIXED: "fully_constrained_pair",
    }
)
"""The entity of each type of joint; entities of one freedom can end with `_with_range`."""

FREE: Mapping[str, frozenset[Direction]] = MappingProxyType(
    {
        "revolute_pair": frozenset((Direction.ABOUT_Z,)),
        "prismatic_pair": frozenset((Direction.X,)),
        "cylindrical_pair": frozenset((Direction.Z, Direction.ABOUT_Z)),
        "universal_pair": frozenset((Direction.ABOUT_X, Direction.ABOUT_Z)),
        "spherical_pair": frozenset((Direction.ABOUT_X, Direction.ABOUT_Y, Direction.ABOUT_Z)),
        "spherical_pair_with_pin": frozenset((Direction.ABOUT_Y, Direction.ABOUT_Z)),
        "planar_pair": frozenset((Direction.X, Direction.Y, Direction.ABOUT_Z)),
        "fully_constrained_pair": frozenset(),
    }
)
"""The directions in which the two placements of a pair can part."""

BOOLEANS = ("t_x", "t_y", "t_z", "r_x", "r_y", "r_z")
"""Attributes of low_order_kinematic_pair, in the order of `ALL_DIRECTIONS`."""


def pair_of(held: tuple[Direction, ...]) -> str:
    """Return the entity of the pair that a cut holds together in some directions."""
    free = frozenset(ALL_DIRECTIONS) - frozenset(held)
    return next((name for name, found in FREE.items() if found == free), "low_order_kinematic_pair")
