"""Barycentric parameters: the ten numbers through which a rigid body enters the equations linearly."""

from functools import lru_cache

import numpy as np

from ropsim.model import Link, Payload, RobotModel
from ropsim.spatial import Array, frozen


def barycentric(mass: float, com: Array, inertia: Array) -> Array:
    """Return (m, m·c, I_o) of a body in the axes in which `com` and `inertia` are given.

    Args:
        mass: m [kg].
        com: centre of mass c [m], shape (3,).
        inertia: about the centre of mass [kg·m²], shape (3, 3).

    Returns:
        Shape (10,): m [kg]; m·c [kg·m], 3; inertia about the origin [kg·m²] as xx, yy, zz, xy, xz, yz, by the
        parallel axis theorem.
    """
    c = np.asarray(com)
    about_origin = np.asarray(inertia) + mass * ((c @ c) * np.eye(3) - np.outer(c, c))
    xx, yy, zz = np.diag(about_origin)
    xy, xz, yz = about_origin[0, 1], about_origin[0, 2], about_origin[1, 2]
    return frozen([mass, *(mass * c), xx, yy, zz, xy, xz, yz])


def link_parameters(link: Link) -> Array:
    """Return the barycentric parameters of a link in the frame of its joint, shape (10,)."""
    return barycentric(link.mass, link.com, link.inertia)


@lru_cache(maxsize=256)
def last_body(robot: RobotModel, payload: Payload | None = None) -> Array:
    """Return the barycentric parameters of the last link with a payload fixed to it, shape (10,).

    The compiled functions of an arm take them at run time, so that a grasp changes the load and nothing is
    compiled again.

    Args:
        robot: the arm.
        payload: body in the mechanical interface frame; None for none.
    """
    own = link_parameters(robot.links[-1])
    if payload is None or payload.mass == 0.0:
        return own
    R_nM = robot.X_nM.rotation()
    com = R_nM @ payload.com + robot.X_nM.position
    return frozen(own + barycentric(payload.mass, com, R_nM @ payload.inertia @ R_nM.T))
