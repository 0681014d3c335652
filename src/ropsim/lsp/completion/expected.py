"""Expected type of value at a place of a line, and type of a name of the text."""

import re
from collections.abc import Mapping

from ropsim.language import Role, TaskForm
from ropsim.lsp.analysis.names import Known
from ropsim.lsp.completion.call_place import call_place

#: A literal of each type, as it may be typed and changed.
LITERALS: Mapping[str, tuple[str, ...]] = {
    "length": ("10 mm", "1 cm", "0.1 m"),
    "angle": ("90 deg", "1 rad"),
    "time": ("1 s", "100 ms"),
    "speed": ("100 mm/s", "0.5 m/s"),
    "accel": ("500 mm/s2", "1 m/s2"),
    "force": ("10 N",),
    "share": ("50 %", "100 %"),
    "bool": ("true", "false"),
}

#: The units of each kind of number.
UNITS_OF: Mapping[str, tuple[str, ...]] = {
    "length": ("mm", "cm", "m", "inch"),
    "angle": ("deg", "rad"),
    "time": ("s", "ms", "min"),
    "speed": ("mm/s", "m/s", "cm/s"),
    "angular speed": ("deg/s", "rad/s"),
    "accel": ("mm/s2", "m/s2", "cm/s2"),
    "force": ("N",),
    "share": ("%",),
}

_JOINT_VERB = r"^\s*(?:\d+\.\s*)?movj?"
_VERB = r"(?:mov[jlc]?|lin|circ|spline)"
_GUARDED = rf"^\s*(?:\d+\.\s*)?{_VERB}\b.*\buntil\s+(?:not\s+)?\w+\s*"

# Type that the word before a place expects; a `target` is a location or joint coordinates.
_AFTER = tuple(
    (re.compile(pattern, re.IGNORECASE), type_)
    for pattern, type_ in (
        (rf"{_JOINT_VERB}\s+(?:to\s+)?$|{_JOINT_VERB}\s+via\s+(?:[^;(]*(?:,|\bto)\s+)?$", "target"),
        (r"^\s*loc\s+\w+\s*:?=\s*$", "target"),
        (rf"^\s*(?:\d+\.\s*)?{_VERB}\s+(?:to\s+)?$", "loc"),
        (r"^\s*pattern\b.*(?:\bgrid|\bx)\s+$", "count"),
        (rf"{_GUARDED}[<>]\s*$", "num"),
        (rf"{_GUARDED}(?:==?|<>)\s*$", "bool"),
        (r"\blike\s+$|\bfrom\s+$", "loc"),
        (r"\bvia\s+$|^(?=.*\bvia\b).*(?:,|\bto)\s+$|^\s*spline\b[^(]*,\s*$", "loc"),
        (r"\bjoints\s*\([^()]*$|\([^()]*;[^()]*$", "angle"),
        (rf"\b(?:{_VERB}|via|to|offset|rel|step)\s*\([^()]*$", "length"),
        (r"\b(?:above|blend|at)\s+$|\btrack\s+\w+\s*=\s*$", "length"),
        (r"\bdist\s*\((?:[^()]*,\s*)?$", "loc"),
        (r"\bgain\s+$|^\s*repeat\s+$|^\s*for\b.*(?:=|\bto|\bstep)\s+$", "num"),
        (r"^\s*wait\s+$|\btimeout\s+$", "time"),
        (r"\buntil\s+$|^\s*(?:if|elseif|while)\s+$|\b(?:and|or|not)\s+$", "bool"),
        (rf"{_JOINT_VERB}\b.*\b(?:speed|acc)\s+$", "share"),
        (r"\bspeed\s+$", "speed"),
        (r"\bacc\s+$", "accel"),
        (r"\b(?:rx|ry|rz|pitch|roll|yaw|angle)\s+$", "angle"),
    )
)
_TYPED = re.compile(r"^\s*(?:const|var)\s+\w+\s*:\s*([a-z]+)\s*:?=\s*$", re.IGNORECASE | re.ASCII)
_DECLARED = r"\b{name}\s*:\s*([a-z]+)"
_VALUE = re.compile(r"=\s*-?[\d.]+\s*([A-Za-z]+(?:/[A-Za-z]+\d?)?|°)?", re.ASCII)
_JOINTS = re.compile(r"=\s*joints\b", re.IGNORECASE)
_ANALOG = re.compile(r"\banalog\b", re.IGNORECASE)
_UNITS = {"°": "angle", **{unit: type_ for type_, units in UNITS_OF.items() for unit in units}}
_BY_ROLE = {Role.LOCATION: "loc", Role.SIGNAL: "bool"}


def in_call(prefix: str, tasks: Mapping[str, TaskForm]) -> str:
    """Return the type of the parameter at the end of a line, empty outside of calls of tasks.

    Args:
        prefix: the line up to the word that is being typed.
        tasks: how each task is called.
    """
    place = call_place(prefix, tasks)
    if place is None or place.is_inner or place.typed:  # in a location or function, or behind a value
        return ""
    return place.parameter.type if place.parameter is not None else ""


def expected(prefix: str, tasks: Mapping[str, TaskForm]) -> str:
    """Return the type that is expected at the end of a line, empty if any is allowed."""
    typed = _TYPED.match(prefix)
    if typed is not None:
        return typed[1].lower()
    return in_call(prefix, tasks) or next((type_ for pattern, type_ in _AFTER if pattern.search(prefix)), "")


def type_of(known: Known) -> str:
    """Return the type of a name, empty if the text does not determine it."""
    if known.type:
        return known.type
    if known.role is Role.LOCATION and _JOINTS.search(known.text):
        return "joints"
    if known.role is Role.SIGNAL and _ANALOG.search(known.text):
        return "num"
    if known.role in _BY_ROLE:
        return _BY_ROLE[known.role]
    declared = re.search(_DECLARED.format(name=re.escape(known.name)), known.text)
    if declared is not None:
        return declared[1]
    value = _VALUE.search(known.text)
    return _UNITS.get(value[1] or "", "num") if value is not None else ""


def may_give(wanted: str, type_: str) -> bool:
    """Return whether an expression with a name of a type can have the expected type; empty: any.

    Locations and joint coordinates are made of nothing else, truth values of comparisons, quantities of each
    other by arithmetic, counts (`count`) of plain numbers.
    """
    if wanted == "target":
        return type_ in ("loc", "joints", "")
    if wanted in ("loc", "joints"):
        return type_ in (wanted, "")
    if wanted == "count":
        return type_ in ("int", "num", "")
    return type_ not in ("loc", "joints", "bool", "str") or wanted in ("", "bool", type_)
