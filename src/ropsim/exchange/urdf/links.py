"""Links of URDF: their inertial frames, masses and looks."""

from collections.abc import Mapping

import numpy as np

from ropsim.exchange.assembly.description import Body
from ropsim.exchange.files.folder import RobotFolder
from ropsim.exchange.files.values import name_of, number_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, ELEMENT_MISSING
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.urdf.poses import origin_of
from ropsim.exchange.urdf.shapes import Colour, shapes_of
from ropsim.model import Payload, moved

_MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")


def body_of(link: Element, materials: Mapping[str, Colour], folder: RobotFolder, notes: Notes) -> Body | None:
    """Return the body of a link; nothing where it has no name (noted)."""
    name = name_of(link, notes)
    if name is None:
        return None
    is_collision = link.first("visual") is None and link.first("collision") is not None
    shapes = shapes_of(link, materials, folder, notes)
    return Body(name, _weight(link, notes), shapes, link.span, is_collision)


def _weight(link: Element, notes: Notes) -> Payload:
    """Return mass, centre of mass, and inertia about it in the axes of the link.

    URDF has the inertia in a separate frame, whose origin is the centre of mass; products of inertia are
    entries of the tensor (Ixy = -∫xy dm).
    """
    inertial = link.first("inertial")
    if inertial is None:
        return Payload()
    mass_element, inertia_element = inertial.first("mass"), inertial.first("inertia")
    if mass_element is None or "value" not in mass_element.attributes:
        words = f"the inertial of link `{link.attributes.get('name', '')}` has no mass"
        notes.add(ELEMENT_MISSING, inertial.span, words, 'write <mass value="..."/> into it')
        return Payload()
    mass = number_of(mass_element, "value", notes)
    if mass < 0.0:
        words = f"link `{link.attributes.get('name', '')}` has a mass of {mass:g} kg, allowed is 0 kg or more"
        notes.add(BAD_NUMBER, mass_element.span, words, "check the sign")
        return Payload()
    inertia = np.zeros((3, 3))
    if inertia_element is not None:
        xx, yy, zz, xy, xz, yz = (number_of(inertia_element, key, notes) for key in _MOMENTS)
        inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    own = Payload(mass, np.zeros(3), inertia)
    X = origin_of(inertial, notes)
    if X.orientation[0] != 1.0:
        return moved(own, X)
    return Payload(mass, X.position, inertia)
