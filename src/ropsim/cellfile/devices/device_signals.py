"""Signals that devices follow, and findings on them."""

from collections.abc import Iterator, Mapping

from ropsim.core import Severity, define
from ropsim.model import BeltDrive, Device, DeviceDrive, IndexDrive, Signal, SwitchDrive
from ropsim.tomltext import TomlTable, cut

INPUT_SET_TWICE = define(
    "X820",
    "input-set-twice",
    Severity.ERROR,
    "two things set the same input",
    """
A device tells by an input where it is: `is_on`, `is_off`, `in_place`, or the `signal` of a `stop`. What such
an input says must come from one place only; another device or `changes` of the signal would contradict it.
Give each of them an input of its own.

```toml
[devices.door]
is_on = "door_open"
is_off = "door_closed"         # not "door_open" again

[signals.door_open]
input = 1                      # without `changes`
```
""",
)

DEVICES_IN_A_CIRCLE = define(
    "X821",
    "devices-in-a-circle",
    Severity.ERROR,
    "devices follow each other in a circle",
    """
A device follows an input that it sets itself, or that a device sets which in the end follows it. It would
start and stop itself without end, in no time. Let a device follow an output, and a program set that when the
input says so.

```toml
[devices.door]
signal = "door_closed"         # wrong: it leaves `off` as soon as it is there, and comes back at once
is_off = "door_closed"
```
""",
)


Place = tuple[str, ...]
"""Keys from the table of a device to a value."""


def check_device_signals(
    devices: Mapping[str, Device], tables: Mapping[str, TomlTable], signals: Mapping[str, Signal]
) -> None:
    """Note inputs that are set twice, and the first circle in which devices follow each other.

    Args:
        devices: of the cell, by name.
        tables: where each one is described.
        signals: of the cell, by name.
    """
    setters: dict[str, str] = {}
    for name, device in devices.items():
        for place, signal in _told(device):
            if signal in setters:
                again = "" if setters[signal] != name else " for something else"
                _note_twice(tables[name], place, signal, f"is set by device `{cut(setters[signal])}`{again}")
            elif signals[signal].changes:
                _note_twice(tables[name], place, signal, "has `changes` of its own")
            setters.setdefault(signal, name)
    followed = {
        name: [setters[signal] for signal in device.listens if signal in setters]
        for name, device in devices.items()
    }
    ring = _ring(followed)
    if ring:
        table, (key, signal) = tables[ring[0]], _listened(devices[ring[0]])
        way = " follows ".join(f"`{cut(name)}`" for name in (*ring, ring[0]))
        hint = "follow an output, and let a program set it when the input says so"
        table.findings.add(
            DEVICES_IN_A_CIRCLE, table.value_span(key), f"{way}, by the input `{cut(signal)}`", hint
        )


def _note_twice(table: TomlTable, place: Place, signal: str, why: str) -> None:
    hint = "give the device an input of its own"
    table.findings.add(INPUT_SET_TWICE, table.value_span(*place), f"`{cut(signal)}` {why}", hint)


def _told(device: Device) -> Iterator[tuple[Place, str]]:
    """Yield the inputs that a device sets, with the places where they are named."""
    return ((place, signal) for place, signal in _places(device.drive) if signal)


def _places(drive: DeviceDrive) -> tuple[tuple[Place, str], ...]:
    """Return the places where a drive can name inputs that it sets, with those; empty for none."""
    match drive:
        case BeltDrive(barrier=barrier):
            return ((("stop", "signal"), barrier.signal if barrier else ""),)
        case SwitchDrive(is_off=off, is_on=on):
            return (("is_off",), off), (("is_on",), on)
        case IndexDrive(in_place=in_place):
            return ((("in_place",), in_place),)


def _listened(device: Device) -> tuple[str, str]:
    """Return key and name of the signal that a device follows."""
    (signal,) = device.listens
    match device.drive:
        case BeltDrive():
            return "run", signal
        case SwitchDrive() | IndexDrive():
            return "signal", signal


def _ring(followed: Mapping[str, list[str]]) -> tuple[str, ...]:
    """Return devices each of which follows the next, the last one the first; empty where none do.

    A device follows one at most.
    """
    done: set[str] = set()
    for start in followed:
        way: dict[str, None] = {}
        name = start
        while name not in done and name not in way:
            way[name] = None
            above = followed[name]
            if not above:
                break
            name = above[0]
        if name in way and followed[name]:
            names = tuple(way)
            return names[names.index(name) :]
        done.update(way)
    return ()
