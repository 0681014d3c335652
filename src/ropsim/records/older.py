"""Recordings of older formats: their document becomes one of the present format.

Version 3 contained changes of inputs only, not of the override; otherwise it is the present form. Version 1
had no placements. Versions 1 and 2 had the facts as an untyped mapping, of each event the figures as one, and
rows for values of a channel between changes.
"""

from collections.abc import Mapping
from contextlib import suppress

import numpy as np

from ropsim.flow import Channel, ChannelGroup
from ropsim.spatial import Array, frozen

WITHOUT_PLACEMENTS = 1
"""The first version."""

UNTYPED = (WITHOUT_PLACEMENTS, 2)
"""Versions whose document has to become one of the present form."""

OLDER = (*UNTYPED, 3)
"""Versions that are read in addition to the present one."""

_STATION = "robot"
_HELD = ("line", "move", "gripper", "payload")
_TCP = ("attained_", "command_", "path_")
_PROGRAM = ("program", "source", "icr_id", "skipped_moves")
_RUN = ("ropsim", "project", "fidelity", "record_hz", "checked", "inputs", "parts_left", "destinations")
_WORDS = {"True": True, "False": False}
_AXIS = ("lower", "upper", "max_speed", "max_effort", "max_current")

Entry = Mapping[str, object]


def upgraded(plain: Entry) -> dict[str, object]:
    """Return the document of an older recording in the present form; errors in it are kept."""
    header = _mapping(plain.get("header"))
    channels = {name: _channel(name, _mapping(one)) for name, one in _mapping(plain.get("channels")).items()}
    events = [_event(_mapping(one)) for one in _list(plain.get("events"))]
    facts: object = {**_kept(header, _RUN), "stations": [_station(header)]} if header else plain.get("header")
    return {
        **plain,
        "placements": [] if plain.get("version") == WITHOUT_PLACEMENTS else plain.get("placements"),
        "facts": facts,
        "channels": channels,
        "events": events,
    }


def is_held(name: str) -> bool:
    """Return whether a channel of this name had rows of a value that holds between changes."""
    return name in _HELD or name.startswith("signal.")


def held(rows: Channel, time: Array) -> Channel:
    """Return a channel of rows as one that holds its values; at the rows they are the same.

    When a change was between two rows is not known: it counts from halfway.

    Args:
        rows: the channel; one that has no row, or several columns, stays unchanged.
        time: of the rows [s], shape (n,).
    """
    values = rows.values
    if values.ndim != 1 or not len(values):
        return rows
    same = (values[1:] == values[:-1]) | (np.isnan(values[1:]) & np.isnan(values[:-1]))
    changed = np.concatenate([[0], np.flatnonzero(~same) + 1])
    times = 0.5 * (time[np.maximum(changed - 1, 0)] + time[changed])
    return Channel(
        frozen(values[changed]), rows.unit, (), rows.description, rows.group, rows.subject, frozen(times)
    )


def _station(header: Entry) -> dict[str, object]:
    robot, rates = _mapping(header.get("robot")), _mapping(header.get("rates"))
    names = _list(robot.get("joint_names"))
    return {
        "name": _STATION,
        **_kept(header, _PROGRAM),
        **_kept(rates, ("control_hz", "interpolation_ticks", "plant_steps")),
        **_kept(robot, ("title", "origins")),
        **({"robot": robot["name"]} if "name" in robot else {}),
        "axes": [
            {"name": name, **_at(robot, "joint_types", "type", k), **_limits(robot, k)}
            for k, name in enumerate(names)
        ],
    }


def _limits(robot: Entry, k: int) -> dict[str, object]:
    found: dict[str, object] = {}
    for key in _AXIS:
        found |= _at(robot, key, key, k)
    return found


def _channel(name: str, entry: Entry) -> dict[str, object]:
    signal = name.startswith("signal.")
    if signal:
        group = ChannelGroup.SIGNALS
    elif name.startswith(_TCP):
        group = ChannelGroup.TCP
    else:
        group = ChannelGroup.PROGRAM if is_held(name) or not entry.get("columns") else ChannelGroup.JOINTS
    return {**entry, "group": group.value, "subject": "" if signal else _STATION, "held": False}


def _event(entry: Entry) -> dict[str, object]:
    """Return an event with its figures as fields; it has an origin if it has a pass."""
    data, kind, text = _mapping(entry.get("data")), entry.get("kind"), entry.get("text")
    fields = {**data, **_kept(entry, ("time", "duration", "kind"))}
    if "visit" in data:
        calls = _list(data.get("calls"))
        fields["station"] = _STATION
        fields["origin"] = {
            "span": entry.get("span"),
            "visit": data["visit"],
            "calls": calls,
            "call_serials": [0] * len(calls),
        }
    match kind:
        case "move" | "skip":
            fields["motion"] = data.get("kind")
        case "task":
            fields["station"] = _STATION
        case "wait":
            fields["pause"] = entry.get("duration")
        case "message":
            fields["text"] = text
        case "output":
            fields["value"] = _value(str(text).partition(" = ")[2][:40])
        case "input":
            fields["signal"] = data.get("channel")
    return fields


def _value(text: str) -> object:
    """Return the value of an output, from the text of the event; None if it is no value."""
    if text in _WORDS:
        return _WORDS[text]
    for kind in (int, float):
        with suppress(ValueError):
            return kind(text)
    return None


def _at(robot: Entry, key: str, name: str, k: int) -> dict[str, object]:
    values = _list(robot.get(key))
    return {name: values[k]} if k < len(values) and values[k] is not None else {}


def _kept(entry: Entry, names: tuple[str, ...]) -> dict[str, object]:
    return {name: entry[name] for name in names if name in entry}


def _mapping(value: object) -> Entry:
    return value if isinstance(value, dict) else {}


def _list(value: object) -> list[object]:
    return value if isinstance(value, list) else []
