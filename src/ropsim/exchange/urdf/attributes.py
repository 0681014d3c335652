"""Elements and attributes of URDF that are read or say nothing of motion; all others are reported by name."""

from collections.abc import Mapping
from types import MappingProxyType

from ropsim.exchange.files.unread import UNREAD, UNREAD_DRIVE, UNREAD_MOTION, note_unread, unread
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION, LOST_DRIVE
from ropsim.exchange.losses.notes import Notes


def _names(text: str) -> frozenset[str]:
    return frozenset(text.split())


_NOTHING = _names("")
KNOWN: Mapping[str, tuple[frozenset[str], frozenset[str]]] = MappingProxyType(
    {
        "link": (_names("name type"), _names("inertial visual collision")),
        "joint": (
            _names("name type"),
            _names("parent child origin axis limit dynamics mimic calibration safety_controller"),
        ),
        "inertial": (_NOTHING, _names("origin mass inertia")),
        "origin": (_names("xyz rpy quat_xyzw"), _NOTHING),
        "mass": (_names("value"), _NOTHING),
        "inertia": (_names("ixx ixy ixz iyy iyz izz"), _NOTHING),
        "visual": (_names("name"), _names("origin geometry material")),
        "collision": (_names("name group"), _names("origin geometry verbose")),
        "geometry": (_NOTHING, _names("box cylinder sphere mesh")),
        "box": (_names("size"), _NOTHING),
        "cylinder": (_names("radius length"), _NOTHING),
        "sphere": (_names("radius"), _NOTHING),
        "mesh": (_names("filename scale"), _NOTHING),
        "material": (_names("name"), _names("color texture")),
        "color": (_names("rgba"), _NOTHING),
        "parent": (_names("link"), _NOTHING),
        "child": (_names("link"), _NOTHING),
        "axis": (_names("xyz rpy"), _NOTHING),
        "limit": (_names("lower upper effort velocity acceleration jerk"), _NOTHING),
        "dynamics": (_names("damping friction"), _NOTHING),
        "mimic": (_names("joint multiplier offset"), _NOTHING),
    }
)
"""Attributes and inner elements by element; the contents of other elements are not checked."""
_TOPICS: Mapping[str, Topic] = MappingProxyType(
    dict.fromkeys(_names("inertial origin mass inertia axis mimic"), UNREAD_MOTION)
    | dict.fromkeys(_names("limit dynamics"), UNREAD_DRIVE)
)
_OF_JOINTS = Topic(LOST_DRIVE, "elements of joints", "elements {} of joints do not go over")
_OF_LINKS = Topic(LOST_DESCRIPTION, "elements of links", "elements {} of links do not go over")


def check_attributes(root: Element, notes: Notes) -> None:
    """Note elements and attributes of links and joints that are not read, each kind once."""
    waiting = [one for one in reversed(root.children) if one.name in ("link", "joint", "material")]
    while waiting:
        one = waiting.pop()
        if one.name not in KNOWN:
            continue
        attributes, elements = KNOWN[one.name]
        for key in unread(one, attributes):
            note_unread(one, key, _TOPICS.get(one.name, UNREAD), notes)
        topic = _OF_JOINTS if one.name == "joint" else _OF_LINKS
        for inner in one.children:
            if inner.name not in elements and one.name != "geometry":  # geometry that is not drawn is named
                notes.gather(topic, inner.span, [inner.name])
        waiting += (inner for inner in reversed(one.children) if inner.name in elements)
