"""Equality constraints of MJCF: joints that follow others; the rest is reported as lost."""

from collections.abc import Sequence
from dataclasses import replace

from ropsim.exchange.assembly.description import Connection, Following
from ropsim.exchange.files.values import name_of, numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import UNKNOWN_ENTITY
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_MOTION
from ropsim.exchange.losses.notes import Notes

_OTHERS = Topic(LOST_MOTION, "constraints", "constraints {} do not go over")
_CURVED = Topic(
    LOST_MOTION,
    "polynomials",
    "joints {} follow by a polynomial: what is not linear in it does not go over",
)


def coupled(connections: Sequence[Connection], root: Element, notes: Notes) -> tuple[Connection, ...]:
    """Return connections with the couplings of their coordinates.

    A constraint of two joints says y - y0 = a0 + a1·(x - x0) + a2·(x - x0)² + …, with the coordinates y0, x0
    at which the joints have not moved their bodies; a constraint that is not linear is left out (noted).
    """
    found = {one.name: one for one in connections}
    held: dict[str, Following | None] = {}
    others: list[Element] = []
    for one in (part for equality in root.all("equality") for part in equality.children):
        if one.attributes.get("active", "true") == "false":
            continue
        name = name_of(one, notes, "joint1") if one.name == "joint" else None
        if name is None:
            others.append(one)
        elif name not in found:
            notes.unknown(UNKNOWN_ENTITY, one.span, "a constraint holds joint", name, found)
        else:
            held[name] = _following(one, found[name], found, notes)
    if others:
        notes.gather(_OTHERS, others[0].span, (one.name for one in others))
    return tuple(replace(one, following=held.get(one.name)) for one in connections)


def _following(
    constraint: Element, follower: Connection, known: dict[str, Connection], notes: Notes
) -> Following | None:
    a0, a1, *higher = numbers_of(constraint, "polycoef", notes, (0.0, 1.0, 0.0, 0.0, 0.0), least=2)
    if any(higher):
        notes.gather(_CURVED, constraint.span, [follower.name])
    other = constraint.attributes.get("joint2", "").strip()
    if not other:
        return Following((), follower.zero + a0)
    if other not in known:
        notes.unknown(UNKNOWN_ENTITY, constraint.span, f"joint `{follower.name}` follows joint", other, known)
        return None
    return Following(((other, a1),), follower.zero + a0 - a1 * known[other].zero)
