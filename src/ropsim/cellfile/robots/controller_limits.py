"""Limits of a controller as `cell.toml` writes them, and a cell file that has them."""

from collections.abc import Mapping, Sequence

from ropsim.core import SourceText, toml_values
from ropsim.model import ROBOT, JointType
from ropsim.tomltext import Quantity, Units, with_values

_OF_JOINTS = ("joint_speed", "joint_acceleration", "joint_jerk")
_OF_PATH = ("path_speed", "path_acceleration", "path_jerk")
_OF_ORIENTATION = ("orientation_speed", "orientation_acceleration", "orientation_jerk")

Limits = Mapping[str, float | Sequence[float]]
"""By the keys of `[controller]`: numbers [SI], a list of them for the joints; `look_ahead` counts moves."""


def limits_section(text: SourceText, station: str) -> tuple[str, ...]:
    """Return the path of the section of a valid cell file in which a station has its controller."""
    if station == ROBOT and ROBOT in toml_values("\n".join(text.lines)):
        return ("controller",)
    return ("stations", station, "controller")


def written_limits(text: SourceText, axes: Sequence[JointType], limits: Limits) -> dict[str, str]:
    """Return limits as TOML values in the units of a valid cell file, by key.

    Args:
        text: the file.
        axes: whether each axis turns or slides.
        limits: that are written.
    """
    units = _units(text)
    written = {}
    for key, value in limits.items():
        if isinstance(value, Sequence):
            order = _OF_JOINTS.index(key) + 1
            each = zip(value, (units.rate(one, order) for one in axes), strict=True)
            written[key] = f"[{', '.join(_number(one, quantity) for one, quantity in each)}]"
        elif key == "look_ahead":
            written[key] = str(round(value))
        elif key in _OF_PATH:
            written[key] = _number(value, units.path(_OF_PATH.index(key) + 1, 1.0))
        else:
            written[key] = _number(value, units.orientation(_OF_ORIENTATION.index(key) + 1, 1.0))
    return written


def with_limits(text: SourceText, station: str, values: Mapping[str, str]) -> SourceText:
    """Return a valid cell file whose controller of a station has limits, otherwise unchanged.

    Args:
        text: the file.
        station: name of the station.
        values: as `written_limits` returns them.
    """
    return SourceText(text.name, with_values(text, limits_section(text, station), values))


def _units(text: SourceText) -> Units:
    said = toml_values("\n".join(text.lines)).get("units")
    given = said if isinstance(said, dict) else {}
    return Units(str(given.get("length", "mm")), str(given.get("angle", "deg")))


def _number(value: float, quantity: Quantity) -> str:
    return (
        f"{value / quantity.scale:.5g}" if value < 1e5 * quantity.scale else f"{value / quantity.scale:.0f}"
    )
