"""Pairs of bodies of a cell that are checked, and reasons for omitted pairs."""

from collections.abc import Collection, Iterator, Mapping
from enum import StrEnum
from itertools import combinations

from ropsim.model import WORLD, Body, BodyKind, BodyTree, Strut, carrier
from ropsim.spatial import Pose

Pair = tuple[str, str]
"""Two names of bodies, in the order of the body tree."""
Elsewhere = Mapping[str, tuple[str, Pose]]
"""Parent and X_PB of the bodies that hang elsewhere than in the tree, by name."""


class LeftOut(StrEnum):
    """Reason why two bodies are not checked against each other."""

    FIXED = "nothing moves between them"
    NEIGHBOURS = "a joint is between them"
    GRIPPED = "one grips the other"
    AT_REST = "they are drawn into each other, as the rest position shows"


def left_out(tree: BodyTree, names: Collection[str], elsewhere: Elsewhere) -> dict[Pair, LeftOut]:
    """Return the pairs that touch by the way they are built or held, for all joint coordinates.

    - Bodies fixed to the same moving body, or to the world: a base and its pedestal, a part and its support,
      a tool and the flange, a gripper and the part that hangs on it.
    - Links of one mechanism with a joint between them; links without a shape in between do not count; barrel
      and rod of one cylinder.
    - Fingers, their tool, and the part that hangs on it.

    Args:
        tree: the bodies.
        names: names of bodies that have a shape and are present.
        elsewhere: attachments that differ from the tree.
    """
    bodies = tree.by_name()
    parents = {name: parent for name, (parent, _) in elsewhere.items()}
    carriers = {name: carrier(bodies, parents, name) for name in names}
    ordered = [body for body in tree.bodies if body.name in carriers]
    found: dict[Pair, LeftOut] = {}
    for one, other in combinations(ordered, 2):
        pair = one.name, other.name
        if carriers[one.name] == carriers[other.name]:
            found[pair] = LeftOut.FIXED
        elif _is_gripped(one, other, parents) or _is_gripped(other, one, parents):
            found[pair] = LeftOut.GRIPPED
        elif _slide(one, other):
            found[pair] = LeftOut.NEIGHBOURS
    for one in ordered:
        below = _shaped_below(bodies, names, one)
        if below is not None:
            found.setdefault((below, one.name), LeftOut.NEIGHBOURS)
    return found


def owners(tree: BodyTree, names: Collection[str]) -> dict[str, str]:
    """Return the mechanism of bases, links, tools and fingers, and of bodies attached to links, by name."""
    bodies = tree.by_name()
    first = [body for body in tree.bodies if body.mover and body.kind is not BodyKind.FINGER]
    bases = {body.parent: body.mover.mechanism for body in reversed(first) if body.mover}
    return {name: owner for name in names if (owner := _owner(bodies, bases, name))}


def _owner(bodies: Mapping[str, Body], bases: Mapping[str, str], name: str) -> str:
    """Return the mechanism of the next link above a body, or that begins at it; empty for none."""
    for body in _upward(bodies, name):
        if body.mover and body.kind is not BodyKind.FINGER:
            return body.mover.mechanism
    return bases.get(name, "")


def _is_gripped(finger: Body, other: Body, parents: Mapping[str, str]) -> bool:
    """Return whether one body is a finger, and the other its tool, another finger, or a body on the tool."""
    if finger.kind is not BodyKind.FINGER:
        return False
    tool = finger.parent
    return tool in (other.name, parents.get(other.name, other.parent))


def _slide(one: Body, other: Body) -> bool:
    """Return whether two bodies are barrel and rod of one cylinder."""
    a, b = one.mover, other.mover
    return isinstance(a, Strut) and isinstance(b, Strut) and (a.mechanism, a.joint) == (b.mechanism, b.joint)


def _shaped_below(bodies: Mapping[str, Body], names: Collection[str], link: Body) -> str | None:
    """Return the next link towards the base that has a shape, of the same mechanism; None for none."""
    if link.mover is None:
        return None
    mechanism, body = link.mover.mechanism, link
    while body.mover is not None and body.mover.mechanism == mechanism and body.parent != WORLD:
        body = bodies[body.parent]
        if body.name in names:
            return body.name
    return None


def _upward(bodies: Mapping[str, Body], name: str) -> Iterator[Body]:
    while name != WORLD:
        yield bodies[name]
        name = bodies[name].parent
