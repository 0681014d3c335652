"""Where external axes stand at a named location of a cell."""

from ropsim.core import frozen_dataclass
from ropsim.model.station import Station


@frozen_dataclass
class ExternalValues:
    """Values of external axes that belong to a location.

    Attributes:
        values: one for each external axis, in their order [rad | m].
        station: name of the station whose axes they are; empty for every station that has external axes.
    """

    values: tuple[float, ...]
    station: str = ""

    def of(self, station: Station) -> tuple[float, ...]:
        """Return the values for programs of a station; empty where they are of axes that it does not have."""
        has_them = bool(station.robot.external) and self.station in ("", station.name)
        return self.values if has_them else ()
