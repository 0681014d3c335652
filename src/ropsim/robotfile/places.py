"""Where the numbers of a robot stand in its file."""

from collections.abc import Mapping
from types import MappingProxyType

from ropsim.core import SourceText, Span
from ropsim.model import Attribute, AuditPlace, PlaceOf
from ropsim.tomltext import Path, Positions, positions

_KEYS: Mapping[Attribute, tuple[str, str]] = MappingProxyType(
    {
        Attribute.LIMITS: ("joints", "limits"),
        Attribute.MAX_SPEED: ("joints", "speed"),
        Attribute.MAX_ACCELERATION: ("joints", "acceleration"),
        Attribute.MAX_JERK: ("joints", "jerk"),
        Attribute.MAX_EFFORT: ("joints", "effort"),
        Attribute.PLACEMENT: ("joints", "a"),
        Attribute.MASS: ("links", "mass"),
        Attribute.COM: ("links", "com"),
        Attribute.INERTIA: ("links", "inertia"),
    }
)


def robot_file_places(source: SourceText) -> PlaceOf:
    """Return where the numbers of a robot stand in its file, or the nearest entry around them.

    Args:
        source: a robot file that is valid TOML.
    """
    places = positions(source)

    def place(wanted: AuditPlace) -> Span:
        return _at(places, _path(wanted))

    return place


def _path(wanted: AuditPlace) -> Path:
    if wanted.attribute is Attribute.HOME:
        return ("home", wanted.number)
    if wanted.attribute is Attribute.DRIVE:
        return ("drives", wanted.number, wanted.name)
    table, key = _KEYS[wanted.attribute]
    return (table, wanted.number, key)


def _at(places: Positions, path: Path) -> Span:
    """Return the span of the value at a path, or else of the row, or the list, that it would be in."""
    while path and path not in places.values:
        if path in places.keys:
            return places.keys[path]
        path = path[:-1]
    return places.values[path] if path else places.start
