"""A linear track on the floor, which carries an arm."""

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
    PLATE,
    box_moments,
    rack_drive,
)
from ropsim.spatial import ALONG_X, translation

_HEIGHT = 0.35  # [m] of the carriage over the floor
_CARRIAGE = (0.9, 0.95, 0.09)  # [m]
_GAUGE = 0.35  # [m] from the middle to each bed


def linear_track(length: float, carriage_mass: float = 250.0, name: str = "linear_track") -> Mechanism:
    """Return a track on the floor along x of its base frame; the carriage stands in the middle of it at 0.

    Its frame of mounting, the frame of the link, lies on the carriage and has the axes of the base frame: a
    joint slides along its own z, so a fixed joint turns the frame back.

    Args:
        length: travel of the carriage [m], > 0.
        carriage_mass: [kg].
        name: of the mechanism.
    """
    half = length / 2.0
    limits = JointLimits(-half, half, 2.0, 3.0, 30.0, 12_000.0)
    beds = [
        Shape(Box((length + 1.0, 0.12, 0.2)), translation(0.0, side, 0.1), DARK_GREY)
        for side in (-_GAUGE, _GAUGE)
    ]
    rails = [
        Shape(Box((length + 1.0, 0.06, 0.06)), translation(0.0, side, 0.23), STEEL_GREY)
        for side in (-_GAUGE, _GAUGE)
    ]
    plate = Shape(Box(_CARRIAGE), translation(0.0, 0.0, -_CARRIAGE[2] / 2.0), PLATE)
    return Mechanism(
        name=name,
        title="Linear track",
        joints=(
            limited("1", JointType.PRISMATIC, translation(0.0, 0.0, _HEIGHT) @ ALONG_X, limits, BASE_LINK),
            limited("plate", JointType.FIXED, BACK, limits, 0),
        ),
        links=(
            Link(0.0, np.zeros(3), np.zeros((3, 3))),
            Link(carriage_mass, np.zeros(3), box_moments(carriage_mass, _CARRIAGE), (plate,)),
        ),
        drives=(rack_drive(limits.max_effort),),
        home=np.zeros(1),
        origins=ESTIMATE,
        base_shapes=(*beds, *rails),
    )
