"""Bodies of a file become links of the robot: bodies fixed to each other become one."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ropsim.exchange.assembly.description import Body, Description, Motion
from ropsim.exchange.assembly.link_tree import LinkTree
from ropsim.exchange.files.names import BASE, FLANGE, link_name
from ropsim.exchange.losses.diagnostics import DOUBTFUL_BODY
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION
from ropsim.exchange.losses.notes import Notes
from ropsim.model import (
    BASE_LINK,
    Link,
    Payload,
    RobotModel,
    Shape,
    combine,
    heaviest,
    length_of,
    moved,
    one_mass,
)
from ropsim.spatial import Pose

Carried = tuple[int, Pose]
"""Number of the joint on which a body rides, `BASE_LINK` for none, and the frame of the body in its frame."""

_SLACK = 1e-3  # relative, of A + B >= C: files round their moments
_SHORTEST = 0.05  # m, of a reach that says something

_UP = "look mass and inertia up, or leave them as they are"
_NEGATIVE = Topic(
    DOUBTFUL_BODY,
    "negative moments",
    "links {} have negative moments of inertia, those of a body are positive",
    _UP,
)
_TRIANGLE = Topic(
    DOUBTFUL_BODY, "moments of no body", "no rigid body has the moments of inertia of links {}", _UP
)
_LONG = Topic(
    DOUBTFUL_BODY,
    "inertias too large",
    "the moments of inertia of links {} are those of bodies that are longer than the robot",
    _UP,
)
_MASSLESS = Topic(
    DOUBTFUL_BODY,
    "joints without mass",
    "no mass is moved by joints {} themselves",
    "give the links their masses: dynamics need them",
)
_HEAVY = Topic(DOUBTFUL_BODY, "heavy links", "the links are heavy for the arm", "compare with the data sheet")
_ONE_MASS = Topic(
    DOUBTFUL_BODY,
    "one mass for all links",
    "all links have one mass",
    "these may be placeholders: compare with the data sheet",
)
_FIXED = Topic(
    LOST_DESCRIPTION,
    "frames of fixed links",
    "links {} become a part of the link that carries them, and their frames go",
)
_RENAMED = Topic(LOST_DESCRIPTION, "names of links", "links {} are called after the joints that move them")
_STANDING = Topic(
    LOST_DESCRIPTION, "frames of the base", "links {} become a part of the base, and their frames go"
)
_WEIGHTS = Topic(LOST_DESCRIPTION, "weight of the base", "links {} stand still: their weight goes")
_TIP = Topic(LOST_DESCRIPTION, "name of the tip", "link {} is called the mechanical interface")


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


def weight_findings(description: Description, robot: RobotModel, notes: Notes) -> None:
    """Note masses and inertias that a robot of this size cannot have."""
    joints, links = robot.joints, robot.links
    reach = sum(_length(joint.placement) for joint in joints[1:]) + _length(robot.interface)
    for body in description.bodies:
        for topic, figures in _doubts(body.weight, reach):
            notes.gather(topic, body.span, [body.name], f"`{shown(body.name)}` has {figures}")
    light = [joint.name for joint, link in zip(joints, links, strict=True) if not link.mass]
    if light:
        notes.gather(_MASSLESS, description.span, light)
    total, length, alike = sum(link.mass for link in links), length_of(robot), one_mass(links)
    if total > heaviest(length):
        notes.gather(_HEAVY, description.span, (), f"{total:.4g} kg for {length:.3g} m of arm")
    if alike is not None:
        notes.gather(_ONE_MASS, description.span, (), f"{alike:g} kg for all that have a mass")


def _length(X: Pose) -> float:
    return float(np.linalg.norm(X.position))


def _doubts(weight: Payload, reach: float) -> Iterator[tuple[Topic, str]]:
    """Yield doubts about the moments of inertia of a body, with its figures."""
    moments = np.linalg.eigvalsh((weight.inertia + weight.inertia.T) / 2.0)
    a, b, c = moments.tolist()
    figures = f"{a:.4g}, {b:.4g}, {c:.4g} kg·m²"
    if a < 0.0 and abs(a) > _SLACK * c:
        yield _NEGATIVE, figures
    elif a + b < c * (1.0 - _SLACK):
        yield _TRIANGLE, f"{figures}, allowed for the last is {a + b:.4g}"
    elif reach > _SHORTEST and c > weight.mass * reach**2 and weight.mass > 0.0:
        yield _LONG, f"{figures} for {weight.mass:.4g} kg"


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
    ends = [tip] if tip not in (FLANGE, *(one.child for one in moving)) else []
    rows = ((_FIXED, fixed), (_RENAMED, renamed), (_STANDING, others), (_WEIGHTS, heavy), (_TIP, ends))
    for topic, names in rows:
        if names:
            place = next(one.span for one in description.bodies if one.name == names[0])
            notes.gather(topic, place, names)
