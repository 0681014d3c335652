"""Payload: a rigid body fixed to the mechanical interface."""

from dataclasses import field

import numpy as np

from ropsim.model.mechanism.number_check import check_finite, check_mass
from ropsim.spatial import Array, Pose, frozen, record


@record
class Payload:
    """A rigid body in the mechanical interface frame.

    Attributes:
        mass: [kg].
        com: centre of mass [m], shape (3,).
        inertia: about the centre of mass [kg·m²], shape (3, 3).

    Raises:
        ModelValueError: the mass is negative, or a number is not finite.
    """

    mass: float = 0.0
    com: Array = field(default_factory=lambda: frozen([0.0, 0.0, 0.0]))
    inertia: Array = field(default_factory=lambda: frozen([[0.0] * 3] * 3))

    def __post_init__(self) -> None:
        object.__setattr__(self, "com", frozen(self.com))
        object.__setattr__(self, "inertia", frozen(self.inertia))
        check_finite("a payload", (self.mass, *self.com.ravel(), *self.inertia.ravel()))
        check_mass("a payload", self.mass)


def moved(payload: Payload, X: Pose) -> Payload:
    """Return a body that is given in one frame, in another one.

    Args:
        payload: in the frame of its own.
        X: that frame in the other one.
    """
    R = X.rotation()
    return Payload(payload.mass, X.position + R @ payload.com, R @ payload.inertia @ R.T)


def combine(payloads: tuple[Payload, ...]) -> Payload:
    """Return the one rigid body that several bodies fixed to each other form (parallel axis theorem)."""
    mass = sum(payload.mass for payload in payloads)
    if mass == 0.0:
        return Payload()
    com = sum((payload.mass * payload.com for payload in payloads), np.zeros(3)) / mass
    inertia = np.zeros((3, 3))
    for payload in payloads:
        r = payload.com - com
        inertia += payload.inertia + payload.mass * ((r @ r) * np.eye(3) - np.outer(r, r))
    return Payload(mass, com, inertia)


def box(mass: float, size: Array, com: Array, rotation: Array) -> Payload:
    """Return a homogeneous box.

    Args:
        mass: [kg].
        size: edges along its own axes [m], shape (3,).
        com: its centre in the mechanical interface frame [m], shape (3,).
        rotation: R_MO of its own axes, shape (3, 3).
    """
    squares = np.asarray(size) ** 2
    own = np.diag(mass / 12.0 * (squares.sum() - squares))
    return Payload(mass, com, rotation @ own @ rotation.T)
