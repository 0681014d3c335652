"""Masses of products in AP242: masses of the links that the products represent.

A link is represented by the shape of a product, and properties of that product by a measure of mass, a point
called the centre of mass, and a matrix (`moments_of_inertia_representation` of ISO 10303-214 and -242). The
matrix is taken as the tensor about the centre of mass along the axes of the product, and these as the axes of
the link.
"""

from collections.abc import Iterator
from dataclasses import replace

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.nirox.building import reals
from ropsim.nirox.diagnostics import NO_MASS
from ropsim.nirox.products.product_units import Known, measured, reference, references_in, scale_of
from ropsim.nirox.readers.mechanism import MOST_JOINTS
from ropsim.part21 import Enumeration, ExchangeFile, Instance, Record, Reference, Typed

_CENTRES = ("centre of mass", "center of mass", "centre of gravity", "center of gravity")
_PARTS = (("its centre", "centre"), ("moments of inertia", "matrix"))
_ROWS, _NAMED = 3, 6
_MOST_PROPERTIES, _MOST_ITEMS = 50, 20
"""Representations of a product, and items of each, that are read."""
_HINT = "`ropsim robot import FILE.stp --to ARM.stp` makes a file in which masses can be written"


@frozen_dataclass
class Weight:
    """Mass properties of a product.

    Attributes:
        mass: [kg].
        place: the instance that says it.
        centre: of mass [m]; empty where it is not said.
        matrix: nine moments of inertia [kg·m²], row by row; empty where they are not said.
    """

    mass: float
    place: Instance
    centre: tuple[float, ...] = ()
    matrix: tuple[float, ...] = ()


def with_masses(file: ExchangeFile) -> tuple[ExchangeFile, tuple[Diagnostic, ...]]:
    """Return a file with the masses of its links as NIROX has them, and findings on missing data.

    Args:
        file: with a mechanism.
    """
    known = {one.number: one for one in file.instances}
    links = list(_all(known, "KINEMATIC_LINK"))
    moved = {reference(one.values, 2) for _, one in _all(known, "KINEMATIC_JOINT")}
    if len(links) > MOST_JOINTS + 1:
        return file, ()
    properties = _properties(known)
    made: list[Instance] = []
    diagnostics: list[Diagnostic] = []
    without: list[int] = []
    for link, _ in links:
        weight = _weight(known, properties.get(link, []))
        if weight is not None:
            made.append(_instance(max(known) + 1 + len(made), link, weight))
            missing = [what for what, part in _PARTS if not getattr(weight, part)]
            if missing:
                words = (
                    f"the mass of link {_called(known, link)} comes without {' and '.join(missing)}, 0 here"
                )
                diagnostics.append(NO_MASS.at(file.span(weight.place), words, hint=_HINT))
        elif link in moved:
            without.append(link)
    if without:
        names = ", ".join(_called(known, one) for one in without[:_NAMED])
        more = f" and {len(without) - _NAMED} more" if len(without) > _NAMED else ""
        words = f"no product of the file gives a mass to the links {names}{more}"
        diagnostics.append(NO_MASS.at(file.span(known[without[0]]), words, hint=_HINT))
    return replace(file, instances=(*file.instances, *made)), tuple(diagnostics)


def _called(known: Known, link: int) -> str:
    return f"`{_label(known[link].records[0])[:60]}`"


def _label(record: Record) -> str:
    return str(record.values[0]) if record.values else ""


def _instance(number: int, link: int, weight: Weight) -> Instance:
    xx, xy, xz, _, yy, yz, _, _, zz = weight.matrix or (0.0,) * 9
    rows = reals(weight.centre or (0.0, 0.0, 0.0)), reals((xx, yy, zz, xy, xz, yz))
    values = (Reference(link), weight.mass, *rows, Enumeration("CAD"))
    record = Record("RIGID_LINK_MASS_PROPERTIES", values)
    return Instance(number, (record,), weight.place.offset)


def _properties(known: Known) -> dict[int, list[int]]:
    """Return the representations of properties of the products that links stand for, by the links."""
    represented = {
        number: reference(one.values, 3) for number, one in _all(known, "RIGID_LINK_REPRESENTATION")
    }
    of: dict[int, list[int]] = {}  # links of a shape, of a product, of a property, by their numbers

    def pass_on(source: int | None, target: int | None) -> None:
        if target is not None and source in of:
            of[target] = list(dict.fromkeys((*of.get(target, ()), *of[source])))

    for _, one in _all(known, "KINEMATIC_LINK_REPRESENTATION_ASSOCIATION"):
        for place in (2, 3):
            link = represented.get(reference(one.values, place) or 0)
            shape = reference(one.values, 5 - place)
            if link is not None and shape is not None:
                of.setdefault(shape, []).append(link)
    for _, one in _all(known, "SHAPE_DEFINITION_REPRESENTATION"):
        pass_on(reference(one.values, 1), reference(one.values, 0))
    for number, one in _all(known, "PRODUCT_DEFINITION_SHAPE"):
        pass_on(number, reference(one.values, 2))
    for number, one in _all(known, "PROPERTY_DEFINITION"):
        pass_on(reference(one.values, 2), number)
    found: dict[int, list[int]] = {}
    for _, one in _all(known, "PROPERTY_DEFINITION_REPRESENTATION"):
        used = reference(one.values, 1)
        for link in of.get(reference(one.values, 0) or 0, ()):
            if used is not None and used in known and len(found.setdefault(link, [])) < _MOST_PROPERTIES:
                found[link].append(used)
    return found


def _weight(known: Known, representations: list[int]) -> Weight | None:
    """Return the mass properties of a product; None without a mass."""
    weight: Weight | None = None
    centre: tuple[float, ...] = ()
    matrix: tuple[float, ...] = ()
    for number in representations:
        representation = known[number].records[0]
        items = [one for one in references_in(representation.values[1:2])[:_MOST_ITEMS] if one in known]
        length = _length(known, reference(representation.values, 2))
        if representation.keyword == "MOMENTS_OF_INERTIA_REPRESENTATION":
            matrix = matrix or _matrix(known, items, length)
        elif _label(representation).strip().lower() in _CENTRES:
            centre = centre or next(iter(_points(known, items, length)), ())
        elif weight is None:
            found = next(iter(_masses(known, items)), None)
            weight = None if found is None else Weight(found, known[number])
    return replace(weight, centre=centre, matrix=matrix) if weight else None


def _masses(known: Known, items: list[int]) -> Iterator[float]:
    for item in items:
        typed = [one for record in known[item].records for one in record.values if isinstance(one, Typed)]
        number, unit = measured(known, item)
        scale = scale_of(known, unit) if unit is not None else None
        if number is not None and scale is not None and any(one.keyword == "MASS_MEASURE" for one in typed):
            yield number * scale


def _points(known: Known, items: list[int], length: float) -> Iterator[tuple[float, ...]]:
    for item in items:
        record = known[item].records[0]
        values = record.values[1] if record.keyword == "CARTESIAN_POINT" and len(record.values) > 1 else ()
        if isinstance(values, tuple) and len(values) == _ROWS:
            point = [float(one) * length for one in values if isinstance(one, float | int)]
            if len(point) == _ROWS:
                yield tuple(point)


def _matrix(known: Known, items: list[int], length: float) -> tuple[float, ...]:
    """Return nine moments [kg·m²]; values without a unit are in kg and the length of their context."""
    found: list[float] = []
    for row in _three(known, items[0] if items else None):
        for cell in _three(known, row):
            number, unit = measured(known, cell)
            scale = length * length if unit is None else scale_of(known, unit)
            if number is None or scale is None:
                return ()
            found.append(number * scale)
    return tuple(found) if len(found) == _ROWS * _ROWS else ()


def _three(known: Known, item: int | None) -> list[int]:
    """Return the three items that a compound one has; none where it has another count."""
    found = references_in(known[item].records[0].values) if item is not None and item in known else []
    return found if len(found) == _ROWS else []


def _length(known: Known, context: int | None) -> float:
    """Return the unit of length of a context [m]."""
    records = known[context].records if context is not None and context in known else ()
    for record in records:
        for unit in references_in(record.values) if record.keyword == "GLOBAL_UNIT_ASSIGNED_CONTEXT" else ():
            if unit in known and any(one.keyword == "LENGTH_UNIT" for one in known[unit].records):
                return scale_of(known, unit) or 1.0
    return 1.0


def _all(known: Known, keyword: str) -> Iterator[tuple[int, Record]]:
    return ((number, one.records[0]) for number, one in known.items() if one.keyword == keyword)
