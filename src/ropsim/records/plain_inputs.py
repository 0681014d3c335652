"""Interventions in a run as plain values of input files, and back."""

import math
from collections.abc import Mapping

from ropsim.flow import InputChange, Interventions, OverrideChange
from ropsim.records.diagnostics import INPUTS_UNREADABLE, InputsError

LATEST = 1e6
"""Latest time at which something is given to a run [s]."""

_FORM = (
    'a list of `{"signal": "NAME", "time": SECONDS, "value": NUMBER}`, '
    '`{"override": SHARE, "time": SECONDS}` and `{"stop": true, "time": SECONDS}`'
)


def plain_from_inputs(given: Interventions) -> list[Mapping[str, object]]:
    """Return interventions as plain values, in order of time; `inputs_from_plain` takes them."""
    entries: list[tuple[float, Mapping[str, object]]] = [
        *((one.time, {"signal": one.signal, "time": one.time, "value": one.value}) for one in given.inputs),
        *((one.time, {"override": one.value, "time": one.time}) for one in given.overrides),
    ]
    if given.stopped is not None:
        entries.append((given.stopped, {"stop": True, "time": given.stopped}))
    return [entry for _, entry in sorted(entries, key=lambda entry: entry[0])]


def inputs_from_plain(plain: object, source: str) -> Interventions:
    """Return the interventions of plain values.

    Args:
        plain: list of mappings: of `signal`, `time` [s] and `value`; of `override`, 0 to 1, and `time`; once
            of `stop`, True, and `time`.
        source: where they are from, for messages.

    Raises:
        InputsError: X878, they are not of that form.
    """
    if not isinstance(plain, (list, tuple)):
        raise unreadable(source, f"found a `{type(plain).__name__}`, needed is {_FORM}")
    found = [_entry(one, f"{source}, entry {k}") for k, one in enumerate(plain, start=1)]
    stops = [one for one in found if isinstance(one, float)]
    if len(stops) > 1:
        raise unreadable(source, f"it has {len(stops)} entries with `stop`, a run ends once")
    return Interventions(
        tuple(one for one in found if isinstance(one, InputChange)),
        tuple(one for one in found if isinstance(one, OverrideChange)),
        stops[0] if stops else None,
    )


def finite(number: float, key: str, source: str) -> float:
    """Return a number of an entry.

    Raises:
        InputsError: X878, it is not finite, or a time after the end of every run.
    """
    if not math.isfinite(number):
        raise unreadable(source, f"`{key}` must be a finite number")
    if key in ("time", "stopped") and number > LATEST:
        raise unreadable(source, f"`{key}` is {number:g} s, at most {LATEST:g} s are allowed")
    return number


def share(value: float, source: str) -> float:
    """Return the value of an override.

    Raises:
        InputsError: X878, it is not from 0 to 1.
    """
    if not 0.0 <= value <= 1.0:
        raise unreadable(source, f"an override is a number from 0 to 1, found {value:g}")
    return value


def unreadable(source: str, reason: str) -> InputsError:
    """Return the error for unreadable interventions of a source."""
    hint = "record the inputs again, or correct the file; docs/reference/recording.md tells its form"
    return InputsError(INPUTS_UNREADABLE.at(None, f"inputs from `{source}`: {reason}", hint=hint))


def _entry(entry: object, source: str) -> InputChange | OverrideChange | float:
    """Return the intervention of an entry; a stop by its time."""
    if not isinstance(entry, dict):
        raise unreadable(source, f"found a `{type(entry).__name__}`, needed is {_FORM}")
    kinds = [key for key in ("signal", "override", "stop") if key in entry]
    if len(kinds) > 1:
        raise unreadable(source, f"it has `{kinds[0]}` and `{kinds[1]}`, one of them is needed")
    time = _number(entry, "time", source)
    if kinds == ["override"]:
        return OverrideChange(time, share(_number(entry, "override", source), source))
    if kinds == ["stop"]:
        if entry["stop"] is not True:
            raise unreadable(source, "`stop` must be `true`")
        return time
    signal = entry.get("signal")
    if not isinstance(signal, str):
        raise unreadable(source, "`signal` must be the name of an input")
    return InputChange(time, signal, _number(entry, "value", source))


def _number(entry: dict[object, object], key: str, source: str) -> float:
    value = entry.get(key)
    if isinstance(value, bool) and key == "value":
        return float(value)
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise unreadable(source, f"`{key}` must be a number")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    return finite(number, key, source)
