"""Adapter flanges with the hole pattern of ISO 9409-1."""

from math import cos, pi, sin

from ropsim.model import DARK_GREY, STEEL_GREY, Material, OriginKind
from ropsim.parts.elements import length_of, upright
from ropsim.parts.part_kind import LibraryPart, Measure, Parameter, PartKind, Product, Use, Values
from ropsim.parts.solid_mass import filled
from ropsim.spatial import translation

_ALUMINIUM = 2700.0  # [kg/m³]
_SOURCE = "pitch circle, screws and thread are in the designation; the series itself is not confirmed"
_MARGIN = "From the pitch circle to the edge; without it 6.5 mm, of large threads 0.9 of their diameter."

_PARAMETERS = (
    Parameter(
        "pitch_circle",
        Measure.LENGTH,
        0.05,
        0.02,
        0.3,
        "Diameter of the circle on which the screws stand.",
        OriginKind.DERIVED,
        _SOURCE,
    ),
    Parameter("screws", Measure.COUNT, 4, 3, 12, "Number of screws.", OriginKind.DERIVED, _SOURCE),
    Parameter(
        "thread",
        Measure.LENGTH,
        0.006,
        0.002,
        0.02,
        "Diameter of their threads.",
        OriginKind.DERIVED,
        _SOURCE,
    ),
    length_of("thickness", 0.012, 0.003, 0.1, "Thickness of the plate."),
    Parameter("margin", Measure.LENGTH, None, 0.001, 0.1, _MARGIN),
    Parameter("mass", Measure.MASS, None, 0.001, 100.0, "Mass; without it that of a plate of aluminium."),
)


def _make(values: Values) -> LibraryPart:
    """Return a plate with a centring ring and the heads of its screws; its TCP is on its far side."""
    circle, thread, thick = values["pitch_circle"] / 2.0, values["thread"], values["thickness"]
    radius, count = circle + values.get("margin", max(0.0065, 0.9 * thread)), round(values["screws"])
    ring = max(0.6 * circle, 0.002)
    plate = upright(radius, 0.0, 0.9 * thick, STEEL_GREY, Material.STEEL)
    centring = upright(
        max(min(ring, circle - 0.8 * thread), 0.002), 0.9 * thick, thick, STEEL_GREY, Material.STEEL
    )
    heads = tuple(
        upright(
            0.8 * thread,
            0.9 * thick,
            0.96 * thick,
            DARK_GREY,
            Material.STEEL,
            circle * cos(2.0 * pi * (k + 0.5) / count),
            circle * sin(2.0 * pi * (k + 0.5) / count),
        )
        for k in range(count)
    )
    load = filled((plate, centring), values.get("mass"), _ALUMINIUM)
    return LibraryPart((plate, centring, *heads), (), load, translation(0.0, 0.0, thick), colour=STEEL_GREY)


def _iso(circle: float, count: int, thread: int) -> Product:
    """Return the flange of a designation: pitch circle [mm], number of screws, thread [mm]."""
    words = f"{circle:g}-{count}-M{thread}"
    name = f"iso_9409_1_{words.lower().replace('-', '_').replace('.', '_')}"
    values = {"pitch_circle": circle / 1e3, "screws": float(count), "thread": thread / 1e3}
    return Product(name, f"ISO 9409-1-{words}", values, OriginKind.DERIVED, _SOURCE)


FLANGE = PartKind(
    "flange",
    "Adapter flange",
    Use.TOOL,
    "The mechanical interface; the TCP is in the middle of the far side.",
    _PARAMETERS,
    _make,
    tuple(
        _iso(*row)
        for row in (
            (31.5, 4, 5),
            (40.0, 4, 6),
            (50.0, 4, 6),
            (63.0, 4, 6),
            (80.0, 6, 8),
            (100.0, 6, 8),
            (125.0, 6, 10),
            (160.0, 6, 10),
        )
    ),
)
