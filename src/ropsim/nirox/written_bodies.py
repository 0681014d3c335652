"""Masses of links as instances: as those of a body, or as what an identification tells."""

import numpy as np

from ropsim.model import Link, RobotModel
from ropsim.nirox.building import Building, reals
from ropsim.part21 import Enumeration

_SLACK = 1.0 + 1e-9
"""Of the triangle inequality, as in the schema."""


def write_bodies(building: Building, robot: RobotModel) -> None:
    """Make the masses of all links that have any."""
    source = Enumeration("ESTIMATED" if _is_estimated(robot) else "DATASHEET")
    for number, link in enumerate(robot.links):
        if not (link.mass or link.com.any() or link.inertia.any()):
            continue
        values = building.at(("link", number)), float(link.mass), reals(link.com), inertia_row(link)
        if _is_body(link):
            building.add(("mass", number), "RIGID_LINK_MASS_PROPERTIES", *values, source)
        else:
            building.add(("mass", number), "EFFECTIVE_LINK_INERTIA", *values)


def inertia_row(link: Link) -> tuple[float, ...]:
    """Return Ixx, Iyy, Izz, Ixy, Ixz, Iyz of a link [kg·m²]."""
    tensor = link.inertia
    return tuple(float(tensor[place]) for place in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))


def _is_body(link: Link) -> bool:
    """Return whether a body can have this mass and this inertia."""
    xx, yy, zz, *_ = inertia_row(link)
    if not (link.mass > 0.0 and min(xx, yy, zz) >= 0.0 and np.isfinite(link.inertia).all()):
        return False
    moments = np.linalg.eigvalsh(link.inertia)
    can_be = moments[0] >= -1e-12 * abs(moments[2])
    return bool(can_be and (xx + yy) * _SLACK >= zz and (yy + zz) * _SLACK >= xx and (zz + xx) * _SLACK >= yy)


def _is_estimated(robot: RobotModel) -> bool:
    return any("mass" in one.parameters and one.kind == "estimated" for one in robot.origins)
