"""Attributes of MJCF that need no report of their own; all others are reported by name.

Some are read, some change neither motion nor weight, and attributes for the control of actuators are reported
with the actuators. The check covers the settings, defaults, assets, bodies and actuators of a file.
"""

from collections.abc import Mapping
from types import MappingProxyType

from ropsim.exchange.files.unread import UNREAD, UNREAD_MOTION, note_unread, unread
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_DRIVE
from ropsim.exchange.losses.notes import Notes

GENERAL = "general"
ACTUATORS = frozenset(
    (
        *(GENERAL, "motor", "position", "velocity", "intvelocity", "orientation", "pid", "damper"),
        *("cylinder", "muscle", "adhesion", "dcmotor", "plugin"),
    )
)
"""Actuators; they are ways to write `general`, whose defaults they have and set (XML reference)."""


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
_ACTUATOR = _names("""
joint jointinparent tendon site refsite slidersite cranksite cranklength body gear ctrllimited ctrlrange
forcelimited forcerange lengthrange delay interp nsample
""")
_CONTROL = _names("""
actdim actlimited actrange actearly dyntype dynprm gaintype gainprm biastype biasprm inheritrange input kp kv
ki dampratio timeconst imax posrange velrange ffrange slewmax area diameter bias gain force fpmax fvmax lmax
lmin range scale tausmooth vmax cogging controller inductance lugre motorconst nominal resistance saturation
thermal plugin instance
""")
_MATERIAL = """
rgba texture texrepeat texuniform emission specular shininess reflectance metallic roughness
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
        "motor": _NAME | _ACTUATOR,
        **{kind: _NAME | _ACTUATOR | _CONTROL for kind in sorted(ACTUATORS - {"motor"})},
        "material": _NAME
        | _names(
            "rgba texture texrepeat texuniform emission specular shininess reflectance metallic roughness"
        ),
        "mesh": _NAME | _names("file scale content_type smoothnormal maxhullvert texcoord material inertia"),
    }
)
"""Attributes by element; other elements are not checked."""
_CHECKED = ("compiler", "default", "asset", "worldbody", "actuator")
_MOVING = _names(
    "joint/springdamper joint/actuatorgravcomp body/mocap geom/shellinertia mesh/refpos mesh/refquat"
) | {f"{kind}/{key}" for kind in ACTUATORS for key in ("armature", "damping")}
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
        for key in unread(one, known):
            moving = f"{one.name}/{key}" in _MOVING
            note_unread(one, key, UNREAD_MOTION if moving else UNREAD, notes)
