"""Signals of a cell."""

from collections.abc import Mapping

from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.devices.tool_sensors import read_sensor
from ropsim.model import Signal, Station
from ropsim.tomltext import CONFLICTING_KEYS, NUMBER, TIME, Quantity, TomlTable, Units

_SWITCH = Quantity("", 1.0, 0.0, 1.0)
_MOST_CHANNELS = 65_535


def read_signals(
    tables: Mapping[str, TomlTable], stations: Mapping[str, Station | None], units: Units
) -> dict[str, Signal]:
    """Return the channels by name.

    Args:
        tables: of the signals, by name.
        stations: of the cell, by name, at whose tools sensors are.
        units: of the file.
    """
    signals = {}
    taken: dict[tuple[bool, bool, int], str] = {}
    for name, table in tables.items():
        signal = _signal(name, table, stations, units)
        signals[name] = signal
        place = (signal.is_input, signal.analog, signal.channel)
        if signal.channel and place in taken:
            key = "input" if signal.is_input else "output"
            message = f"channel {signal.channel} is taken by `{taken[place]}`"
            hint = "give every signal of one direction and sort its own number"
            table.findings.add(kinds.DUPLICATE_CELL_NAME, table.value_span(key), message, hint)
        taken.setdefault(place, name)
    return signals


def _signal(name: str, table: TomlTable, stations: Mapping[str, Station | None], units: Units) -> Signal:
    is_input, is_output = "input" in table, "output" in table
    if is_input and is_output:
        message = f"`{name}` is both an input and an output"
        hint = "keep `input` or `output`"
        table.findings.add(CONFLICTING_KEYS, table.key_span("output"), message, hint)
    elif not is_input and not is_output:
        table.require("input")
    channel = table.integer("input" if is_input else "output", 1, _MOST_CHANNELS, 0)
    analog = table.flag("analog", default=False)
    quantity = NUMBER if analog else _SWITCH
    initial = _level(table, ("initial",), table.values["initial"], quantity) if "initial" in table else 0.0
    changes = _changes(table, quantity) if "changes" in table else ()
    if changes and is_output and not is_input:
        message = f"`{name}` is an output, only the program changes it"
        hint = "remove `changes`, or make it an input"
        table.findings.add(kinds.CHANGES_OF_OUTPUT, table.key_span("changes"), message, hint)
    sort = float if analog else bool
    sensor = read_sensor(table, stations, units, sort) if "sensor" in table else None
    other = next((key for key in ("output", "changes", "initial") if key in table), "")
    if sensor is not None and other:
        message = f"`{name}` is measured by a sensor, and has `{other}`"
        hint = f"keep `sensor` or `{other}`"
        table.findings.add(CONFLICTING_KEYS, table.key_span(other), message, hint)
    table.finish()
    return Signal(name, is_input, analog, initial, changes, channel, sensor)


def _level(table: TomlTable, steps: tuple[str | int, ...], value: object, quantity: Quantity) -> float:
    """Return a signal value; digital ones may be written as true and false."""
    if isinstance(value, bool) and quantity is _SWITCH:
        return float(value)
    level = table.number_at(steps, value, quantity, 0.0)
    if quantity is _SWITCH and level not in {0.0, 1.0}:
        table.wrong_type(steps, value, "0, 1, `true` or `false`")
    return level


def _changes(table: TomlTable, quantity: Quantity) -> tuple[tuple[float, float], ...]:
    """Return (time [s], value) pairs in order of time."""
    value = table.values["changes"]
    if not isinstance(value, list):
        table.wrong_type(("changes",), value, "a list of `[time, value]` pairs")
        return ()
    changes: list[tuple[float, float]] = []
    for k, pair in enumerate(value):
        steps = ("changes", k)
        if not isinstance(pair, list) or len(pair) != 2:
            table.wrong_type(steps, pair, "a pair `[time, value]`")
            continue
        time = table.number_at((*steps, 0), pair[0], TIME, 0.0)
        if changes and time <= changes[-1][0]:
            message = f"the change at {time:g} s comes after the one at {changes[-1][0]:g} s"
            hint = "write the changes in order of time"
            table.findings.add(kinds.UNORDERED_CHANGES, table.value_span(*steps), message, hint)
        changes.append((time, _level(table, (*steps, 1), pair[1], quantity)))
    return tuple(changes)
