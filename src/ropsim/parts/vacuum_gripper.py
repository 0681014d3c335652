"""Vacuum grippers: a housing with a plate, under which suction cups hang in rows and columns."""

from itertools import product

from ropsim.model import STEEL_GREY, Gripper, Material, Revolve, Shape
from ropsim.parts.elements import (
    ADAPTER,
    HOUSING,
    RUBBER,
    adapter_plate,
    block,
    housing,
    length_of,
    tool_parameters,
    upright,
)
from ropsim.parts.gripper_products import VACUUM_PRODUCTS
from ropsim.parts.part_kind import TCP, LibraryPart, Measure, Parameter, PartKind, UpperBound, Use, Values
from ropsim.parts.solid_mass import filled, with_com
from ropsim.spatial import translation

_CARRIER = 0.012  # [m], thickness of the plate that carries the cups
_CAPTURE = 0.01  # [m]
_SHORTEST = 0.02  # [m], of a housing

_PARAMETERS = (
    length_of("cup_diameter", 0.04, 0.005, 0.2, "Diameter of a suction cup."),
    Parameter("cups_x", Measure.COUNT, 1, 1, 4, "Number of cups along x."),
    Parameter("cups_y", Measure.COUNT, 1, 1, 4, "Number of cups along y."),
    length_of("pitch", 0.08, 0.01, 0.5, "Distance from cup to cup."),
    length_of("cup_length", 0.045, 0.01, 0.2, "Length of a cup with its stem."),
    *tool_parameters(0.6, 0.2, 0.3),
    length_of("body_length", 0.06, 0.02, 0.4, "Length of the housing along the approach direction."),
    length_of("body_width", 0.08, 0.02, 0.4, "Width of the housing along y."),
    length_of("body_depth", 0.06, 0.02, 0.4, "Depth of the housing along x."),
    length_of("flange_diameter", 0.063, 0.02, 0.3, "Diameter of the adapter plate."),
)


def _make(values: Values) -> LibraryPart:
    """Return a vacuum gripper; its TCP is in the middle of the cups, at their lips."""
    body, cup = _lengths(values)
    pitch, lip = values["pitch"], values["cup_diameter"] / 2.0
    columns, rows = round(values["cups_x"]), round(values["cups_y"])
    bottom = ADAPTER + body
    extent = ((columns - 1) * pitch + lip, (rows - 1) * pitch + lip, _CARRIER)
    cups = (
        shape
        for column, row in product(range(columns), range(rows))
        for shape in _cup(
            (column - 0.5 * (columns - 1)) * pitch,
            (row - 0.5 * (rows - 1)) * pitch,
            bottom + _CARRIER,
            cup,
            lip,
        )
    )
    shapes = (
        *adapter_plate(values["flange_diameter"]),
        *housing((values["body_depth"], values["body_width"], body), (1.02, 0.7, 0.5)),
        block(extent, (0.0, 0.0, bottom + _CARRIER / 2.0), STEEL_GREY, Material.STEEL),
        *cups,
    )
    load = with_com(filled(shapes, values["mass"]), values.get("com"))
    gripper = Gripper(values["open_time"], values["close_time"], _CAPTURE)
    return LibraryPart(shapes, (), load, translation(0.0, 0.0, bottom + _CARRIER + cup), gripper, HOUSING)


def _lengths(values: Values) -> tuple[float, float]:
    """Return the lengths of housing and cups, which reach to a given TCP [m]."""
    if TCP not in values:
        return values["body_length"], values["cup_length"]
    both = values[TCP] - ADAPTER - _CARRIER
    cup = min(values["cup_length"], both - _SHORTEST)
    return both - cup, cup


def _cup(x: float, y: float, top: float, length: float, radius: float) -> tuple[Shape, Shape]:
    """Return stem and bellows of a cup that begins at the height `top` and ends `length` in front of it."""
    stem = 0.4 * length
    fold = (length - stem) / 3.0
    bellows = Revolve(
        (
            (0.0, 0.0),
            (0.45 * radius, 0.0),
            (0.85 * radius, 0.7 * fold),
            (0.55 * radius, 1.3 * fold),
            (0.85 * radius, 2.0 * fold),
            (0.6 * radius, 2.3 * fold),
            (radius, 3.0 * fold),
            (0.0, 3.0 * fold),
        )
    )
    return (
        upright(0.35 * radius, top, top + stem, STEEL_GREY, Material.STEEL, x, y),
        Shape(bellows, translation(x, y, top + stem), RUBBER, material=Material.RUBBER),
    )


VACUUM_GRIPPER = PartKind(
    "vacuum_gripper",
    "Vacuum gripper",
    Use.TOOL,
    "The mechanical interface; the TCP is in the middle of the lips of the suction cups.",
    _PARAMETERS,
    _make,
    VACUUM_PRODUCTS,
    (UpperBound("cup_diameter", "pitch", of_several=("cups_x", "cups_y")),),
)
