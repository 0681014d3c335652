"""Conditions of guarded moves that no reading of their sensor can make true, known without a run."""

from collections.abc import Mapping

from ropsim import icr
from ropsim.core import Diagnostic, Severity, Span, define
from ropsim.flow import Comparison, Guard
from ropsim.model import Cell, Signal, Station, reading_range
from ropsim.workbench.compiling.dry_arm import program_arm
from ropsim.workbench.compiling.line_moves import dry_runs

BEYOND_RANGE = define(
    "X932",
    "threshold-beyond-range",
    Severity.WARNING,
    "a guarded move waits for a reading beyond the range of its sensor",
    """
A reading is never greater than the range of its sensor, nor less than its lower end. A condition beyond comes
never true: the move goes on to its target, however hard the tool is pressed, or is true from the start.
`ropsim check` and the editor say so for `until` at moves that a dry run comes to, not for `wait until`.

**How to mend it.** Give the condition a number within the range, or the sensor in the cell file a greater
`range`.

```task
lin (600, 0, 80) until force_z > 10 N   # X932 with range = 8
lin (600, 0, 80) until force_z > 6 N
```
""",
)


def thresholds(code: icr.Program, cell: Cell, station: Station) -> tuple[Diagnostic, ...]:
    """Return a finding for each such condition of a program, once, in order of place.

    Args:
        code: of the program.
        cell: in which it runs.
        station: that runs it.
    """
    sensed = {one.name: one for one in cell.signals.values() if one.sensor is not None and one.analog}
    if not any(channel.name in sensed for channel in code.channels):
        return ()
    arm = program_arm(code, cell, station)
    found = dict[Span, Diagnostic]()

    def world(inputs: Mapping[str, bool | int | float]) -> icr.StillWorld:
        return icr.StillWorld(inputs, arm=arm)

    for run in dry_runs(code, world):
        for move in run:
            span, guard = move.origin.span, move.guard
            signal = sensed.get(guard.channel) if guard is not None else None
            if guard is not None and signal is not None and span is not None:
                message = _beyond(guard, signal)
                if message:
                    hint = "take a number within it, or give the sensor a greater `range`"
                    found.setdefault(span, BEYOND_RANGE.at(span, message, hint=hint))
    return tuple(
        sorted(found.values(), key=lambda one: (one.span.line, one.span.column) if one.span else (0, 0))
    )


def _beyond(guard: Guard, signal: Signal) -> str:
    """Return what is wrong with a condition; empty where a reading can make it true and another one not."""
    if signal.sensor is None or guard.comparison is Comparison.IS:
        return ""
    least, most = reading_range(signal.sensor)
    unit, words = signal.sensor.unit, f"`{signal.name}` reads {least:.6g} to {most:.6g} {signal.sensor.unit}"
    above = guard.comparison is Comparison.ABOVE
    if (guard.value >= most) if above else (guard.value <= least):
        return f"{words} and is never {'above' if above else 'below'} {guard.value:.6g} {unit}"
    if (guard.value < least) if above else (guard.value > most):
        return f"{words} and is always {'above' if above else 'below'} {guard.value:.6g} {unit}"
    return ""
