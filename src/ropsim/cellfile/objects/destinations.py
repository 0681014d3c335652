"""Where parts of a cell file are to be at the end: the key `destination` of parts and supplies."""

from collections.abc import Mapping, Sequence

from ropsim.cellfile.frames import note_moving
from ropsim.cellfile.objects.grid import read_grid
from ropsim.core import frozen_dataclass
from ropsim.model import Destination
from ropsim.spatial import Array, Pose
from ropsim.tomltext import CONFLICTING_KEYS, WRONG_VALUE_COUNT, TomlTable, Units, read_pose

DISTANCE, TURN = 0.005, 0.08726646259971647
"""Default tolerance of a destination: 5 mm, 5°."""


@frozen_dataclass
class Surroundings:
    """Data of the rest of the file for readers of parts.

    Attributes:
        units: of the file.
        locations: X_WT by name; of locations in a moving frame X_KT.
        located: names of the frames that move in which locations are given, by the name of the location.
    """

    units: Units
    locations: Mapping[str, Pose]
    located: Mapping[str, str]


def read_destinations(
    table: TomlTable, around: Surroundings, shifts: Sequence[Array]
) -> Sequence[Destination | None]:
    """Return the destination of each of the parts that a table makes; None for each without one.

    Args:
        table: of `[[parts]]` or `[[supplies]]`.
        around: data of the rest of the file.
        shifts: by how much each part is away from the first [m], shape (3,) each; so are their destinations
            where these have no grid of their own.
    """
    units, locations = around.units, around.locations
    if "destination" not in table:
        return [None] * len(shifts)
    inner = table.table("destination")
    if "location" in inner and "position" in inner:
        message = "`location` and `position` both say where the part is to be"
        inner.findings.add(CONFLICTING_KEYS, inner.key_span("position"), message, "keep one of them")
    name = inner.reference("location", locations, "location")
    if name in around.located:
        note_moving(inner, "location", "location", name)
    if "location" not in inner:
        inner.require("position")
    given = "rpy" in inner or "quaternion" in inner
    pose = read_pose(inner, units)
    X_WO = Pose(locations[name].position, pose.orientation) if name else pose
    distance = inner.number("tolerance", units.extent, DISTANCE)
    turn = inner.number("turn", units.turn.within(0.0, units.turn.high), TURN)
    looks_at_turn = given or "turn" in inner or not name
    places = _places(inner, units, shifts)
    inner.finish()
    return [
        Destination(Pose(X_WO.position + shift, X_WO.orientation), distance, turn if looks_at_turn else None)
        for shift in places
    ]


def _places(inner: TomlTable, units: Units, shifts: Sequence[Array]) -> Sequence[Array]:
    """Return by how much the destination of each part is shifted [m]."""
    if "grid" not in inner:
        return shifts
    noted = len(inner.findings.items)
    own = read_grid(inner.table("grid"), units)
    if len(own) < len(shifts) and len(inner.findings.items) == noted:
        message = f"`{inner.name_of('grid')}` has {len(own)} places for {len(shifts)} parts"
        inner.findings.add(WRONG_VALUE_COUNT, inner.value_span("grid"), message)
    return own[: len(shifts)] if len(own) >= len(shifts) else shifts
