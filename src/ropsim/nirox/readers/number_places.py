"""Where the numbers of a robot stand in its NIROX file."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from ropsim.core import Span
from ropsim.model import Attribute, AuditPlace, PlaceOf
from ropsim.nirox.readers.seen import Seen

_WORDS: Mapping[Attribute, tuple[str, ...]] = MappingProxyType(
    {
        Attribute.LIMITS: ("coordinate",),
        Attribute.MAX_SPEED: ("drive", "limits"),
        Attribute.MAX_ACCELERATION: ("drive", "limits"),
        Attribute.MAX_JERK: ("drive", "limits"),
        Attribute.MAX_EFFORT: ("limits",),
        Attribute.PLACEMENT: ("place",),
        Attribute.MASS: ("mass", "link"),
        Attribute.COM: ("mass", "link"),
        Attribute.INERTIA: ("mass", "link"),
        Attribute.HOME: ("state",),
        Attribute.DRIVE: ("motor", "drive"),
    }
)
"""Where the numbers of a joint, a link or an axis stand: the first of these that the file has."""


def places_of(seen: Seen, axes: Sequence[int]) -> PlaceOf:
    """Return the places of joints, links and axes that have been taken.

    Args:
        seen: the file.
        axes: numbers of the joints, from 0, that are driven.
    """
    file, places = seen.population.file, {key: number for number, key in seen.keys.items()}

    def place(requested: AuditPlace) -> Span | None:
        joint = axes[requested.number] if requested.attribute is Attribute.HOME else requested.number
        for word in (*_WORDS[requested.attribute], "pair"):
            number = places.get((word, joint))
            if number is not None:
                return file.span(seen.population.instances[number])
        return None

    return place
