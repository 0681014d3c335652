"""Interventions in a run in addition to the signal changes of the cell: keys, or a record of them."""

import math
from collections.abc import Iterable
from dataclasses import replace

from ropsim.controller import with_change
from ropsim.core import Diagnostic, did_you_mean
from ropsim.flow import InputChange, InputEvent, in_time
from ropsim.model import Cell, Signal
from ropsim.simulation.diagnostics.input_diagnostics import INPUT_NOT_USABLE
from ropsim.simulation.records.track import Track
from ropsim.simulation.servo.checks import check_share, check_time
from ropsim.simulation.state.run_options import RunOptions


def usable_inputs(
    cell: Cell, inputs: Iterable[InputChange]
) -> tuple[tuple[InputChange, ...], tuple[Diagnostic, ...]]:
    """Return the changes that a cell can take, in order of time, and a finding per signal that it cannot.

    Those at one time keep their order: of two of one signal the one given last holds.
    """
    usable: list[InputChange] = []
    wrong: dict[str, Diagnostic] = {}
    for change in inputs:
        reason, hint = _wrong(cell, change)
        if not reason:
            usable.append(change)
        elif change.signal not in wrong:
            message = f"recorded input `{change.signal}` is left out: {reason}"
            wrong[change.signal] = INPUT_NOT_USABLE.at(None, message, hint=hint)
    return in_time(usable), tuple(wrong.values())


def with_inputs(cell: Cell, inputs: Iterable[InputChange]) -> Cell:
    """Return the cell with the inputs merged into the changes of its signals.

    Args:
        cell: has every signal that is named, as an input.
        inputs: in any order; of several changes of one signal at one time the last one holds.
    """
    signals = dict(cell.signals)
    for change in in_time(inputs):
        signals[change.signal] = with_change(signals[change.signal], change.time, change.value)
    return replace(cell, signals=signals)


def signal_track(signal: Signal, control_hz: int) -> Track:
    """Return the values over time of a signal from its changes."""
    track = Track([0], [0.0])
    track.set(0, signal.initial)
    for time, value in signal.changes:
        track.set(round(time * control_hz), value)
    return track


def input_events(inputs: Iterable[InputChange]) -> list[InputEvent]:
    """Return one event per change."""
    return [InputEvent(one.time, signal=one.signal, value=one.value) for one in inputs]


def check_interventions(options: RunOptions) -> None:
    """Make sure that the override and the end by hand are such as a live run can be given.

    Raises:
        OptionError: S703, a time is none, or an override is not within 0 to 1.
    """
    for change in options.overrides:
        check_time("time of an override", change.time)
        check_share("override", change.value)
    if options.stopped is not None:
        check_time("stopped", options.stopped)


def _wrong(cell: Cell, change: InputChange) -> tuple[str, str]:
    """Return why a cell cannot take a change, and the hint; both empty if it can."""
    signal = cell.signals.get(change.signal)
    inputs = sorted(one.name for one in cell.signals.values() if one.is_input)
    known = (
        f"inputs of the cell are {', '.join(f'`{name}`' for name in inputs)}"
        if inputs
        else "the cell has no inputs"
    )
    if signal is None:
        return "the cell has no such signal", did_you_mean(change.signal, inputs) or known
    if not signal.is_input:
        return "it is an output of the cell, only the program sets it", known
    if not math.isfinite(change.time) or change.time < 0.0:
        return f"its time is {change.time:g} s, needed is a number from 0 on", "mend its `time` in the inputs"
    if not math.isfinite(change.value) or (not signal.analog and change.value not in {0.0, 1.0}):
        needed = "a number" if signal.analog else "0 or 1"
        return f"its value is {change.value:g}, needed is {needed}", "mend its `value` in the inputs"
    return "", ""
