"""How an arm is drawn: by its own shapes, or by hubs at its joints and rods between them.

The stand-in needs only the joints: a cylinder along each axis and a tapered rod from each joint to the next,
as paper 1 draws an arm from its Denavit–Hartenberg table.
"""

import numpy as np

from ropsim.model import BASE_LINK, Cylinder, Joint, JointType, RobotModel, Shape, is_bare, rod
from ropsim.spatial import Array, Pose

_HUB = "#4a525a"
_ROD = "#d5d9dd"
_SLENDERNESS = 0.045  # radius of the first rod by length of the arm
_TAPER = 0.6  # share of the radius that is lost on the way to the tip
_SHORTEST = 1e-3  # [m], joints nearer than this to each other have no rod between them
_LONGEST_SLIDE = 5.0  # [m], stands in for a slide without limits


def base_shapes(robot: RobotModel) -> tuple[Shape, ...]:
    """Return the shapes of the fixed part of a robot, in the base frame."""
    if robot.base_shapes:
        return robot.base_shapes
    radius = _radius(robot, 0)
    foot = rod((0.0, 0.0, 0.0), (0.0, 0.0, 0.4 * radius), 2.0 * radius, 1.8 * radius, _HUB)
    placement = robot.joints[0].placement.position
    if float(np.linalg.norm(placement)) < _SHORTEST:
        return (foot,)
    return (foot, rod(np.zeros(3), placement, 1.2 * radius, radius, _ROD))


def link_shapes(robot: RobotModel, number: int) -> tuple[Shape, ...]:
    """Return the shapes of link `number`, from 1, in the frame of its joint.

    Of a crank that only counts an axis, without mass and with nothing on it, and of a step between two joints
    of an arm with shapes, nothing is drawn.
    """
    own = robot.links[number - 1].shapes if number <= len(robot.links) else ()
    bare = _only_counts(robot, number - 1) or is_bare(robot, number - 1)
    return own or (() if bare else _stand_in(robot, number))


def reach(robot: RobotModel) -> tuple[Array, float]:
    """Return centre [m], shape (3,), and radius [m] of a sphere that the mechanical interface never leaves.

    In the base frame. The centre is the place of the second joint on the way to the interface along the axis
    of the first one, which no turn of that one moves.
    """
    way = _way(robot)
    steps = [placement.position for placement in _fixed_parts(robot)[1:]]
    along = np.array([0.0, 0.0, steps[0][2]])
    centre = robot.joints[way[0]].placement @ Pose(along)
    steps[0] = steps[0] - along
    slides = sum(max(_slide(robot.joints[number])) for number in way)
    return centre.position, sum(float(np.linalg.norm(step)) for step in steps) + slides


def _way(robot: RobotModel) -> list[int]:
    """Return the numbers of the joints from the base to the interface, from 0."""
    found, link = [], robot.tip
    while link != BASE_LINK:
        found.append(link)
        link = robot.joints[link].parent
    return found[::-1]


def _only_counts(robot: RobotModel, link: int) -> bool:
    """Return whether a link, from 0, is only an axis that other joints follow."""
    carries = link == robot.tip or any(joint.parent == link for joint in robot.joints)
    followed = any(number == link for one in robot.couplings for number, _ in one.terms)
    return followed and not carries and not robot.links[link].mass


def _fixed_parts(robot: RobotModel) -> list[Pose]:
    return [*(robot.joints[number].placement for number in _way(robot)), robot.X_nM]


def _stand_in(robot: RobotModel, number: int) -> tuple[Shape, ...]:
    """Return a hub at the joint and rods to the joints, or the interface, that its link carries."""
    joint = robot.joints[number - 1]
    here, there = _radius(robot, number - 1), _radius(robot, number)
    middle = 1.5 * here if number == 1 else 0.0  # the first joint often has its frame at the floor
    shapes = [Shape(Cylinder(1.25 * here, 3.0 * here), Pose(np.array([0.0, 0.0, middle])), _HUB)]
    back, front = _slide(joint)
    if back + front > _SHORTEST:  # the bar that slides through the hub of the joint
        shapes.append(rod((0.0, 0.0, -back), (0.0, 0.0, front), 0.8 * here, None, _ROD))
    carried = [other.placement for other in robot.joints if other.parent == number - 1]
    ends = [X.position for X in [*carried, *([robot.X_nM] if robot.tip == number - 1 else [])]]
    rods = [
        rod(np.zeros(3), end, here, there, _ROD) for end in ends if float(np.linalg.norm(end)) > _SHORTEST
    ]
    return (*shapes, *rods)


def _slide(joint: Joint) -> tuple[float, float]:
    """Return how far a prismatic joint has its own origin ahead of (behind) its placement at most [m]."""
    if joint.type is not JointType.PRISMATIC:
        return 0.0, 0.0
    ahead, behind = joint.upper + joint.offset, -joint.lower - joint.offset
    return min(max(ahead, 0.0), _LONGEST_SLIDE), min(max(behind, 0.0), _LONGEST_SLIDE)


def _radius(robot: RobotModel, number: int) -> float:
    """Return the radius of a rod at joint `number`, from 0 [m]."""
    whole = sum(float(np.linalg.norm(placement.position)) for placement in _fixed_parts(robot))
    return max(_SLENDERNESS * whole, 1e-3) * (1.0 - _TAPER * number / len(robot.joints))
