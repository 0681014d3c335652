"""Springs and dampers of a file."""

import numpy as np

from ropsim.model import JointSpring, Spring
from ropsim.nirox.readers.mechanism import Mechanism
from ropsim.nirox.readers.seen import Seen
from ropsim.spatial import Array


def read_springs(seen: Seen, mechanism: Mechanism) -> tuple[Spring, ...]:
    """Return the springs between bodies; raises `ImpossibleError` where a body is none of the mechanism."""
    found = []
    for number, entry in enumerate(seen.extent("link_spring")):
        links = [seen.ref(entry, f"link_{place}") for place in (1, 2)]
        if any(link not in mechanism.links for link in links):
            raise seen.impossible(entry, "its links do not belong to the mechanism")
        seen.take(entry, "spring", number)
        ends = [_point(seen, mechanism, entry, link, place) for place, link in enumerate(links, start=1)]
        numbers = (seen.real(entry, name) for name in ("stiffness", "free_length", "damping"))
        first, second = (mechanism.links[link] for link in links)
        found.append(Spring(seen.text(entry, "name"), first, ends[0], second, ends[1], *numbers))
    return tuple(found)


def read_joint_springs(seen: Seen, mechanism: Mechanism) -> tuple[JointSpring, ...]:
    """Return the springs on coordinates; raises `ImpossibleError` where a coordinate is not there."""
    first = np.concatenate([[0], np.cumsum([one.type.freedoms for one in mechanism.moved])]).tolist()
    found = []
    for number, entry in enumerate(seen.extent("joint_spring")):
        pair, place = seen.ref(entry, "pair"), seen.integer(entry, "coordinate")
        joint = mechanism.pairs.get(pair)
        if joint is None or not 1 <= place <= mechanism.moved[joint].type.freedoms:
            raise seen.impossible(entry, f"{seen.called(pair)} has no coordinate {place} in this mechanism")
        seen.take(entry, "joint spring", number)
        numbers = (seen.real(entry, name) for name in ("stiffness", "rest", "damping"))
        found.append(JointSpring(seen.text(entry, "name"), int(first[joint]) + place - 1, *numbers))
    return tuple(found)


def _point(seen: Seen, mechanism: Mechanism, entry: int, link: int, place: int) -> Array:
    """Return an end of a spring in the frame of the joint that moves its link [m]."""
    point, X_JL = np.array(seen.reals(entry, f"point_{place}")), mechanism.frames[link]
    return point if X_JL.is_identity else np.asarray(X_JL.rotation() @ point + X_JL.position)
