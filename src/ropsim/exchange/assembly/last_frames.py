"""The interface among the frames that are fixed behind the last axis: flange, cameras, collision geometry."""

from collections.abc import Mapping, Sequence

import numpy as np

from ropsim.exchange.assembly.description import Body
from ropsim.exchange.assembly.hulls import hulls_of
from ropsim.exchange.assembly.link_tree import LinkTree
from ropsim.spatial import Array, Pose

LAST_NAMES = (
    "flange",
    "tool0",
    "ee_link",
    "end_effector_link",
    "end_effector",
    "eef",
    "tcp",
    "ee",
    "link_ee",
    "link8",
    "hand",
)
"""Names of the interface behind the last axis, with a prefix or without; the first one that occurs counts."""
_ASIDE = ("camera", "optical", "depth", "imu", "laser", "lidar", "sensor", "realsense")
_NEAREST = 1e-3  # m, of a frame at a distance from the last link
_ALONG = 0.999  # cosine between axes that are along each other


def last_frames(
    group: str, fixed: Sequence[str], tree: LinkTree, bodies: Mapping[str, Body]
) -> tuple[str, ...]:
    """Return the frames that can be the interface; several where they are equally good.

    The interface is the only end of the bodies that are fixed to the last link, if necessary counted
    without cameras, sensors and collision geometry (`hulls_of`); else a frame with a usual name; else an
    empty frame at a distance; else the last link itself.

    Args:
        group: name of the last link that an axis moves.
        fixed: names of the bodies that are fixed to it, its own among them.
        tree: of the file.
        bodies: of the file, by name.
    """
    hulls = hulls_of(bodies, tree)
    whole = _ends(fixed, group, tree)
    if len(whole) == 1 and whole[0] not in hulls:
        return whole
    left = _without_asides(fixed, group, tree, hulls)
    ends = _ends(left, group, tree)
    if len(ends) == 1:
        return ends
    for name in LAST_NAMES:
        named = tuple(one for one in left if one != group and _is_called(one, name))
        if named:
            return _upright(named, ends, group, tree, bodies) if len(named) == 1 else named
    empty = tuple(
        one for one in ends if _is_empty(bodies[one]) and _norm(_pose(group, one, tree).position) > _NEAREST
    )
    return empty or (group,)


def _upright(
    named: tuple[str, ...], ends: Sequence[str], group: str, tree: LinkTree, bodies: Mapping[str, Body]
) -> tuple[str, ...]:
    """Return a frame, or the empty ones at its place whose z axes are along the last axis if its own is not.

    The z axis of the mechanical interface points away from it (ISO 9787:2013).
    """
    place = _pose(group, named[0], tree).position
    axis = np.array(tree.above[group].axis)
    alike = [
        one
        for one in dict.fromkeys((*named, *ends))
        if _is_empty(bodies[one]) and _norm(_pose(group, one, tree).position - place) <= _NEAREST
    ]
    upright = tuple(one for one in alike if abs(axis @ _pose(group, one, tree).rotation()[:, 2]) > _ALONG)
    return named if named[0] in upright else upright or named


def _ends(names: Sequence[str], group: str, tree: LinkTree) -> tuple[str, ...]:
    """Return the bodies that carry none of the others."""
    carriers = {tree.above[one].parent for one in names if one != group}
    return tuple(one for one in names if one not in carriers)


def _without_asides(
    names: Sequence[str], group: str, tree: LinkTree, hulls: frozenset[str]
) -> tuple[str, ...]:
    """Return the bodies without cameras, sensors and hulls that carry nothing else."""
    left = tuple(names)
    while True:
        asides = {
            one
            for one in _ends(left, group, tree)
            if one != group and (one in hulls or any(word in one.lower() for word in _ASIDE))
        }
        if not asides:
            return left
        left = tuple(one for one in left if one not in asides)


def _is_called(body: str, name: str) -> bool:
    called = body.lower()
    return called == name or called.endswith(("_" + name, "/" + name, "-" + name))


def _is_empty(body: Body) -> bool:
    return not body.shapes and not body.weight.mass


def _norm(vector: Array) -> float:
    return float(np.linalg.norm(vector))


def _pose(group: str, body: str, tree: LinkTree) -> Pose:
    """Return the frame of a fixed body in that of its last link."""
    X = Pose()
    while body != group:
        X = tree.above[body].X_PC @ X
        body = tree.above[body].parent
    return X
