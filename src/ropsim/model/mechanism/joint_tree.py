"""The joints of a mechanism taken apart into steps of one freedom each: the common input of all algorithms.

A step turns about or slides along the z axis of its own frame, as a joint of a serial arm does. A joint with
one freedom is one step, a screw is a turn and a slide with one coordinate, a joint with more freedoms is one
step for each, and a fixed joint is none: its link rides on the step that carries its parent. The coordinates
of the steps are a constant linear function of the coordinates of the axes.
"""

from collections.abc import Iterator
from functools import lru_cache
from math import pi, sqrt

import numpy as np

from ropsim.model.mechanism.coordinates import coordinates
from ropsim.model.mechanism.links import BASE_LINK, Joint, JointType
from ropsim.model.mechanism.mechanism import Mechanism, first_coordinates
from ropsim.spatial import Array, Pose, frozen, record

_TURN, _SLIDE = JointType.REVOLUTE, JointType.PRISMATIC
_STAY = Pose()
_ABOUT_X = Pose(orientation=frozen([sqrt(0.5), 0.0, sqrt(0.5), 0.0]))  # Ry(90°): the new z is the old x
_ABOUT_Y = Pose(orientation=frozen([sqrt(0.5), -sqrt(0.5), 0.0, 0.0]))  # Rx(-90°): the new z is the old y


@record
class JointTree:
    """A mechanism as a tree of m steps that n axes move.

    Attributes:
        types: REVOLUTE or PRISMATIC, of each step.
        parents: step that each one hangs on, which comes before it; -1 for the base.
        placements: of each step's frame at coordinate 0, in the frame of its parent.
        offsets: added to the coordinates [rad | m].
        T: coordinates of the steps are T·q + c, shape (m, n).
        c: shape (m,) [rad | m].
        P: the same for the coordinates that closed chains determine, shape (m, p); they are added to T·q + c.
        carriers: step that each link rides on, -1 for the base.
        X_SL: frame of each link in that of its step.
        parallel: whether step i is axis i, as in an arm without couplings: T is 1 and c is 0.
    """

    types: tuple[JointType, ...]
    parents: tuple[int, ...]
    placements: tuple[Pose, ...]
    offsets: tuple[float, ...]
    T: Array
    c: Array
    P: Array
    carriers: tuple[int, ...]
    X_SL: tuple[Pose, ...]
    parallel: bool

    @property
    def m(self) -> int:
        """Return the number of steps."""
        return len(self.types)

    def way(self, link: int) -> tuple[int, ...]:
        """Return the steps from the base to a link, in order."""
        found = []
        step = self.carriers[link] if link != BASE_LINK else BASE_LINK
        while step != BASE_LINK:
            found.append(step)
            step = self.parents[step]
        return tuple(reversed(found))


@lru_cache(maxsize=256)
def joint_tree(mechanism: Mechanism) -> JointTree:
    """Return the steps of a mechanism, which `mechanism_findings` has nothing against."""
    made = coordinates(mechanism)
    first = first_coordinates(mechanism.joints)
    types: list[JointType] = []
    parents: list[int] = []
    placements: list[Pose] = []
    offsets: list[float] = []
    rows: list[Array] = []
    carriers: list[int] = []
    X_SL: list[Pose] = []
    whole = np.column_stack((made.T, made.P, made.c))
    for number, joint in enumerate(mechanism.joints):
        on_base = joint.parent == BASE_LINK
        step = BASE_LINK if on_base else carriers[joint.parent]
        placement = joint.placement if on_base else _joined(X_SL[joint.parent], joint.placement)
        rest = _STAY
        for type_, X, back, index, factor in _steps(joint):
            types.append(type_)
            parents.append(step)
            placements.append(_joined(placement, X))
            offsets.append(factor * joint.offset if index == 0 else 0.0)
            rows.append(factor * whole[first[number] + index])
            step, placement, rest = len(types) - 1, back, back
        carriers.append(step)
        X_SL.append(placement if joint.type is JointType.FIXED else rest)
    table = np.array(rows).reshape(len(rows), whole.shape[1])
    T, P, c = table[:, : mechanism.n], table[:, mechanism.n : -1], table[:, -1]
    alone = not P.size and not c.any()
    parallel = alone and T.shape == (mechanism.n,) * 2 and bool((np.eye(mechanism.n) == T).all())
    return JointTree(
        tuple(types),
        tuple(parents),
        tuple(placements),
        tuple(offsets),
        frozen(T),
        frozen(c),
        frozen(P),
        tuple(carriers),
        tuple(X_SL),
        parallel,
    )


Step = tuple[JointType, Pose, Pose, int, float]
"""Type; its frame before it moves; the frame of the joint in it; number and factor of its coordinate."""


def _steps(joint: Joint) -> Iterator[Step]:
    """Return the steps of a joint; each but the first stands in the frame that the one before has left."""
    along_x, along_y = (_ABOUT_X, _ABOUT_X.inverse()), (_ABOUT_Y, _ABOUT_Y.inverse())
    along_z = (_STAY, _STAY)
    if joint.type is JointType.SCREW:
        yield _TURN, *along_z, 0, 1.0
        yield _SLIDE, *along_z, 0, joint.lead / (2.0 * pi)
    elif joint.type is JointType.CYLINDRICAL:
        yield _TURN, *along_z, 0, 1.0
        yield _SLIDE, *along_z, 1, 1.0
    elif joint.type is JointType.UNIVERSAL:
        yield _TURN, *along_z, 0, 1.0
        yield _TURN, *along_x, 1, 1.0
    elif joint.type is JointType.SPHERICAL:
        yield _TURN, *along_z, 0, 1.0
        yield _TURN, *along_y, 1, 1.0
        yield _TURN, *along_x, 2, 1.0
    elif joint.type is JointType.PLANAR:
        yield _SLIDE, *along_x, 0, 1.0
        yield _SLIDE, *along_y, 1, 1.0
        yield _TURN, *along_z, 2, 1.0
    elif joint.type is not JointType.FIXED:
        yield joint.type, *along_z, 0, 1.0


def _joined(one: Pose, other: Pose) -> Pose:
    """Return one @ other; where one of them is no change, the other itself, bit for bit."""
    if one == _STAY:
        return other
    return one if other == _STAY else one @ other
