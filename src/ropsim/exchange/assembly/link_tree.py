"""The bodies of a description as a tree: its root, and its connections from there outwards."""

import heapq
from collections.abc import Mapping

from ropsim.core import frozen_dataclass
from ropsim.exchange.assembly.description import Connection, Description, Motion
from ropsim.exchange.losses.diagnostics import (
    BROKEN_TREE,
    ELEMENT_MISSING,
    JOINT_IMPOSSIBLE,
    SAME_ENTITY,
    UNKNOWN_ENTITY,
)
from ropsim.exchange.losses.gathered import listed
from ropsim.exchange.losses.notes import Notes

MOST_JOINTS = 200
"""Maximum number of moving joints of a robot file."""


@frozen_dataclass
class LinkTree:
    """The tree of a description.

    Attributes:
        root: name of the body that stands still.
        order: connections, each behind the one that moves its parent, otherwise as in the file.
        above: the connection that moves a body, by the name of the body; the root has no entry.
    """

    root: str
    order: tuple[Connection, ...]
    above: Mapping[str, Connection]

    def way(self, body: str) -> tuple[Connection, ...]:
        """Return the connections from the root to a body, in order."""
        found = []
        while body != self.root:
            found.append(self.above[body])
            body = self.above[body].parent
        return tuple(reversed(found))


def link_tree(description: Description, notes: Notes) -> LinkTree | None:
    """Return the tree of a description; None if its links do not form a single tree (noted)."""
    bodies = {one.name: one for one in description.bodies}
    if not bodies:
        notes.add(ELEMENT_MISSING, description.span, "the file has no links", "describe at least two")
        return None
    _names(description, notes)
    above: dict[str, Connection] = {}
    for one in description.connections:
        for side, name in (("parent", one.parent), ("child", one.child)):
            if name not in bodies:
                notes.unknown(UNKNOWN_ENTITY, one.span, f"joint `{one.name}` has the {side}", name, bodies)
        if one.child in above:
            notes.add(
                BROKEN_TREE,
                one.span,
                f"link `{one.child}` is moved by joint `{one.name}` and by joint `{above[one.child].name}`",
                "each link has one parent: cut the closed chain",
            )
        above[one.child] = one
    moving = sum(one.motion is not Motion.NONE for one in description.connections)
    if moving > MOST_JOINTS:
        words = f"the file has {moving} joints that move, allowed are {MOST_JOINTS}"
        notes.add(JOINT_IMPOSSIBLE, description.span, words, "cut it down to the robot")
    roots = [name for name in bodies if name not in above]
    if len(roots) > 1:
        notes.add(
            BROKEN_TREE,
            bodies[roots[1]].span,
            f"{len(roots)} links are the child of no joint: {listed(roots)}",
            "one of them is the base; join the others to it, or take them out",
        )
    if notes.fatal:
        return None
    order = _ordered(description, set(roots))
    if len(order) < len(description.connections):
        reached = {one.name for one in order}
        left = [one for one in description.connections if one.name not in reached]
        words = f"joints go in a circle: {listed(one.name for one in left)}"
        notes.add(BROKEN_TREE, left[0].span, words, "cut the closed chain")
        return None
    return LinkTree(roots[0], order, above)


def _names(description: Description, notes: Notes) -> None:
    for what, entities in (("links", description.bodies), ("joints", description.connections)):
        seen: set[str] = set()
        for one in entities:
            if one.name in seen:
                words = f"two {what} have the name `{one.name}`"
                notes.add(SAME_ENTITY, one.span, words, "give each its own name")
            seen.add(one.name)


def _ordered(description: Description, placed: set[str]) -> tuple[Connection, ...]:
    """Return the connections that can be reached from the placed bodies, parents first (Kahn 1962)."""
    waiting: dict[str, list[int]] = {}
    for number, one in enumerate(description.connections):
        waiting.setdefault(one.parent, []).append(number)
    ready = [number for body in placed for number in waiting.pop(body, ())]
    heapq.heapify(ready)
    order = []
    while ready:
        one = description.connections[heapq.heappop(ready)]
        order.append(one)
        for number in waiting.pop(one.child, ()):
            heapq.heappush(ready, number)
    return tuple(order)
