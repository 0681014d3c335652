"""Limits of axes that MJCF has no place for, in its `custom` fields, axis by axis."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from ropsim.exchange.assembly.description import Connection
from ropsim.exchange.files.values import numbers_of
from ropsim.exchange.files.xml_text import Tag, numbers, tag
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.notes import Notes
from ropsim.model import Joint

FIELDS: Mapping[str, str] = {
    "ropsim_max_speed": "max_speed",
    "ropsim_max_acceleration": "max_acceleration",
    "ropsim_max_jerk": "max_jerk",
}
"""Names of the fields, with the attributes of a joint that they hold [rad, m and s]."""


def axis_limits(joints: Sequence[Joint]) -> tuple[Tag, ...]:
    """Return the `custom` with the limits of axes."""
    rows = [
        tag("numeric", [("name", name), ("data", numbers(getattr(one, attribute) for one in joints))])
        for name, attribute in FIELDS.items()
    ]
    return (tag("custom", (), *rows),)


def limited(
    connections: tuple[Connection, ...], axes: tuple[str, ...], root: Element, notes: Notes
) -> tuple[Connection, ...]:
    """Return connections with the limits that the `custom` of a file says of its axes, in their order."""
    found: dict[str, dict[str, Any]] = {name: {} for name in axes}
    for numeric in (one for custom in root.all("custom") for one in custom.all("numeric")):
        attribute = FIELDS.get(numeric.attributes.get("name", ""), "").removeprefix("max_")
        values = numbers_of(numeric, "data", notes, (0.0,) * len(axes)) if attribute else ()
        for name, value in zip(axes, values, strict=False):
            found[name][attribute] = value if value > 0.0 else None
    return tuple(replace(one, limits=replace(one.limits, **found.get(one.name, {}))) for one in connections)
