"""Mounts of entities of a cell file other than objects: devices, and bodies moved by external axes."""

from collections.abc import Mapping
from typing import TypeAlias

from ropsim.model import BASE_LINK, Device, RobotModel, Station, external_links, held_arm, link_name, mount_of
from ropsim.spatial import Pose

Mount: TypeAlias = tuple[str, Pose]
"""Name of a body that things hang on, and the frame in it that they are given in."""


def mounts_of(stations: Mapping[str, Station | None], devices: Mapping[str, Device]) -> dict[str, Mount]:
    """Return all names except of objects that `parent` can have in a cell file.

    These are `track` and `positioner` of each station, with the prefix of the station if it has a name
    (`left/positioner`), the names of stations of one axis, and the names of devices.

    Args:
        stations: by name, None for one whose robot is unknown.
        devices: by name.
    """
    known = {name: station for name, station in stations.items() if station is not None}
    found = axes_of(known)
    for name, station in known.items():
        if not station.robot.has_arm:
            found[name] = (link_name(station.robot.tip + 1, name), station.robot.X_nM)
    return found | {name: mount_of(device) for name, device in devices.items()}


def axes_of(stations: Mapping[str, Station | None]) -> dict[str, Mount]:
    """Return the external axes of the arms of some stations; arguments and names as in `mounts_of`."""
    return {
        f"{station.prefix}{word}": (link_name(link + 1, name), Pose())
        for name, station in stations.items()
        if station is not None and station.robot.has_arm
        for word, link in _external(station.robot).items()
    }


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
