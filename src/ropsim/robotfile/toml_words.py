"""Values as TOML text: numbers in the units of a robot file, poses, strings, inline tables."""

import json
from collections.abc import Iterable
from math import degrees, isinf, tau

import numpy as np

from ropsim.model import WITHOUT_END, JointType
from ropsim.spatial import Pose, quaternion

_ROUNDED = 9  # digits behind the point, of millimetres and degrees
_DIGITS = 13  # of rates; slow rates also keep them
_UNIT = 14  # digits behind the point, of entries of quaternions
_TRIES = 8  # until the digits of a quaternion are those of its direction
_TURN = 12  # digits behind the point, of turns
_TWO_TURNS = 2.0 * tau  # [rad]; limits beyond them are counted in turns
_SAME = 1e-12  # [m, entries of a quaternion]


def number(value: float) -> str:
    """Return a number with the digits that it needs to be read as the same one."""
    return repr(float(value) + 0.0).removesuffix(".0")


def length(value: float) -> str:
    """Return a length [m] in millimetres; rounding errors are no digits of a drawing."""
    return number(round(1e3 * value, _ROUNDED))


def coordinate(value: float, type_: JointType) -> str:
    """Return a coordinate of a joint [rad | m] in degrees or millimetres."""
    return length(value) if type_ is JointType.PRISMATIC else number(round(degrees(value), _ROUNDED))


def rate(value: float, type_: JointType) -> str:
    """Return a derivative of a coordinate, such as a speed [rad/s | m/s], in degrees or millimetres."""
    shown = 1e3 * value if type_ is JointType.PRISMATIC else degrees(value)
    return number(float(f"{shown:.{_DIGITS}g}"))


def range_text(lower: float, upper: float, type_: JointType) -> str:
    """Return the limits of a joint [rad | m]: two coordinates, or turns where there are many of them."""
    if type_ is JointType.REVOLUTE and max(-lower, upper) > _TWO_TURNS:
        if (lower, upper) == (-WITHOUT_END, WITHOUT_END):
            return text("endless")
        return inline({"turns": row(number(round(value / tau, _TURN)) for value in (lower, upper))})
    return row(coordinate(value, type_) for value in (lower, upper))


def text(value: str) -> str:
    """Return a string in quotation marks."""
    return json.dumps(value, ensure_ascii=False)


def row(values: Iterable[str]) -> str:
    """Return a list."""
    return f"[{', '.join(values)}]"


def pose_keys(pose: Pose) -> dict[str, str]:
    """Return the keys of a pose; none if it is that of the surrounding frame."""
    keys = {}
    if np.abs(pose.position).max() > _SAME:
        keys["position"] = row(map(length, pose.position.tolist()))
    if np.abs(pose.orientation[1:]).max() > _SAME:
        keys["quaternion"] = row(map(number, _rounded(pose.orientation.tolist())))
    return keys


def _rounded(orientation: list[float]) -> list[float]:
    """Return a unit quaternion with so many digits that reading it gives these digits again."""
    found = [round(one, _UNIT) for one in orientation]
    for _ in range(_TRIES):
        w, x, y, z = found
        again = [round(one, _UNIT) for one in quaternion.normalize((w, x, y, z))]
        if again == found:
            break
        found = again
    return found


def inline(keys: dict[str, str]) -> str:
    """Return an inline table; keys without a value are left out."""
    return f"{{ {', '.join(f'{key} = {value}' for key, value in keys.items() if value)} }}"


def lines(keys: dict[str, str]) -> str:
    """Return keys with their values, one to a line; keys without a value are left out."""
    return "".join(f"{key} = {value}\n" for key, value in keys.items() if value)


def unless(value: float, default: float) -> str:
    """Return a number; nothing where it is the one that holds without it, or is infinite."""
    return "" if value == default or isinf(value) else number(value)
