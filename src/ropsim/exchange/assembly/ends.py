"""Ends of the arms of a tree: where the axes end, or branch into the fingers of a hand."""

from collections.abc import Mapping, Sequence

from ropsim.core import frozen_dataclass
from ropsim.exchange.assembly.description import Body, Connection, Motion
from ropsim.exchange.assembly.last_frames import last_frames
from ropsim.exchange.assembly.link_tree import LinkTree

MOST_FINGER_AXES = 4
"""Axes of a finger at most, one behind the other."""
MOST_HAND_AXES = 8
"""The same of a hand with three fingers or more, whose files have axes without extent between the joints."""
_HAND_FINGERS = 3
_LONG = 2  # axes of a chain from which on connections without axes next to it are rods, not fingers
_LEAST_ARM_AXES = 3  # before a single finger
_FINGERS = ("finger", "gripper", "jaw", "claw")


@frozen_dataclass
class End:
    """An end of an arm.

    Attributes:
        body: the link there.
        is_hand: whether axes behind it are fingers.
    """

    body: str
    is_hand: bool = False


@frozen_dataclass
class _Groups:
    """Links that are fixed to each other, named by the one that a joint moves, or the root.

    Attributes:
        of: group of each body.
        moving: connections that move out of a group, in the order of the tree.
        before: axes before each group.
        behind: most axes in a row behind each moving connection, with its own, by its name.
        bodies: names of the bodies of each group.
    """

    of: Mapping[str, str]
    moving: Mapping[str, tuple[Connection, ...]]
    before: Mapping[str, int]
    behind: Mapping[str, int]
    bodies: Mapping[str, tuple[str, ...]]


def ends_of(tree: LinkTree, bodies: Mapping[str, Body]) -> tuple[End, ...]:
    """Return the ends of the arms of a tree that have most axes; several where they are alike.

    From the root the way goes on where most axes follow. It ends at the last link, and at the link behind
    which axes branch into fingers: chains of a few axes each, no more of them than the arm has before.
    Joints that follow axes nearer to the root are rods of the arm and no fingers. Behind the last link it is
    the frame of the interface, see `last_frames`.

    Args:
        tree: of the file.
        bodies: of the file, by name.
    """
    groups = _groups(tree)
    found, waiting = [], [tree.root]
    while waiting:
        group = waiting.pop()
        moving = groups.moving.get(group, ())
        fingers = _fingers(moving, group, groups, tree)
        if fingers:
            found.append(End(last_carrier([one.parent for one in fingers], tree), is_hand=True))
            continue
        most = max((groups.behind[one.name] for one in moving), default=0)
        onward = [one for one in moving if groups.behind[one.name] == most]
        if not onward or (most == 0 and len(onward) > 1):
            carrying = {one.parent for one in moving}
            fixed = [one for one in groups.bodies[group] if one == group or one not in carrying]
            names = last_frames(group, fixed, tree, bodies) if groups.before[group] else (group,)
            found += [End(name) for name in names]
        else:
            waiting += [one.child for one in reversed(onward)]
    return tuple(found)


def axes_before(tree: LinkTree, body: str) -> int:
    """Return how many axes move a body."""
    return sum(map(_is_axis, tree.way(body)))


def _is_axis(one: Connection) -> bool:
    return one.motion is not Motion.NONE and one.following is None


def _groups(tree: LinkTree) -> _Groups:
    of, before = {tree.root: tree.root}, {tree.root: 0}
    moving: dict[str, list[Connection]] = {}
    bodies: dict[str, list[str]] = {tree.root: [tree.root]}
    for one in tree.order:
        if one.motion is Motion.NONE:
            of[one.child] = of[one.parent]
        else:
            of[one.child] = one.child
            before[one.child] = before[of[one.parent]] + _is_axis(one)
            moving.setdefault(of[one.parent], []).append(one)
        bodies.setdefault(of[one.child], []).append(one.child)
    behind: dict[str, int] = {}
    for one in reversed(tree.order):
        if one.motion is not Motion.NONE:
            further = max((behind[next_.name] for next_ in moving.get(one.child, ())), default=0)
            behind[one.name] = further + _is_axis(one)
    return _Groups(
        of,
        {group: tuple(some) for group, some in moving.items()},
        before,
        behind,
        {group: tuple(names) for group, names in bodies.items()},
    )


def _fingers(
    moving: tuple[Connection, ...], group: str, groups: _Groups, tree: LinkTree
) -> tuple[Connection, ...]:
    """Return the connections of a group that carry fingers; none where it goes on as an arm."""
    nearer = {one.name for one in tree.way(group)}
    rods = [one for one in moving if one.following and any(name in nearer for name, _ in one.following.terms)]
    axes = groups.before[group]
    longest = max((groups.behind[one.name] for one in moving), default=0)
    least = 0 if longest < _LONG else 1
    fingers = tuple(one for one in moving if one not in rods and groups.behind[one.name] >= least)
    is_hand = len([one for one in fingers if groups.behind[one.name] == longest]) >= _HAND_FINGERS
    most = MOST_HAND_AXES if is_hand else MOST_FINGER_AXES
    if any(groups.behind[one.name] for one in rods) or not axes or longest > min(most, axes):
        return ()
    if len(fingers) > 1:
        return fingers
    is_single = len(fingers) == 1 and longest == 1 and axes >= _LEAST_ARM_AXES
    return fingers if is_single and _is_called_finger(fingers[0]) else ()


def _is_called_finger(one: Connection) -> bool:
    names = f"{one.name} {one.child}".lower()
    return any(word in names for word in _FINGERS)


def last_carrier(links: Sequence[str], tree: LinkTree) -> str:
    """Return the last link that carries all of some links, or is one of them and carries the others."""
    ways = [[tree.root, *(one.child for one in tree.way(link))] for link in links]
    shared = tree.root
    for bodies in zip(*ways, strict=False):
        if len(set(bodies)) > 1:
            break
        shared = bodies[0]
    return shared
