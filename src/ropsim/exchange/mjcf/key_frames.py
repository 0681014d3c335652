"""Key frames of MJCF: the first one is the home position."""

from collections.abc import Iterable, Mapping

from ropsim.exchange.assembly.description import Connection, Motion
from ropsim.exchange.files.values import finite
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION
from ropsim.exchange.losses.notes import Notes

_UNREAD = Topic(
    LOST_DESCRIPTION,
    "key frames",
    "the home position of key frames {} does not go over",
    "write finite numbers into `qpos`, as many as the joints of the file have coordinates",
)


def home_of(
    root: Element,
    connections: Iterable[Connection],
    places: Mapping[str, int],
    coordinates: int,
    notes: Notes,
) -> tuple[tuple[str, float], ...]:
    """Return the coordinates of connections in the first key frame that has some [rad | m].

    Args:
        root: of the file.
        connections: of the robot.
        places: of the coordinates of connections by name, in the order of MuJoCo.
        coordinates: number of all coordinates of the file, including the coordinates of free bodies.
        notes: for a frame that is not read.
    """
    keys = [key for frame in root.all("keyframe") for key in frame.all("key") if "qpos" in key.attributes]
    if not keys:
        return ()
    moving = [one.name for one in connections if one.motion is not Motion.NONE]
    values = [finite(word) for word in keys[0].attributes["qpos"].split()]
    found = {name: values[places[name]] for name in moving} if len(values) == coordinates else {}
    home = tuple((name, value) for name, value in found.items() if value is not None)
    if len(home) < len(moving):
        detail = f"it has {len(values)} values, the joints have {coordinates} coordinates"
        if len(values) == coordinates:
            detail = "it has what is no finite number"
        notes.gather(_UNREAD, keys[0].span, [keys[0].attributes.get("name", "without a name")], detail)
        return ()
    return home
