"""Mechanisms joined to one: an arm on a track, a positioner next to an arm.

A station drives its arm and its external axes together, so they are one mechanism. The axes of the arm come
first, then the external ones, whose joints are named E1, E2 and so on. Where one of the two has no drives,
the whole has no drives.
"""

from dataclasses import replace

from ropsim.model.drives.drive import Drive
from ropsim.model.mechanism.links import BASE_LINK, Coupling, Joint, LoopCut
from ropsim.model.mechanism.mechanism import Mechanism, first_coordinates
from ropsim.model.mechanism.mechanism_check import check_counts
from ropsim.model.mechanism.springs import JointSpring, Spring
from ropsim.model.robots.robot import RobotModel
from ropsim.spatial import Pose, frozen

_HERE = Pose()


def on_track(arm: RobotModel, track: Mechanism, X_LB: Pose = _HERE) -> RobotModel:
    """Return an arm whose base hangs on the last link of a track, or of another mechanism.

    The base frame is that of the track.

    Args:
        arm: whose base frame is B; it may have external axes already.
        track: mechanism that carries it.
        X_LB: base frame of the arm in the frame of the interface of the track: of its last link.

    Raises:
        MechanismError: one of the two cannot be.
    """
    check_counts(arm)
    check_counts(track)
    carrier = track.interface_link
    X_CB = track.interface @ X_LB
    links = list(track.links)
    base_shapes = track.base_shapes
    seat = tuple(replace(shape, pose=X_CB @ shape.pose) for shape in arm.base_shapes)
    if carrier == BASE_LINK:
        base_shapes = (*base_shapes, *seat)
    else:
        links[carrier] = replace(links[carrier], shapes=(*links[carrier].shapes, *seat))
    count = len(track.joints)
    joints = (*_named(track, arm), *(_hung(joint, count, carrier, X_CB) for joint in arm.joints))
    first = first_coordinates(joints)[count]
    return replace(
        arm,
        joints=joints,
        links=(*links, *arm.links),
        drives=_drives(arm, track),
        home=frozen([*arm.home, *track.home]),
        axes=(*(number + count for number in arm.axes), *track.axes),
        couplings=(*track.couplings, *(_shifted(one, first) for one in arm.couplings)),
        cuts=(*track.cuts, *(_recut(cut, count, carrier, X_CB) for cut in arm.cuts)),
        springs=(*track.springs, *(_refastened(one, count, carrier, X_CB) for one in arm.springs)),
        joint_springs=(*track.joint_springs, *(_moved(one, first) for one in arm.joint_springs)),
        gravity=track.gravity,
        origins=(*arm.origins, *track.origins),
        base_shapes=base_shapes,
        tip=arm.tip + count if arm.tip != BASE_LINK else carrier,
        X_nM=arm.X_nM if arm.tip != BASE_LINK else X_CB @ arm.X_nM,
        external=(*arm.external, *range(arm.n, arm.n + track.n)),
    )


def beside(arm: RobotModel, positioner: Mechanism, X_BP: Pose) -> RobotModel:
    """Return an arm and a mechanism that stands next to it, as one.

    The base frame and the interface belong to the arm.

    Args:
        arm: whose base frame is B; it may have external axes already.
        positioner: whose base frame is P.
        X_BP: where it stands.

    Raises:
        MechanismError: one of the two cannot be.
    """
    check_counts(arm)
    check_counts(positioner)
    count = len(arm.joints)
    joints = (*arm.joints, *(_hung(joint, count, BASE_LINK, X_BP) for joint in _named(positioner, arm)))
    first = first_coordinates(joints)[count]
    seat = (replace(shape, pose=X_BP @ shape.pose) for shape in positioner.base_shapes)
    return replace(
        arm,
        joints=joints,
        links=(*arm.links, *positioner.links),
        drives=_drives(arm, positioner),
        home=frozen([*arm.home, *positioner.home]),
        axes=(*arm.axes, *(number + count for number in positioner.axes)),
        couplings=(*arm.couplings, *(_shifted(one, first) for one in positioner.couplings)),
        cuts=(*arm.cuts, *(_recut(cut, count, BASE_LINK, X_BP) for cut in positioner.cuts)),
        springs=(*arm.springs, *(_refastened(one, count, BASE_LINK, X_BP) for one in positioner.springs)),
        joint_springs=(*arm.joint_springs, *(_moved(one, first) for one in positioner.joint_springs)),
        origins=(*arm.origins, *positioner.origins),
        base_shapes=(*arm.base_shapes, *seat),
        external=(*arm.external, *range(arm.n, arm.n + positioner.n)),
    )


def _named(mechanism: Mechanism, arm: RobotModel) -> tuple[Joint, ...]:
    """Return the joints of a mechanism: E1, E2 … for its axes, the others with the first of those."""
    taken = len(arm.external)
    names = {number: f"E{taken + place + 1}" for place, number in enumerate(mechanism.axes)}
    return tuple(
        replace(joint, name=names.get(number, f"E{taken + 1} {joint.name}"))
        for number, joint in enumerate(mechanism.joints)
    )


def _hung(joint: Joint, count: int, carrier: int, X: Pose) -> Joint:
    """Return a joint `count` places later in the list; one on the base now hangs at X on a carrier."""
    if joint.parent == BASE_LINK:
        return replace(joint, parent=carrier, placement=_placed(X, joint.placement))
    return replace(joint, parent=joint.parent + count)


def _shifted(coupling: Coupling, first: int) -> Coupling:
    terms = tuple((number + first, factor) for number, factor in coupling.terms)
    return Coupling(coupling.dependent + first, terms, coupling.constant)


def _recut(cut: LoopCut, count: int, carrier: int, X: Pose) -> LoopCut:
    first, X_first = (
        (cut.first + count, cut.X_first) if cut.first != BASE_LINK else (carrier, X @ cut.X_first)
    )
    second, X_second = (
        (cut.second + count, cut.X_second) if cut.second != BASE_LINK else (carrier, X @ cut.X_second)
    )
    return replace(cut, first=first, X_first=X_first, second=second, X_second=X_second)


def _refastened(spring: Spring, count: int, carrier: int, X: Pose) -> Spring:
    """Return a spring of links `count` places later in the list; its end on the base is at X on a carrier."""
    link_1, point_1 = spring.link_1 + count, spring.point_1
    link_2, point_2 = spring.link_2 + count, spring.point_2
    if spring.link_1 == BASE_LINK:
        link_1, point_1 = carrier, X.position + X.rotation() @ point_1
    if spring.link_2 == BASE_LINK:
        link_2, point_2 = carrier, X.position + X.rotation() @ point_2
    return replace(spring, link_1=link_1, point_1=point_1, link_2=link_2, point_2=point_2)


def _moved(spring: JointSpring, first: int) -> JointSpring:
    return replace(spring, coordinate=spring.coordinate + first)


def _drives(arm: Mechanism, other: Mechanism) -> tuple[Drive, ...]:
    """Return the drives of both; empty if one has no drives, since a mechanism has all of them or none."""
    return (*arm.drives, *other.drives) if arm.drives and other.drives else ()


def _placed(X: Pose, placement: Pose) -> Pose:
    """Return X @ placement; without a change the placement itself, bit for bit."""
    return placement if X == _HERE else X @ placement
