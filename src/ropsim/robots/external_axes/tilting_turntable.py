"""A tilting turntable, a positioner of two axes: tilt and turn."""

from math import pi

import numpy as np

from ropsim.model import (
    BASE_LINK,
    DARK_GREY,
    STEEL_GREY,
    Box,
    JointLimits,
    JointType,
    Link,
    Mechanism,
    Shape,
    limited,
)
from ropsim.robots.external_axes.elements import (
    BACK,
    ESTIMATE,
    box_moments,
    drive,
)
from ropsim.robots.external_axes.turntable import THICK, TURN, TURNING, plate
from ropsim.spatial import ALONG_X, translation

_ABOVE = 0.1  # [m] of the upper side of the plate over the axis of tilting
_WALL = 0.08  # [m]
_ROOM = 0.05  # [m] between plate and posts
_CRADLE_MASS = 90.0  # [kg]


def tilting_turntable(
    radius: float, height: float = 0.8, inertia: float = 40.0, name: str = "tilting_turntable"
) -> Mechanism:
    """Return a table that turns on a cradle, which tilts about x of the base frame.

    The axis of tilting lies 100 mm below the upper side of the plate. The frame of the last link lies in the
    middle on top of the plate; at 0 it has the axes of the base frame.

    Args:
        radius: of the plate [m], > 0.
        height: of its upper side over the floor at 0 [m].
        inertia: of plate and load about the axis of turning [kg·m²].
        name: of the mechanism.
    """
    tilt = JointLimits(-0.75 * pi, 0.75 * pi, 1.5, 3.0, 30.0, 3_000.0)
    reach = radius + _ROOM
    cradle = (2.0 * reach, 0.3, _WALL)
    X_cradle = BACK @ translation(0.0, 0.0, _ABOVE - THICK - _WALL / 2.0)
    moments = box_moments(_CRADLE_MASS, (cradle[2], cradle[1], cradle[0]))
    posts = [
        Shape(Box((_WALL, 0.35, height)), translation(side, 0.0, height / 2.0), DARK_GREY)
        for side in (-reach - _WALL / 2.0, reach + _WALL / 2.0)
    ]
    foot = Shape(Box((2.0 * (reach + _WALL), 0.5, 0.04)), translation(0.0, 0.0, 0.02), DARK_GREY)
    return Mechanism(
        name=name,
        title="Tilting turntable",
        joints=(
            limited(
                "1", JointType.REVOLUTE, translation(0.0, 0.0, height - _ABOVE) @ ALONG_X, tilt, BASE_LINK
            ),
            limited("2", JointType.REVOLUTE, BACK @ translation(0.0, 0.0, _ABOVE), TURN, 0),
        ),
        links=(
            Link(_CRADLE_MASS, X_cradle.position, moments, (Shape(Box(cradle), X_cradle, STEEL_GREY),)),
            plate(radius, inertia),
        ),
        drives=(drive(160.0, 3e-3, 25.0, 1e-3, 0.1), TURNING),
        home=np.zeros(2),
        origins=ESTIMATE,
        base_shapes=(*posts, foot),
    )
