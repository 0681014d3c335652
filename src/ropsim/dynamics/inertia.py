"""Barycentric parameters: the ten numbers through which a rigid body enters the equations linearly."""

from functools import lru_cache

import numpy as np

from ropsim.model import BASE_LINK, Link, Mechanism, Payload, check_body, joint_tree
from ropsim.spatial import Array, Pose, frozen


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


@lru_cache(maxsize=1024)
def link_parameters(link: Link) -> Array:
    """Return the barycentric parameters of a link in the frame of its joint, shape (10,), read-only."""
    return barycentric(link.mass, link.com, link.inertia)


@lru_cache(maxsize=256)
def step_bodies(mechanism: Mechanism) -> tuple[Array, ...]:
    """Return the barycentric parameters of the body on each step of a mechanism, m arrays of shape (10,).

    A step that carries no link, as all except the last of a joint with several freedoms, has ten zeros; links
    that are fixed to each other ride on one step together.
    """
    tree = joint_tree(mechanism)
    found: list[Array | None] = [None] * tree.m
    for link, step, X_SL in zip(mechanism.links, tree.carriers, tree.X_SL, strict=True):
        if step == BASE_LINK:
            continue
        own = link_parameters(link) if Pose() == X_SL else _placed(link.mass, link.com, link.inertia, X_SL)
        before = found[step]
        found[step] = own if before is None else before + own
    return tuple(frozen(np.zeros(10)) if body is None else frozen(body) for body in found)


@lru_cache(maxsize=256)
def tip_body(mechanism: Mechanism, payload: Payload | None = None) -> Array:
    """Return the barycentric parameters of the step with the interface and of a payload on it, shape (10,).

    The compiled functions of an arm take them at run time, so that a grasp changes the load and nothing is
    compiled again.

    Args:
        mechanism: whose interface does not stand still.
        payload: body in the mechanical interface frame; None for none.

    Raises:
        ModelValueError: the inertia of the payload is negative or asymmetric.
    """
    step, X_SM = interface_step(mechanism)
    own = step_bodies(mechanism)[step]
    if payload is None or payload.mass == 0.0:
        return own
    check_body("the payload", payload)
    return frozen(own + _placed(payload.mass, payload.com, payload.inertia, X_SM))


def interface_step(mechanism: Mechanism) -> tuple[int, Pose]:
    """Return the step that carries the interface, -1 for the base, and the interface in its frame."""
    tree, link, X = joint_tree(mechanism), mechanism.interface_link, mechanism.interface
    if link == BASE_LINK:
        return BASE_LINK, X
    X_SL = tree.X_SL[link]
    return tree.carriers[link], X if Pose() == X_SL else X_SL @ X


def _placed(mass: float, com: Array, inertia: Array, X: Pose) -> Array:
    """Return the barycentric parameters of a body whose own frame is at X."""
    R = X.rotation()
    return barycentric(mass, R @ com + X.position, R @ inertia @ R.T)
