"""Attributes of MJCF that are read or change neither motion nor weight; all others are reported by name."""

from collections.abc import Mapping
from types import MappingProxyType

from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION, LOST_DRIVE, LOST_MOTION
from ropsim.exchange.losses.notes import Notes


def _names(text: str) -> frozenset[str]:
    return frozenset(text.split())


_PLACE = _names("pos quat axisangle euler zaxis xyaxes")
_NAME = _names("name class user group")
_CONTACT = _names("contype conaffinity condim priority friction solmix solref solimp margin gap")
_LOOK = _names("rgba material")
_COMPILER = """
angle eulerseq autolimits inertiafromgeom inertiagrouprange coordinate meshdir assetdir texturedir strippath
boundmass boundinertia balanceinertia settotalmass discardvisual fusestatic alignfree usethread saveinertial
fitaabb
"""
_JOINT = """
type pos axis range limited ref damping frictionloss armature stiffness springref actuatorfrcrange
actuatorfrclimited margin solreflimit solimplimit solreffriction solimpfriction
"""
KNOWN: Mapping[str, frozenset[str]] = MappingProxyType(
    {
        "compiler": _names(_COMPILER),
        "body": _PLACE | _NAME | _names("childclass gravcomp sleep"),
        "frame": _PLACE | _NAME | _names("childclass"),
        "inertial": _PLACE | _names("mass diaginertia fullinertia"),
        "joint": _NAME | _names(_JOINT),
        "freejoint": _NAME | _names("align"),
        "geom": _PLACE
        | _NAME
        | _CONTACT
        | _LOOK
        | _names("type size fromto mesh mass density hfield fitscale fluidshape fluidcoef"),
        "site": _PLACE | _NAME | _LOOK | _names("type size fromto"),
        "mesh": _NAME | _names("file scale content_type smoothnormal maxhullvert texcoord material inertia"),
    }
)
"""Attributes by element; elements that stand elsewhere are not checked."""
_CHECKED = ("compiler", "default", "asset", "worldbody")
_MOVING = _names(
    "joint/springdamper joint/actuatorgravcomp body/mocap geom/shellinertia mesh/refpos mesh/refquat"
)
_OTHERS = Topic(LOST_DESCRIPTION, "attributes", "attributes {} are not read")
_MOTION = Topic(
    LOST_MOTION,
    "attributes",
    "attributes {} are not read, but change motion or weight",
    "describe the robot without them",
)
_CARRIED = Topic(
    LOST_DRIVE,
    "weight compensation",
    "the file compensates the weight of bodies {} (`gravcomp`): here the drives carry it",
)


def check_attributes(root: Element, notes: Notes) -> None:
    """Note the attributes of a file that are not read, and the bodies whose weight the file compensates."""
    waiting = [one for one in reversed(root.children) if one.name in _CHECKED]
    while waiting:
        one = waiting.pop()
        waiting += reversed(one.children)
        if one.name == "body" and one.attributes.get("gravcomp", "0").strip() not in ("0", "0.0"):
            notes.gather(_CARRIED, one.span, [one.attributes.get("name", "without a name")])
        known = KNOWN.get(one.name)
        if known is None:
            continue
        for key in one.attributes:
            if key not in known:
                name = f"{one.name}/{key}"
                notes.gather(_MOTION if name in _MOVING else _OTHERS, one.span, [name])
