"""Masses and looks of the links of a file, in the frames of their joints."""

from functools import partial

import numpy as np

from ropsim.model import (
    LIGHT_GREY,
    Box,
    Cylinder,
    Link,
    Material,
    Mesh,
    Polyline,
    Prism,
    Revolve,
    Shape,
    Solid,
    Sphere,
)
from ropsim.nirox.diagnostics import IMPOSSIBLE, LOST
from ropsim.nirox.readers.mechanism import Mechanism
from ropsim.nirox.readers.seen import Seen
from ropsim.spatial import Array

_MASSES = ("rigid_link_mass_properties", "effective_link_inertia")
_BELOW_ZERO = -1e-9
"""Least moment of inertia, relative to the greatest, that is rounding."""


def read_links(seen: Seen, mechanism: Mechanism) -> tuple[tuple[Link, ...], tuple[Shape, ...]]:
    """Return the links, one for each joint, and the shapes of the base."""
    shapes = _shapes(seen, mechanism)
    links = []
    for number, moved in enumerate(mechanism.moved):
        nothing = (0.0, np.zeros(3), np.zeros((3, 3)))
        mass, com, inertia = seen.attempt(partial(_weight, seen, moved.link, number), nothing)
        X_JL = mechanism.frames[moved.link]
        if not X_JL.is_identity:
            R = X_JL.rotation()
            com, inertia = R @ com + X_JL.position, R @ inertia @ R.T
        links.append(Link(mass, com, inertia, tuple(shapes.get(moved.link, ()))))
    for entity in _MASSES:
        for weight in seen.users(mechanism.base, entity, "link"):
            seen.note(LOST, weight, "the base does not move: its mass has no effect")
    return tuple(links), tuple(shapes.get(mechanism.base, ()))


def _weight(seen: Seen, link: int, number: int) -> tuple[float, Array, Array]:
    """Return mass [kg], centre of mass [m] and inertia about it [kg·m²] of a link in its own frame."""
    for entity in _MASSES:
        weight = seen.user(link, entity, "link")
        if weight is not None:
            seen.take(weight, "mass", number)
            xx, yy, zz, xy, xz, yz = seen.reals(weight, "inertia_at_com")
            inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
            if entity == _MASSES[0]:
                moments = np.linalg.eigvalsh(inertia)
                if moments[0] < _BELOW_ZERO * abs(moments[2]):
                    words = f"the inertia has a negative moment, {moments[0]:.3g} kg·m²"
                    seen.note(IMPOSSIBLE, weight, words, "look at the products of inertia and their signs")
            return seen.real(weight, "mass"), np.array(seen.reals(weight, "centre_of_mass")), inertia
    return 0.0, np.zeros(3), np.zeros((3, 3))


def _shapes(seen: Seen, mechanism: Mechanism) -> dict[int, list[Shape]]:
    """Return the shapes of each link in the order of the file."""
    order = {one.number: place for place, one in enumerate(seen.population.file.instances)}
    elements = sorted((*seen.extent("graphic_element"), *seen.extent("link_geometry")), key=order.__getitem__)
    found: dict[int, list[Shape]] = {}
    for element in elements:
        link = seen.ref(element, "link")
        if link not in mechanism.links:
            seen.note(IMPOSSIBLE, element, "its link does not belong to the mechanism", "take it out")
            continue
        key = ("shape", mechanism.links[link], len(found.setdefault(link, [])))
        seen.take(element, *key)
        shape = seen.attempt(partial(_shape, seen, mechanism, element, key), None)
        found[link] += [shape] if shape else []
    return found


def _shape(seen: Seen, mechanism: Mechanism, element: int, key: tuple[str, int, int]) -> Shape:
    look: int | None = element
    X_LS = mechanism.places.pose(seen.ref(element, "placement"), (*key, "place"))
    pose = mechanism.frames[seen.ref(element, "link")] @ X_LS
    if seen.is_a(element, "link_geometry"):
        solid: Solid = Mesh(seen.text(element, "uri"), seen.real(element, "scale"))
        look = seen.user(element, "geometry_look", "geometry")
    else:
        solid = _solid(seen, element)
    if look is None:
        return Shape(solid, pose)
    seen.take(look, *key, *(("look",) if look != element else ()))
    colour = seen.text(look, "colour")
    if not (
        len(colour) == 7 and colour[0] == "#" and all(one in "0123456789abcdefABCDEF" for one in colour[1:])
    ):
        seen.note(
            IMPOSSIBLE, look, f"`colour` is `{colour[:20]}`, allowed is `#rrggbb`", f"such as {LIGHT_GREY}"
        )
    return Shape(solid, pose, colour, seen.real(look, "opacity"), Material(seen.text(look, "material")))


def _solid(seen: Seen, element: int) -> Solid:
    if seen.is_a(element, "box_element"):
        x, y, z = seen.reals(element, "size")
        return Box((x, y, z))
    if seen.is_a(element, "cylinder_element"):
        top = seen.real(element, "top_radius") if seen.has(element, "top_radius") else None
        return Cylinder(seen.real(element, "radius"), seen.real(element, "length"), top)
    if seen.is_a(element, "sphere_element"):
        return Sphere(seen.real(element, "radius"))
    if seen.is_a(element, "revolve_element"):
        return Revolve(tuple((r, z) for r, z in seen.points(element, "profile")))
    if seen.is_a(element, "prism_element"):
        outline = tuple((x, y) for x, y in seen.points(element, "outline"))
        return Prism(outline, seen.real(element, "length"))
    return Polyline(tuple((x, y, z) for x, y, z in seen.points(element, "points")))
