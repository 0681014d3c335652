"""A turntable, a positioner of one axis."""

from math import pi

import numpy as np

from ropsim.model import (
    BASE_LINK,
    DARK_GREY,
    Box,
    JointLimits,
    JointType,
    Link,
    Mechanism,
    Revolve,
    Shape,
    limited,
)
from ropsim.robots.external_axes.elements import ACCENT, ESTIMATE, PLATE, drive
from ropsim.spatial import Pose, translation

THICK = 0.05
"""Of a plate [m]."""
TURN = JointLimits(-2.0 * pi, 2.0 * pi, 2.0, 4.0, 40.0, 600.0)
"""Of its axis."""
TURNING = drive(120.0, 2e-3, 8.0, 1e-3, 0.1)
"""Its drive."""


def plate(radius: float, inertia: float) -> Link:
    """Return a round plate that turns about z of its frame, which lies in the middle on top.

    Args:
        radius: [m], > 0.
        inertia: of plate and load about the axis [kg·m²].
    """
    mass = 2.0 * inertia / radius**2  # of a disc
    disc = Revolve(((0.0, -THICK), (radius, -THICK), (radius, 0.0), (0.0, 0.0)))
    mark = Shape(Box((0.25 * radius, 0.03, 0.004)), translation(0.8 * radius, 0.0, 0.001), ACCENT)
    moments = np.diag([inertia / 2.0, inertia / 2.0, inertia])
    return Link(mass, np.array([0.0, 0.0, -THICK / 2.0]), moments, (Shape(disc, Pose(), PLATE), mark))


def turntable(
    radius: float, height: float = 0.7, inertia: float = 40.0, name: str = "turntable"
) -> Mechanism:
    """Return a table that turns about z of its base frame; the frame of its link lies in the middle on top.

    Args:
        radius: of the plate [m], > 0.
        height: of its upper side over the floor [m].
        inertia: of plate and load about the axis [kg·m²].
        name: of the mechanism.
    """
    post = Revolve(((0.0, 0.0), (0.6 * radius, 0.0), (0.6 * radius, 0.04), (0.3 * radius, height - THICK)))
    return Mechanism(
        name=name,
        title="Turntable",
        joints=(limited("1", JointType.REVOLUTE, translation(0.0, 0.0, height), TURN, BASE_LINK),),
        links=(plate(radius, inertia),),
        drives=(TURNING,),
        home=np.zeros(1),
        origins=ESTIMATE,
        base_shapes=(Shape(post, Pose(), DARK_GREY),),
    )
