"""Links of a file that only carry collision geometry of the link they are fixed to, as for self-collision."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ropsim.exchange.assembly.description import Body, Connection, Description, Motion
from ropsim.exchange.assembly.link_tree import LinkTree
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION
from ropsim.exchange.losses.notes import Notes

_ROUNDING = 1e-6  # m, of a frame that is at the origin of its carrier
_UNDRAWN = Topic(
    LOST_DESCRIPTION,
    "collision geometry of its own link",
    "links {} are collision geometry around a link that is drawn, and neither drawn nor checked",
)


def hulls_of(bodies: Mapping[str, Body], tree: LinkTree) -> frozenset[str]:
    """Return the names of bodies that are collision geometry around the body that carries them.

    A hull has collision geometry only, and is fixed at the origin of a body with visual geometry.

    Args:
        bodies: of the file, by name.
        tree: of the file.
    """
    return frozenset(one.child for one in tree.order if _is_hull(one, bodies))


def without_hulls(description: Description, tree: LinkTree, notes: Notes) -> tuple[Body, ...]:
    """Return the bodies of a description with no shapes on hulls (noted); see `hulls_of`."""
    hulls = hulls_of({one.name: one for one in description.bodies}, tree)
    if not hulls:
        return description.bodies
    named = [one for one in description.bodies if one.name in hulls]
    notes.gather(_UNDRAWN, named[0].span, [one.name for one in named])
    return tuple(replace(one, shapes=()) if one.name in hulls else one for one in description.bodies)


def _is_hull(one: Connection, bodies: Mapping[str, Body]) -> bool:
    body, carrier = bodies[one.child], bodies[one.parent]
    return (
        one.motion is Motion.NONE
        and body.is_collision
        and bool(carrier.shapes)
        and not carrier.is_collision
        and float(np.linalg.norm(one.X_PC.position)) <= _ROUNDING
    )
