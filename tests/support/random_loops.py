"""Random closed chains in space: joints of all types in a row, whose end is cut from the base."""

import numpy as np

from ropsim.model import (
    ALL_DIRECTIONS,
    BASE_LINK,
    Direction,
    Joint,
    JointType,
    Link,
    LoopCut,
    Mechanism,
)
from ropsim.spatial import Pose

D = Direction
HELD = {
    JointType.FIXED: ALL_DIRECTIONS,
    JointType.REVOLUTE: (D.X, D.Y, D.Z, D.ABOUT_X, D.ABOUT_Y),
    JointType.CYLINDRICAL: (D.X, D.Y, D.ABOUT_X, D.ABOUT_Y),
    JointType.UNIVERSAL: (D.X, D.Y, D.Z, D.ABOUT_Y),
    JointType.SPHERICAL: (D.X, D.Y, D.Z),
    JointType.PLANAR: (D.Z, D.ABOUT_X, D.ABOUT_Y),
}
"""What a cut holds in place of a joint."""
_TYPES = (
    JointType.REVOLUTE,
    JointType.REVOLUTE,
    JointType.PRISMATIC,
    JointType.SCREW,
    JointType.CYLINDRICAL,
    JointType.UNIVERSAL,
    JointType.SPHERICAL,
)


def random_pose(random: np.random.Generator) -> Pose:
    return Pose(random.uniform(-0.5, 0.5, 3), random.normal(size=4))


def random_loop(seed: int, closing: JointType | None = None, axes: int = 2) -> Mechanism:
    """Return a closed chain that is closed where all its coordinates are 0, with `axes` freedoms.

    Args:
        seed: of the chain.
        closing: type of the joint that the cut stands for; any by default.
        axes: driven joints, the first ones.
    """
    random = np.random.default_rng(seed)
    kind = closing or tuple(HELD)[random.integers(len(HELD))]
    left = len(HELD[kind]) + axes
    types: list[JointType] = []
    while left:
        single = len(types) < axes
        type_ = _TYPES[random.integers(4 if single else len(_TYPES))]
        if type_.freedoms <= left:
            types.append(type_)
            left -= type_.freedoms
    joints = tuple(
        Joint(str(k), type_, random_pose(random), 0.0, -2.0, 2.0, 1.0, 1.0, 1.0, parent=k - 1, lead=0.2)
        for k, type_ in enumerate(types)
    )
    end = Pose()
    for one in joints:
        end = end @ one.placement
    first = random_pose(random)
    cut = LoopCut(len(joints) - 1, first, BASE_LINK, end @ first, HELD[kind])
    links = (Link(1.0, np.zeros(3), np.eye(3)),) * len(joints)
    return Mechanism(
        f"loop {seed}", "loop", joints, links, (), np.zeros(axes), axes=tuple(range(axes)), cuts=(cut,)
    )


def with_joint_at_the_cut(loop: Mechanism, kind: JointType) -> Mechanism:
    """Return the same chain with a joint of the type for which its cut stands, and a cut that holds all."""
    cut = loop.cuts[0]
    more = Joint("closing", kind, cut.X_first, 0.0, -4.0, 4.0, 1.0, 1.0, 1.0, parent=len(loop.joints) - 1)
    joints, links = (*loop.joints, more), (*loop.links, loop.links[0])
    whole = LoopCut(len(loop.joints), Pose(), BASE_LINK, cut.X_second)
    return Mechanism(
        f"{loop.name} joined", "loop", joints, links, (), loop.home, axes=loop.axes, cuts=(whole,)
    )
