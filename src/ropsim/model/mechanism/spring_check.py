"""Errors in what the springs of a mechanism are fastened to."""

from collections.abc import Iterator

from ropsim.core import Diagnostic
from ropsim.model.findings import mechanism_diagnostics as kinds
from ropsim.model.mechanism.links import BASE_LINK
from ropsim.model.mechanism.mechanism import Mechanism, first_coordinates


def spring_findings(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Return X977 for each spring between bodies that are none, or on a coordinate that is none."""
    count = len(mechanism.joints)
    for spring in mechanism.springs:
        ends = (spring.link_1, spring.link_2)
        if not all(BASE_LINK <= link < count for link in ends) or spring.link_1 == spring.link_2:
            yield kinds.BAD_SPRING.at(
                None,
                f"spring `{spring.name}` of `{mechanism.name}` lies between links {ends[0] + 1} "
                f"and {ends[1] + 1}",
                hint=f"allowed are two of the base (0) and the links 1 to {count}",
                data={"spring": spring.name, "found": ends},
            )
    coordinates = first_coordinates(mechanism.joints)[-1]
    for one in mechanism.joint_springs:
        if not 0 <= one.coordinate < coordinates:
            yield kinds.BAD_SPRING.at(
                None,
                f"joint spring `{one.name}` of `{mechanism.name}` is on coordinate {one.coordinate}",
                hint=f"there are {coordinates}, counted from 0 joint by joint",
                data={"spring": one.name, "found": one.coordinate},
            )
