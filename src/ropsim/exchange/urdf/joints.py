"""Joints of URDF: types, axes, limits, friction and couplings."""

from dataclasses import replace

from ropsim.exchange.assembly.description import Connection, Following, Limits, Motion, Resistance
from ropsim.exchange.assembly.joint_limits import UNSAID
from ropsim.exchange.files.values import direction_of, name_of, number_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, ELEMENT_MISSING, JOINT_IMPOSSIBLE
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.loss_diagnostics import LOST_DRIVE
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.urdf.poses import origin_of
from ropsim.model import WITHOUT_END

MOTIONS = {
    "revolute": Motion.TURN,
    "continuous": Motion.TURN,
    "prismatic": Motion.SLIDE,
    "fixed": Motion.NONE,
}
_REFUSED = {
    "floating": "lets its child move about freely: an arm stands on its base",
    "planar": "has three freedoms that no single drive moves",
}
_LOST = tuple(
    Topic(LOST_DRIVE, key, f"the `{key}` of joints {{}} does not go over")
    for key in ("calibration", "safety_controller")
)
_FREE = Limits(-WITHOUT_END, WITHOUT_END)


def connection_of(joint: Element, notes: Notes) -> Connection | None:
    """Return the connection of a joint; nothing where it cannot be (noted)."""
    name, kind = name_of(joint, notes), name_of(joint, notes, "type")
    parent, child = _link(joint, "parent", notes), _link(joint, "child", notes)
    if name is None or kind is None or parent is None or child is None:
        return None
    if kind not in MOTIONS:
        why = _REFUSED.get(kind, "is of no type that there is")
        words = f"joint `{name}` of type `{shown(kind)}` {why}"
        notes.add(JOINT_IMPOSSIBLE, joint.span, words, f"allowed are {', '.join(MOTIONS)}")
        return None
    made = Connection(name, MOTIONS[kind], parent, child, origin_of(joint, notes), joint.span)
    if made.motion is Motion.NONE:
        return made
    axis = joint.first("axis")
    return replace(
        made,
        axis=direction_of(axis, "xyz", notes, (1.0, 0.0, 0.0)) if axis else (1.0, 0.0, 0.0),
        limits=_limits(joint, kind, notes),
        resistance=_resistance(joint, notes),
        following=_following(joint, notes),
    )


def _link(joint: Element, side: str, notes: Notes) -> str | None:
    element = joint.first(side)
    if element is None:
        words = f"joint `{joint.attributes.get('name', '')}` has no `{side}`"
        notes.add(ELEMENT_MISSING, joint.span, words, f'write <{side} link="..."/> into it')
        return None
    return name_of(element, notes, "link")


def _limits(joint: Element, kind: str, notes: Notes) -> Limits:
    limit, name = joint.first("limit"), joint.attributes["name"]
    if limit is None:
        return _FREE if kind == "continuous" else UNSAID
    lower, upper = number_of(limit, "lower", notes), number_of(limit, "upper", notes)
    if kind == "continuous":
        lower, upper = _FREE.lower, _FREE.upper
    elif lower > upper:
        unit = "m" if kind == "prismatic" else "rad"
        words = f"joint `{name}` has the lower limit {lower:g} {unit} and the upper limit {upper:g} {unit}"
        notes.add(BAD_NUMBER, limit.span, words, "the lower limit must be the smaller number")
        return _FREE
    return Limits(
        lower, upper, *(_most(limit, key, notes) for key in ("velocity", "acceleration", "jerk", "effort"))
    )


def _most(limit: Element, key: str, notes: Notes) -> float | None:
    """Return a greatest value; nothing where it is unknown, which many files write as 0."""
    value = number_of(limit, key, notes)
    if value < 0.0:
        words = f'a limit has {key}="{value:g}", allowed is a positive number, or 0 where it is unknown'
        notes.add(BAD_NUMBER, limit.span, words, "check the sign")
    return value if value > 0.0 else None


def _resistance(joint: Element, notes: Notes) -> Resistance:
    dynamics = joint.first("dynamics")
    if dynamics is None:
        return Resistance()
    viscous, dry = number_of(dynamics, "damping", notes), number_of(dynamics, "friction", notes)
    if min(viscous, dry) < 0.0:
        words = f"the friction of joint `{joint.attributes['name']}` is negative"
        notes.add(BAD_NUMBER, dynamics.span, words, "friction resists: check the sign")
    return Resistance(viscous, dry)


def _following(joint: Element, notes: Notes) -> Following | None:
    mimic = joint.first("mimic")
    name = name_of(mimic, notes, "joint") if mimic else None
    if mimic is None or name is None:
        return None
    factor = number_of(mimic, "multiplier", notes, 1.0)
    return Following(((name, factor),), number_of(mimic, "offset", notes))


def lost_of(joint: Element, notes: Notes) -> None:
    """Note the losses of a joint."""
    for topic in _LOST:
        element = joint.first(topic.what)
        if element is not None:
            notes.gather(topic, element.span, [joint.attributes.get("name", "")])
