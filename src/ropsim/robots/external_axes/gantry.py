"""A gantry: a bridge that goes along two beams, with a trolley from which an arm hangs."""

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
from ropsim.spatial import ALONG_X, Pose, translation

_ACROSS = Pose(orientation=np.array([1.0, -1.0, 0.0, 0.0]))  # Rx(-90°): z of the joint points along y
_TROLLEY = (0.6, 0.6, 0.08)  # [m]
_BEAM, _COLUMN = 0.24, 0.25  # [m], edges of their sections
_OVER = 0.6  # [m] that beams and bridge are longer than the travel, at each end


def gantry(
    length: float,
    width: float,
    height: float,
    bridge_mass: float = 500.0,
    trolley_mass: float = 150.0,
    name: str = "gantry",
) -> Mechanism:
    """Return a gantry over the floor: its bridge goes along x of the base frame, the trolley on it along y.

    At 0 both are in the middle. The frame of mounting lies at the lower side of the trolley and has the axes
    of the base frame; an arm that hangs from it is turned about x by 180°.

    Args:
        length: travel of the bridge [m], > 0.
        width: travel of the trolley [m], > 0.
        height: of the lower side of the trolley over the floor [m].
        bridge_mass: [kg].
        trolley_mass: [kg].
        name: of the mechanism.
    """
    along = JointLimits(-length / 2.0, length / 2.0, 1.5, 2.0, 20.0, 12_000.0)
    across = JointLimits(-width / 2.0, width / 2.0, 1.5, 2.0, 20.0, 8_000.0)
    bridge = (_BEAM, width + 2.0 * _OVER, _BEAM)
    over = _TROLLEY[2] + _BEAM / 2.0
    return Mechanism(
        name=name,
        title="Gantry",
        joints=(
            limited("1", JointType.PRISMATIC, translation(0.0, 0.0, height) @ ALONG_X, along, BASE_LINK),
            limited("2", JointType.PRISMATIC, _ACROSS, across, 0),
            limited("plate", JointType.FIXED, (ALONG_X @ _ACROSS).inverse(), across, 1),
        ),
        links=(
            Link(
                bridge_mass,
                (BACK @ translation(0.0, 0.0, over)).position,
                box_moments(bridge_mass, (bridge[2], bridge[1], bridge[0])),
                (Shape(Box(bridge), BACK @ translation(0.0, 0.0, over), STEEL_GREY),),
            ),
            Link(0.0, np.zeros(3), np.zeros((3, 3))),
            Link(
                trolley_mass,
                np.array([0.0, 0.0, _TROLLEY[2] / 2.0]),
                box_moments(trolley_mass, _TROLLEY),
                (Shape(Box(_TROLLEY), translation(0.0, 0.0, _TROLLEY[2] / 2.0), PLATE),),
            ),
        ),
        drives=(rack_drive(along.max_effort), rack_drive(across.max_effort)),
        home=np.zeros(2),
        origins=ESTIMATE,
        base_shapes=_portal(length, width, height),
    )


def _portal(length: float, width: float, height: float) -> tuple[Shape, ...]:
    """Return the two beams under the ends of the bridge, on four columns."""
    side, end = width / 2.0 + _OVER - _BEAM / 2.0, length / 2.0 + _OVER - _COLUMN / 2.0
    top = height + _TROLLEY[2]
    tall = top - _BEAM
    beams = [
        Shape(Box((length + 2.0 * _OVER, _BEAM, _BEAM)), translation(0.0, y, top - _BEAM / 2.0), DARK_GREY)
        for y in (-side, side)
    ]
    columns = [
        Shape(Box((_COLUMN, _COLUMN, tall)), translation(x, y, tall / 2.0), DARK_GREY)
        for x in (-end, end)
        for y in (-side, side)
    ]
    return (*beams, *columns)
