"""Vacuum grippers: a housing with a plate, under which suction cups hang in rows and columns."""

from itertools import product

from ropsim.model import Gripper, Material, Revolve, Shape
from ropsim.parts.elements import BODY, DARK, RUBBER, STEEL, at, block, length_of, tool_parameters, upright
from ropsim.parts.gripper_products import VACUUM_PRODUCTS
from ropsim.parts.part_kind import LibraryPart, Measure, Parameter, PartKind, Use, Values
from ropsim.parts.solid_mass import filled, with_com

_PLATE = 0.012  # [m], thickness of the adapter plate
_CARRIER = 0.012  # [m], thickness of the plate that carries the cups
_CAPTURE = 0.01  # [m]

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
    width, depth, length = values["body_width"], values["body_depth"], values["body_length"]
    radius, pitch = values["flange_diameter"] / 2.0, values["pitch"]
    columns, rows = round(values["cups_x"]), round(values["cups_y"])
    bottom = _PLATE + length
    carrier = bottom + _CARRIER
    across = values["cup_diameter"] / 2.0
    extent_x, extent_y = (max(0.0, (count - 1) * pitch) + across for count in (columns, rows))
    housing = (
        upright(radius, 0.0, 0.7 * _PLATE, STEEL, Material.STEEL),
        upright(0.8 * radius, 0.7 * _PLATE, _PLATE, DARK),
        block((depth, width, length), (0.0, 0.0, _PLATE + length / 2.0), BODY),
        block((1.02 * depth, 0.7 * width, 0.5 * length), (0.0, 0.0, _PLATE + length / 2.0), DARK),
        block((extent_x, extent_y, _CARRIER), (0.0, 0.0, bottom + _CARRIER / 2.0), STEEL, Material.STEEL),
    )
    cups = tuple(
        shape
        for column, row in product(range(columns), range(rows))
        for shape in _cup(
            (column - 0.5 * (columns - 1)) * pitch,
            (row - 0.5 * (rows - 1)) * pitch,
            carrier,
            values["cup_length"],
            across,
        )
    )
    shapes = (*housing, *cups)
    load = with_com(filled(shapes, values["mass"]), values.get("com"))
    gripper = Gripper(values["open_time"], values["close_time"], _CAPTURE)
    X_MT = at(0.0, 0.0, carrier + values["cup_length"])
    return LibraryPart(shapes, (), load, X_MT, gripper, BODY)


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
        upright(0.35 * radius, top, top + stem, STEEL, Material.STEEL, x, y),
        Shape(bellows, at(x, y, top + stem), RUBBER, material=Material.RUBBER),
    )


VACUUM_GRIPPER = PartKind(
    "vacuum_gripper",
    "Vacuum gripper",
    Use.TOOL,
    "The mechanical interface; the TCP is in the middle of the lips of the suction cups.",
    _PARAMETERS,
    _make,
    VACUUM_PRODUCTS,
    (("cup_diameter", "pitch"),),
)
