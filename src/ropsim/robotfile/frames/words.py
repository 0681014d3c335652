"""Words of robot files for joints and closed chains."""

from collections.abc import Mapping
from types import MappingProxyType

from ropsim.model import ALL_DIRECTIONS, Direction, JointType

BASE = "base"
"""Name of the body that stands still."""
TYPES = tuple(one.value for one in JointType)
_D = Direction
FREE: Mapping[str, tuple[Direction, ...]] = MappingProxyType(
    {
        "fixed": (),
        "revolute": (_D.ABOUT_Z,),
        "prismatic": (_D.Z,),
        "cylindrical": (_D.Z, _D.ABOUT_Z),
        "universal": (_D.ABOUT_X, _D.ABOUT_Z),
        "spherical": (_D.ABOUT_X, _D.ABOUT_Y, _D.ABOUT_Z),
        "planar": (_D.X, _D.Y, _D.ABOUT_Z),
    }
)
"""Directions that a joint leaves free where it closes a chain."""
DIRECTIONS = tuple(one.value for one in ALL_DIRECTIONS)


def held_by(joint: str) -> tuple[Direction, ...]:
    """Return the directions that a joint holds where it closes a chain."""
    return tuple(one for one in ALL_DIRECTIONS if one not in FREE[joint])


def joint_of(held: tuple[Direction, ...]) -> str:
    """Return the joint that holds these directions, in their usual order; empty for none."""
    return next((name for name in FREE if held_by(name) == held), "")


def coordinate_kinds(type_: JointType) -> tuple[JointType, ...]:
    """Return for each coordinate of a joint whether it turns (REVOLUTE) or slides (PRISMATIC)."""
    turn, slide = JointType.REVOLUTE, JointType.PRISMATIC
    return {
        JointType.PRISMATIC: (slide,),
        JointType.CYLINDRICAL: (turn, slide),
        JointType.PLANAR: (slide, slide, turn),
    }.get(type_, (turn,) * type_.freedoms)
