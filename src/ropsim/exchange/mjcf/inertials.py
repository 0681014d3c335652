"""The `inertial` of a body of MJCF."""

import numpy as np

from ropsim.exchange.files.values import number_of, numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, ELEMENT_MISSING
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.poses import pose_of
from ropsim.exchange.mjcf.settings import Settings
from ropsim.model import Payload, moved


def inertial_of(inertial: Element, settings: Settings, notes: Notes) -> Payload:
    """Return mass, centre of mass, and inertia about it, in the frame of the body."""
    X = pose_of(inertial, settings, notes)
    if "mass" not in inertial.attributes:
        notes.add(ELEMENT_MISSING, inertial.span, "an inertial has no mass", 'write mass="..." into it')
    mass = number_of(inertial, "mass", notes)
    if mass < 0.0:
        words = f"a body has a mass of {mass:g} kg, allowed is 0 kg or more"
        notes.add(BAD_NUMBER, inertial.span, words, "check the sign")
        return Payload()
    if "fullinertia" in inertial.attributes:
        xx, yy, zz, xy, xz, yz = numbers_of(inertial, "fullinertia", notes, (0.0,) * 6)
        inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    else:
        inertia = np.diag(numbers_of(inertial, "diaginertia", notes, (0.0, 0.0, 0.0)))
    if X.orientation[0] == 1.0:
        return Payload(mass, X.position, inertia)
    return moved(Payload(mass, np.zeros(3), inertia), X)
