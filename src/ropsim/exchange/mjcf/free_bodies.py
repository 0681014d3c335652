"""Free bodies of MJCF, and the number of coordinates of joints, whose types classes may state."""

from collections.abc import Iterator

from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.mjcf.settings import Settings

_COORDINATES = {"free": 7, "ball": 4}
"""Number of coordinates by type of joint, else 1: a ball has a quaternion, a free joint also a position."""
Member = tuple[Element, str]
"""An element with the class that it inherits."""


def frees(joint: Element, inherited: str, settings: Settings) -> bool:
    """Return whether an element lets its body move about freely."""
    return _type_of(joint, inherited, settings) == "free"


def is_free(body: Element, inherited: str, settings: Settings) -> bool:
    """Return whether a body moves about freely.

    Args:
        body: of a file.
        inherited: class of the bodies around it.
        settings: of the file.
    """
    return any(frees(one, own, settings) for one, own in _own(body, inherited))


def free_base(world: Element, inherited: str, settings: Settings) -> Element | None:
    """Return the free body with the most joints, which is the base if no joint stands on a fixed one."""
    counts: list[tuple[int, Element]] = []
    for body, own in _own(world, inherited):
        if body.name != "body":
            continue
        types = [_type_of(*one, settings) for one in _descendants(body, own)]
        joints = sum(kind not in ("", "free") for kind in types)
        if joints and not is_free(body, own, settings):
            return None
        counts.append((joints, body))
    most = max((count for count, _ in counts), default=0)
    return next((body for count, body in counts if count == most), None) if most else None


def coordinates_of(joint: Element, inherited: str, settings: Settings) -> int:
    """Return how many coordinates an element has; zero where it is no joint."""
    kind = _type_of(joint, inherited, settings)
    return _COORDINATES.get(kind, 1) if kind else 0


def coordinates_below(body: Element, inherited: str, settings: Settings) -> int:
    """Return how many coordinates the joints of a body and of all bodies on it have."""
    return sum(coordinates_of(*one, settings) for one in _descendants(body, inherited))


def _type_of(joint: Element, inherited: str, settings: Settings) -> str:
    """Return the type of a joint; empty where the element is none."""
    if joint.name == "freejoint":
        return "free"
    if joint.name != "joint":
        return ""
    return settings.whole(joint, inherited).attributes.get("type", "hinge")


def _own(body: Element, inherited: str) -> Iterator[Member]:
    """Yield the elements of a body and of its frames, without the contents of its child bodies."""
    waiting = _children(body, inherited)
    while waiting:
        one, own = waiting.pop()
        if one.name == "frame":
            waiting += _children(one, own)
        else:
            yield one, own


def _descendants(element: Element, inherited: str) -> Iterator[Member]:
    waiting = [(element, inherited)]
    while waiting:
        one, own = waiting.pop()
        yield one, own
        waiting += _children(one, own)


def _children(element: Element, inherited: str) -> list[Member]:
    """Return the children of an element with their class, the first one last."""
    own = element.attributes.get("childclass", inherited)
    return [(one, own) for one in reversed(element.children)]
