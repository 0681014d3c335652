"""Bodies of a file become links of the robot: bodies fixed to each other become one."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ropsim.exchange.assembly.description import Body, Description, Motion
from ropsim.exchange.assembly.link_tree import LinkTree
from ropsim.exchange.files.names import BASE, FLANGE, link_name
from ropsim.exchange.losses.diagnostics import DOUBTFUL_BODY
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION
from ropsim.exchange.losses.notes import Notes, listed
from ropsim.model import BASE_LINK, Joint, Link, Payload, Shape, combine, moved
from ropsim.spatial import Pose

Carried = tuple[int, Pose]
"""Number of the joint on which a body rides, `BASE_LINK` for none, and the frame of the body in its frame."""

DENSEST = 100.0
"""No robot weighs more [kg] for each cubic metre of the cube over its length, that between all axes added up:
thirty published arms have 3 to 76, one whose file adds up to 4.9 t instead of 1.1 t has 108."""
_ALIKE = 4  # this number of links with one mass are placeholders
_SLACK = 1e-3  # relative, of A + B >= C: files round their moments
_SHORTEST = 0.05  # m, of a reach that says something


def links_of(
    bodies: Sequence[Body], placed: Mapping[str, Carried], count: int
) -> tuple[tuple[Link, ...], tuple[Shape, ...]]:
    """Return the links of a robot, and the shapes of its base.

    Args:
        bodies: of the file.
        placed: where each of them rides.
        count: of joints.
    """
    weights: list[list[Payload]] = [[] for _ in range(count)]
    shapes: list[list[Shape]] = [[] for _ in range(count + 1)]
    for body in bodies:
        carrier, X_CB = placed[body.name]
        shapes[carrier] += [replace(one, pose=X_CB @ one.pose) for one in body.shapes]
        if carrier != BASE_LINK and weighs(body.weight):
            weights[carrier].append(body.weight if X_CB.is_identity else moved(body.weight, X_CB))
    links = tuple(_link(own, looks) for own, looks in zip(weights, shapes, strict=False))
    return links, tuple(shapes[BASE_LINK])


def weighs(weight: Payload) -> bool:
    """Return whether a body has a mass or an inertia."""
    return bool(weight.mass or weight.inertia.any())


def _link(weights: list[Payload], shapes: list[Shape]) -> Link:
    if len(weights) == 1:
        (whole,) = weights
    elif any(one.mass for one in weights):
        whole = combine(tuple(weights))
    else:
        whole = Payload(
            inertia=np.sum([one.inertia for one in weights], axis=0) if weights else np.zeros((3, 3))
        )
    return Link(whole.mass, whole.com, (whole.inertia + whole.inertia.T) / 2.0, tuple(shapes))


def weight_findings(
    description: Description, joints: Sequence[Joint], links: Sequence[Link], interface: Pose, notes: Notes
) -> None:
    """Note masses and inertias that a robot of this size cannot have."""
    reach = sum(_length(joint.placement) for joint in joints[1:]) + _length(interface)
    for body in description.bodies:
        words = _doubt(body.weight, reach)
        if words:
            hint = "look its mass and inertia up, or leave them as they are"
            notes.add(DOUBTFUL_BODY, body.span, f"link `{body.name}` {words}", hint)
    light = [joint.name for joint, link in zip(joints, links, strict=True) if not link.mass]
    if light:
        words = f"no mass is moved by joint {listed(light)} itself"
        notes.add(DOUBTFUL_BODY, description.span, words, "give the links their masses: dynamics need them")
    masses = [link.mass for link in links if link.mass]
    total = sum(masses)
    if total > DENSEST * max(reach, _SHORTEST) ** 3:
        words = f"the links weigh {total:.4g} kg together, which is much for {reach:.3g} m of arm"
        notes.add(DOUBTFUL_BODY, description.span, words, "compare with the data sheet")
    if len(masses) >= _ALIKE and len(set(masses)) == 1:
        words = f"all {len(masses)} links have a mass of {masses[0]:g} kg"
        notes.add(
            DOUBTFUL_BODY, description.span, words, "these may be placeholders: compare with the data sheet"
        )


def _length(X: Pose) -> float:
    return float(np.linalg.norm(X.position))


def _doubt(weight: Payload, reach: float) -> str:
    moments = np.linalg.eigvalsh((weight.inertia + weight.inertia.T) / 2.0)
    a, b, c = moments.tolist()
    figures = f"has the moments of inertia {a:.4g}, {b:.4g}, {c:.4g} kg·m²"
    if a < 0.0 and abs(a) > _SLACK * c:
        return f"{figures}, those of a body are positive"
    if a + b < c * (1.0 - _SLACK):
        return f"{figures}, allowed for the last is {a + b:.4g}"
    if reach > _SHORTEST and c > weight.mass * reach**2 and weight.mass > 0.0:
        return f"{figures}: for {weight.mass:.4g} kg those of a body that is longer than the robot"
    return ""


def carried_names(
    description: Description, tree: LinkTree, placed: Mapping[str, Carried], tip: str, notes: Notes
) -> None:
    """Note links that become part of others, lost names, and the mass of fixed bodies."""
    fixed = [
        one.child
        for one in tree.order
        if one.motion is Motion.NONE and one.child != tip and placed[one.child][0] != BASE_LINK
    ]
    moving = [one for one in tree.order if one.motion is not Motion.NONE]
    renamed = [one.child for one in moving if one.child != link_name(one.name)]
    standing = [one for one in description.bodies if placed[one.name][0] == BASE_LINK]
    still = [one.name for one in standing]
    heavy = [one.name for one in standing if one.weight.mass]
    others = [name for name in still if name not in (BASE, tree.root)]
    rows = (
        (fixed, "become a part of the link that carries them, and their frames go"),
        (renamed, "are called after the joints that move them"),
        (others, "become a part of the base, and their frames go"),
        (heavy, "stand still: their weight goes"),
        (
            [tip] if tip not in (FLANGE, *(one.child for one in moving)) else [],
            "is called the mechanical interface",
        ),
    )
    for names, words in rows:
        if names:
            place = next(one.span for one in description.bodies if one.name == names[0])
            notes.add(LOST_DESCRIPTION, place, f"links {listed(names)} {words}", data={"links": tuple(names)})
