"""On what things of a cell file can hang beside objects: devices, and what external axes move."""

from collections.abc import Mapping
from typing import TypeAlias

from ropsim.model import BASE_LINK, Device, RobotModel, Station, external_links, held_arm, link_name, mount_of
from ropsim.spatial import Pose

Mount: TypeAlias = tuple[str, Pose]
"""Name of a body that things hang on, and the frame in it that they are given in."""


def mounts_of(stations: Mapping[str, Station | None], devices: Mapping[str, Device]) -> dict[str, Mount]:
    """Return all names but those of objects that `parent` can have in a cell file.

    These are `track` and `positioner` of each station that has one, behind the name of the station where it
    has one of its own (`left/positioner`), and the names of devices.

    Args:
        stations: by name, None for one whose robot is unknown.
        devices: by name.
    """
    found = {
        f"{station.prefix}{word}": (link_name(link + 1, name), Pose())
        for name, station in stations.items()
        if station is not None
        for word, link in _external(station.robot).items()
    }
    return found | {name: mount_of(device) for name, device in devices.items()}


def _external(robot: RobotModel) -> dict[str, int]:
    """Return the numbers of the links that carry the arm and the workpiece, by the key of the cell file."""
    if not robot.external:
        return {}
    found, carrier = {}, held_arm(robot).carrier
    if carrier != BASE_LINK:
        found["track"] = carrier
    last = external_links(robot)[-1]
    if last != carrier:
        found["positioner"] = last
    return found
