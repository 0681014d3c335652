"""Centres of mass that lie beside their links: numbers of another frame, or of another arm."""

from collections.abc import Iterator, Mapping

import numpy as np

from ropsim.core import Diagnostic
from ropsim.model.findings import doubt_diagnostics as kinds
from ropsim.model.findings.place import Attribute, AuditPlace, PlaceOf
from ropsim.model.mechanism.links import JointType
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.spatial import Array

FARTHEST = 0.55
"""Greatest distance of a centre of mass from its link, over the length of the longest link.

Sound files stay below 0.53 (27 of ROS-Industrial, FANUC, KUKA, Universal Robots, Franka and others); files
whose centres are in the frames of other links have 0.8 and more.
"""


def distant_centres(robot: Mechanism, place_of: PlaceOf) -> Iterator[Diagnostic]:
    """Yield the turning links whose centre of mass is far from all of them, in one finding.

    A link is taken for the lines from its joint to the joints that it carries, and to the interface. Links
    that slide have no such line.

    Args:
        robot: audited mechanism.
        place_of: where its numbers stand in the file that it was read from.
    """
    ends = _ends(robot)
    longest = max((float(np.linalg.norm(end)) for some in ends.values() for end in some), default=0.0)
    far = [
        (number, min(_distance(link.com, end) for end in ends[number]))
        for number, link in enumerate(robot.links[: len(robot.joints)])
        if link.mass > 0.0 and number in ends and robot.joints[number].type is JointType.REVOLUTE
    ]
    far = [(number, away) for number, away in far if away > FARTHEST * longest > 0.0]
    if not far:
        return
    number, away = max(far, key=lambda one: one[1])
    names = ", ".join(f"`{one + 1}`" for one, _ in far)
    yield kinds.UNLIKELY_INERTIA.at(
        place_of(AuditPlace(number, Attribute.COM)),
        f"the centres of mass of links {names} lie beside them, that of link `{number + 1}` by {away:.3g} m; "
        f"the longest link has {longest:.3g} m",
        hint="are they in the frame of another link, or of another arm?",
        data={"found_m": away, "length_m": longest},
    )


def _ends(robot: Mechanism) -> Mapping[int, list[Array]]:
    """Return the points to which each link goes from its joint, in the frame of that [m]."""
    found: dict[int, list[Array]] = {}
    for joint in robot.joints:
        if joint.parent >= 0:
            found.setdefault(joint.parent, []).append(joint.placement.position)
    if robot.joints:
        found.setdefault(robot.interface_link, []).append(robot.interface.position)
    return found


def _distance(point: Array, end: Array) -> float:
    """Return the distance of a point from the line from the origin to an end [m]."""
    square = float(end @ end)
    share = min(1.0, max(0.0, float(point @ end) / square)) if square else 0.0
    return float(np.linalg.norm(point - share * end))
