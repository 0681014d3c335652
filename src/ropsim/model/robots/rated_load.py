"""The rated load of an arm as a body: the maker states a mass, and a cube of water stands for the rest."""

from dataclasses import replace
from math import isfinite

import numpy as np

from ropsim.model.robots.payload import Payload, box, combine, moved
from ropsim.model.robots.robot import RobotModel

WATER = 1000
"""Density of the load, a cube on the interface [kg/m³]."""


def cube_of_water(mass: float) -> Payload:
    """Return a cube of water whose face lies on the mechanical interface.

    Args:
        mass: more than 0 [kg].
    """
    side = (mass / WATER) ** (1.0 / 3.0)
    return box(mass, np.full(3, side), np.array([0.0, 0.0, 0.5 * side]), np.eye(3))


def with_payload(robot: RobotModel, payload: float) -> RobotModel:
    """Return an arm whose last link holds a cube of water; the arm itself with nothing to carry.

    Args:
        robot: bare.
        payload: mass of the cube [kg]; inf where it is unknown.
    """
    if not (isfinite(payload) and payload > 0.0):
        return robot
    held = robot.links[robot.tip]
    load = moved(cube_of_water(payload), robot.X_nM)
    whole = combine((Payload(held.mass, held.com, held.inertia), load))
    links = list(robot.links)
    links[robot.tip] = replace(held, mass=whole.mass, com=whole.com, inertia=whole.inertia)
    return replace(robot, links=tuple(links))
