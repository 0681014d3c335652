"""Links that are only a step between two joints: nothing of them is drawn or can collide."""

from ropsim.model.mechanism import Mechanism


def is_bare(mechanism: Mechanism, number: int) -> bool:
    """Return whether a link is only a step between two joints.

    Such a link has no shape and no mass, and other links of its mechanism have shapes. In a mechanism without
    any shape nothing is known of any link.

    Args:
        mechanism: an arm with its external axes, or a device.
        number: of the link, from 0.
    """
    links = mechanism.links
    if number >= len(links):
        return False
    own = links[number]
    return not own.shapes and not own.mass and any(link.shapes for link in links)
