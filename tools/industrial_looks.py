"""What six-axis arms of industry look like: castings around their axes, sized by the radius of the shoulder.

A foot with a box for its cables carries a turret; beside that the upper arm is a slab from shoulder to elbow,
so that its motor stands on the other side. Behind the elbow are the motors of the wrist, before it a tube
that ends in a fork. Large arms have a cylinder behind the turret that holds against their weight.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import hypot
from typing import Any

import numpy as np

from ropsim.kinematics import joint_frames
from ropsim.model import Box, Cylinder, Prism, RobotModel, Shape, Solid, around, rod
from ropsim.spatial import Array, Pose, translation

_FOOT, _TURRET, _UPPER_ARM, _FOREARM, _TUBE, _WRIST, _FLANGE = range(7)
_TURNED = Pose.from_tuple((0.0, 0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5), 0.0, 0.0))  # z to the right, y up
_STEEL = "#9aa1a8"
_UP = np.array([0.0, 0.0, 1.0])
_LEFT = np.array([0.0, 1.0, 0.0])


@dataclass(frozen=True)
class _Skeleton:
    """Where the axes are with all coordinates 0, in the base frame [m].

    Attributes:
        shoulder: on axis 2, shape (3,).
        elbow: on axis 3, shape (3,).
        bend: on axis 4 beside the elbow, shape (3,).
        wrist: where axes 4, 5 and 6 meet, shape (3,).
        flange: origin of the interface, shape (3,).
        size: radius of the shoulder [m].
        tones: body, dark parts.
    """

    shoulder: Array
    elbow: Array
    bend: Array
    wrist: Array
    flange: Array
    size: float
    tones: tuple[str, str]


def industrial(robot: RobotModel, look: Mapping[str, Any]) -> list[list[Shape]]:
    """Return the shapes of base and links, each in the frame of its own.

    Args:
        robot: with six axes, those of the wrist through one point.
        look: `size` [mm], `tones`, and `counterweight` for a cylinder behind the turret.
    """
    every = joint_frames(robot, np.zeros(robot.n))
    frames = [*every[: robot.n], every[-1]]
    at = [np.asarray(X[:3, 3]) for X in frames]
    along = np.asarray(frames[3][:3, 2])
    bend = at[3] + along * float(along @ (at[2] - at[3]))
    body, dark = look["tones"]
    bones = _Skeleton(at[1], at[2], bend, at[4], at[6], 1e-3 * look["size"], (body, dark))
    parts = {
        _FOOT: _foot(bones),
        _TURRET: [*_turret(bones), *(_counterweight(bones) if look.get("counterweight") else [])],
        _UPPER_ARM: _upper_arm(bones),
        _FOREARM: _forearm(bones),
        _TUBE: _tube(bones),
        _WRIST: _wrist(bones),
        _FLANGE: _end(bones),
    }
    bodies = [Pose(), *(Pose.from_matrix(X) for X in frames)]
    return [[_moved(one, bodies[link].inverse()) for one in parts[link]] for link in range(robot.n + 1)]


def _deck(bones: _Skeleton) -> float:
    """Return where the foot ends and the turret begins [m]."""
    high = float(bones.shoulder[2])
    return max(0.38 * high, high - 2.6 * bones.size)


def _foot(bones: _Skeleton) -> list[Shape]:
    s, deck, (body, dark) = bones.size, _deck(bones), bones.tones
    box = (0.8 * s, 1.3 * s, 0.6 * deck)
    return [
        Shape(Box((2.9 * s, 2.7 * s, 0.14 * s)), translation(-0.1 * s, 0.0, 0.07 * s), dark),
        rod((0.0, 0.0, 0.14 * s), (0.0, 0.0, deck), 1.3 * s, 1.12 * s, body),
        Shape(Box(box), translation(-1.3 * s, 0.0, 0.14 * s + 0.5 * box[2]), body),
        Shape(
            Box((0.06 * s, 0.8 * s, 0.3 * deck)), translation(-1.72 * s, 0.0, 0.14 * s + 0.5 * box[2]), dark
        ),
    ]


def _turret(bones: _Skeleton) -> list[Shape]:
    s, deck, (body, dark) = bones.size, _deck(bones), bones.tones
    axis, x = bones.shoulder, float(bones.shoulder[0])
    low = np.array([0.0, 0.0, deck + 0.75 * s])
    back = np.array([-0.45 * s, 0.0, deck + 0.85 * s])
    return [
        rod((0.0, 0.0, deck), (0.0, 0.0, deck + 0.12 * s), 1.16 * s, None, dark),
        rod((0.0, 0.0, deck + 0.12 * s), (0.0, 0.0, deck + 0.45 * s), 1.2 * s, 1.05 * s, body),
        _slab(((low, 0.72 * s), (back, 0.6 * s), (axis, 0.85 * s)), -0.8 * s, 0.16 * s, body),
        rod(axis - 1.5 * s * _LEFT, axis - 0.8 * s * _LEFT, 0.46 * s, 0.58 * s, dark),
        rod((-0.6 * s, 0.3 * s, deck + 0.45 * s), (-0.6 * s, 0.3 * s, deck + 1.15 * s), 0.32 * s, None, dark),
        Shape(Box((max(x, 0.4 * s), 0.5 * s, 0.5 * s)), translation(0.5 * x, 0.35 * s, deck + 0.6 * s), body),
    ]


def _counterweight(bones: _Skeleton) -> list[Shape]:
    s, (_, dark) = bones.size, bones.tones
    front = bones.shoulder + np.array([0.2 * s, -0.3 * s, 0.62 * s])
    rear = bones.shoulder + np.array([-2.3 * s, -0.3 * s, 0.2 * s])
    neck = front + 0.25 * (rear - front)
    return [rod(front, neck, 0.16 * s, None, _STEEL), rod(neck, rear, 0.36 * s, None, dark)]


def _upper_arm(bones: _Skeleton) -> list[Shape]:
    s, (body, dark) = bones.size, bones.tones
    low, high = bones.shoulder, bones.elbow
    way = high - low
    slab = _slab(((low, 0.88 * s), (high, 0.6 * s)), 0.18 * s, 0.62 * s, body)
    rib = _slab(((low + 0.3 * way, 0.34 * s), (low + 0.78 * way, 0.26 * s)), 0.62 * s, 0.68 * s, dark)
    return [
        slab,
        rib,
        rod(low + 0.62 * s * _LEFT, low + 0.76 * s * _LEFT, 0.6 * s, 0.54 * s, dark),
        rod(high + 0.62 * s * _LEFT, high + 0.74 * s * _LEFT, 0.4 * s, 0.36 * s, dark),
    ]


def _forearm(bones: _Skeleton) -> list[Shape]:
    s, (body, dark) = bones.size, bones.tones
    ahead = _unit(bones.wrist - bones.bend)
    rear, front = bones.bend - 0.55 * s * ahead, bones.bend + 0.5 * s * ahead
    middle = bones.bend + 0.42 * (bones.wrist - bones.bend)
    housing = ((bones.elbow, 0.6 * s), (rear, 0.46 * s), (front, 0.46 * s))
    motors = [
        rod(
            rear + (0.2 * s) * ahead + side * s * _LEFT,
            rear - 0.75 * s * ahead + side * s * _LEFT,
            0.2 * s,
            None,
            dark,
        )
        for side in (-0.42, 0.02)
    ]
    return [
        _slab(housing, -0.66 * s, 0.16 * s, body),
        *motors,
        rod(bones.bend, middle, 0.56 * s, 0.42 * s, body),
        rod(middle, middle + 0.1 * s * ahead, 0.44 * s, None, dark),
    ]


def _tube(bones: _Skeleton) -> list[Shape]:
    s, (body, dark) = bones.size, bones.tones
    ahead = _unit(bones.wrist - bones.bend)
    middle = bones.bend + 0.42 * (bones.wrist - bones.bend) + 0.1 * s * ahead
    neck = bones.wrist - 0.6 * s * ahead
    cheeks = [
        _slab(((bones.wrist, 0.3 * s), (neck, 0.33 * s)), low * s, (low + 0.16) * s, body)
        for low in (-0.4, 0.24)
    ]
    caps = [
        rod(bones.wrist + side * 0.4 * s * _LEFT, bones.wrist + side * 0.46 * s * _LEFT, 0.22 * s, None, dark)
        for side in (-1.0, 1.0)
    ]
    return [rod(middle, neck, 0.38 * s, 0.36 * s, body), *cheeks, *caps]


def _wrist(bones: _Skeleton) -> list[Shape]:
    s, (body, _) = bones.size, bones.tones
    ahead = bones.flange - bones.wrist
    return [
        rod(bones.wrist - 0.23 * s * _LEFT, bones.wrist + 0.23 * s * _LEFT, _slim(bones), None, body),
        rod(bones.wrist, bones.wrist + 0.72 * ahead, 0.92 * _slim(bones), None, body),
    ]


def _end(bones: _Skeleton) -> list[Shape]:
    start = bones.wrist + 0.72 * (bones.flange - bones.wrist)
    return [rod(start, bones.flange, _slim(bones), None, _STEEL)]


def _slim(bones: _Skeleton) -> float:
    """Return the radius of the wrist [m]: flanges of small arms are 40 mm wide (ISO 9409-1)."""
    return max(0.3 * bones.size, 0.021)


def _slab(circles: Sequence[tuple[Array, float]], low: float, high: float, colour: str) -> Shape:
    """Return a slab along y from `low` to `high` [m], around circles in the plane of x and z of the base."""
    outline = around([(float(place[0]), float(place[2]), radius) for place, radius in circles])
    short = dict.fromkeys((_short(x), _short(y)) for x, y in outline)
    return Shape(Prism(tuple(short), high - low), translation(0.0, high, 0.0) @ _TURNED, colour)


def _moved(shape: Shape, X_LB: Pose) -> Shape:
    """Return a shape of the base frame in the frame of a link."""
    X = np.round((X_LB @ shape.pose).matrix(), 9) + 0.0
    X[:3, 3] = np.round(X[:3, 3], 5) + 0.0
    return replace(shape, solid=_solid(shape.solid), pose=Pose.from_matrix(X))


def _solid(solid: Solid) -> Solid:
    match solid:
        case Cylinder():
            top = None if solid.top is None else _short(solid.top)
            return Cylinder(_short(solid.radius), _short(solid.length), top)
        case Box(size=(x, y, z)):
            return Box((_short(x), _short(y), _short(z)))
        case Prism():
            return Prism(solid.outline, _short(solid.length))
    return solid


def _short(length: float) -> float:
    """Return a length to a tenth of a millimetre: files stay short."""
    return round(length, 4)


def _unit(vector: Array) -> Array:
    return np.asarray(vector / hypot(*vector.tolist()))
