"""Which joints of a tree the robot keeps: joints on the path to its tip, and joints coupled to them."""

from collections.abc import Mapping

from ropsim.core import Span, frozen_dataclass
from ropsim.exchange.assembly.description import Connection, Motion
from ropsim.exchange.assembly.link_tree import LinkTree
from ropsim.exchange.losses.diagnostics import BROKEN_TREE, JOINT_IMPOSSIBLE, UNKNOWN_ENTITY
from ropsim.exchange.losses.gathered import Topic, listed
from ropsim.exchange.losses.loss_diagnostics import LOST_MOTION
from ropsim.exchange.losses.notes import Notes
from ropsim.model import REQUEST

_RESTING = Topic(
    LOST_MOTION,
    "joints off the way to the tip",
    "joints {} are not on the way to the tip and stand still",
    "read the file once more for another tip where they are a robot of their own",
)


@frozen_dataclass
class KeptJoints:
    """Roles of the moving joints.

    Attributes:
        numbers: number of each joint of the robot, from 0, by the name of its connection.
        resting: coordinates at which the others stand still, by name [rad | m].
    """

    numbers: Mapping[str, int]
    resting: Mapping[str, float]


def kept_joints(tree: LinkTree, tip: str, span: Span, notes: Notes) -> KeptJoints | None:
    """Return the roles of the joints of a tree; None if no robot can be made of them (noted).

    Kept are the joints on the way to the tip, the joints that these follow, and joints elsewhere that follow
    kept ones alone, as the rods of a palletizer do. All others rest at zero, or as near to it as they can.

    Args:
        tree: of the file.
        tip: name of the body that carries the interface.
        span: span of the file, for findings about all of it.
        notes: for errors and losses.
    """
    moving = {one.name: one for one in tree.order if one.motion is not Motion.NONE}
    if not _couplings_hold(moving, notes):
        return None
    kept = {one.name for one in tree.way(tip) if one.name in moving}
    if not kept:
        notes.add(
            JOINT_IMPOSSIBLE,
            span,
            f"no joint moves `{tip}`, the tip of the robot",
            "name another tip, or describe a joint that turns or slides",
            {REQUEST: ("tip",)},
        )
        return None
    _followed(moving, kept)
    for one in _followers_last(moving):
        if one.following and all(name in kept for name, _ in one.following.terms):
            kept.add(one.name)
    resting: dict[str, float] = {}
    for one in _followers_last(moving):
        if one.name not in kept:
            resting[one.name] = _rest(one, resting)
    if resting:
        notes.gather(_RESTING, moving[next(iter(resting))].span, resting)
    names = [one.name for one in tree.order if one.name in kept]
    return KeptJoints({name: number for number, name in enumerate(names)}, resting)


def _couplings_hold(moving: Mapping[str, Connection], notes: Notes) -> bool:
    """Return whether joints follow joints that are there, and none itself."""
    right = True
    for one in moving.values():
        for name, _ in one.following.terms if one.following else ():
            if name not in moving:
                notes.unknown(UNKNOWN_ENTITY, one.span, f"joint `{one.name}` follows joint", name, moving)
                right = False
    if right and len(_followers_last(moving)) < len(moving):
        reached = {one.name for one in _followers_last(moving)}
        left = [one for one in moving.values() if one.name not in reached]
        words = f"joints follow each other in a circle: {listed(one.name for one in left)}"
        notes.add(BROKEN_TREE, left[0].span, words, "let one of them be driven")
        right = False
    return right


def _followers_last(moving: Mapping[str, Connection]) -> list[Connection]:
    """Return the joints, each behind the joints that it follows; joints of a circle are missing."""
    done: dict[str, Connection] = {name: one for name, one in moving.items() if one.following is None}
    for _ in range(len(moving)):  # each round adds the followers of present joints
        new = {
            name: one
            for name, one in moving.items()
            if name not in done and one.following and all(other in done for other, _ in one.following.terms)
        }
        if not new:
            break
        done |= new
    return list(done.values())


def _followed(moving: Mapping[str, Connection], kept: set[str]) -> None:
    """Take in the joints that kept ones follow."""
    waiting = list(kept)
    while waiting:
        following = moving[waiting.pop()].following
        for name, _ in following.terms if following else ():
            if name not in kept:
                kept.add(name)
                waiting.append(name)


def _rest(one: Connection, resting: Mapping[str, float]) -> float:
    if one.following and all(name in resting for name, _ in one.following.terms):
        return one.following.constant + sum(factor * resting[name] for name, factor in one.following.terms)
    return min(max(0.0, one.limits.lower), one.limits.upper)
