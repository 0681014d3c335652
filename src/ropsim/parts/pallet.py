"""Pallets of wood: deck boards on cross boards, blocks and runners, as a EUR pallet has them."""

from collections.abc import Sequence

from ropsim.model import Material, OriginKind, Shape
from ropsim.parts.elements import WOOD, block
from ropsim.parts.part_kind import Fact, LibraryPart, Measure, Parameter, PartKind, Product, Use, Values
from ropsim.parts.solid_mass import filled

_BOARD, _WIDE, _NARROW = 0.022, 0.145, 0.1  # [m], thickness and widths of boards
_LEAST_GAP = 0.015  # [m], between two boards of the deck
_STANDARD = "EN 13698-1 / UIC 435-2, second hand"
_EUR = (
    f"{_STANDARD}: 1200 x 800 x 144 mm, about 25 kg, 1,500 kg evenly loaded; "
    "deck boards 22 mm, 145 and 100 mm wide; blocks 145 mm"
)
_TYPES = "public list of EUR pallet types"
_SIDE, _CROSS = "#b8945f", "#ad8a58"


def _parameter(name: str, default: float, low: float, high: float, meaning: str) -> Parameter:
    return Parameter(name, Measure.LENGTH, default, low, high, meaning, OriginKind.PUBLISHED, _STANDARD)


_PARAMETERS = (
    _parameter("length", 1.2, 0.4, 2.0, "Length, along x; the boards of the deck go along it."),
    _parameter("width", 0.8, 0.4, 2.0, "Width, along y."),
    _parameter("height", 0.144, 0.1, 0.3, "Height of the deck above the floor."),
    Parameter("mass", Measure.MASS, 25.0, 1.0, 200.0, "Mass.", OriginKind.PUBLISHED, _STANDARD),
)


def _make(values: Values) -> LibraryPart:
    """Return a pallet: its frame in the middle on the floor."""
    length, width, height = values["length"], values["width"], values["height"]
    deck = _row(_widths(width), width)
    rows = _row((_NARROW, _WIDE, _NARROW), width)
    columns = _row((_WIDE, _WIDE, _WIDE), length)
    blocks = height - 3.0 * _BOARD
    shapes = (
        *(_board((length, wide), (0.0, y), height, WOOD) for y, wide in deck),
        *(_board((wide, width), (x, 0.0), height - _BOARD, _CROSS) for x, wide in columns),
        *(
            block((wide, broad, blocks), (x, y, _BOARD + blocks / 2.0), _SIDE, Material.WOOD)
            for x, wide in columns
            for y, broad in rows
        ),
        *(_board((length, broad), (0.0, y), _BOARD, WOOD) for y, broad in rows),
    )
    return LibraryPart(shapes, load=filled(shapes, values["mass"]), colour=WOOD)


def _board(size: tuple[float, float], middle: tuple[float, float], top: float, colour: str) -> Shape:
    """Return a board of an edge along x and along y whose upper side is at a height [m]."""
    return block((*size, _BOARD), (*middle, top - _BOARD / 2.0), colour, Material.WOOD)


def _widths(width: float) -> tuple[float, ...]:
    """Return the widths of the boards of a deck, wide and narrow in turn, as many as fit with gaps [m]."""
    count = 3
    while _sum(count + 2) + (count + 1) * _LEAST_GAP <= width:
        count += 2
    return tuple(_WIDE if number % 2 == 0 else _NARROW for number in range(count))


def _sum(count: int) -> float:
    """Return the width of an odd number of boards without gaps [m]."""
    return (count + 1) // 2 * _WIDE + count // 2 * _NARROW


def _row(widths: Sequence[float], whole: float) -> tuple[tuple[float, float], ...]:
    """Return the middle and the width of boards that are spread evenly over a length [m]."""
    gap = (whole - sum(widths)) / (len(widths) - 1)
    found, start = [], -whole / 2.0
    for wide in widths:
        found.append((start + wide / 2.0, wide))
        start += wide + gap
    return tuple(found)


def _type(name: str, title: str, size: tuple[float, float], mass: float, load: float, source: str) -> Product:
    values = {"length": size[0], "width": size[1], "height": 0.144, "mass": mass}
    facts = (Fact("load, evenly spread", (load,), "kg"),)
    return Product(name, title, values, OriginKind.PUBLISHED, source, facts=facts)


EUR_PALLET = PartKind(
    "eur_pallet",
    "EUR pallet",
    Use.OBJECT,
    "In the middle on the floor; the deck is `height` above, its boards go along x.",
    _PARAMETERS,
    _make,
    (
        _type("eur_1", "EUR 1 / EPAL 1", (1.2, 0.8), 25.0, 1500.0, _EUR),
        _type("eur_2", "EUR 2", (1.2, 1.0), 33.0, 1470.0, _TYPES),
        _type("eur_3", "EUR 3", (1.0, 1.2), 29.0, 1920.0, _TYPES),
        _type("eur_6", "EUR 6 (half)", (0.8, 0.6), 9.5, 500.0, _TYPES),
    ),
)
