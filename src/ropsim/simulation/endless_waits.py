"""Waits for signals that nothing in the cell can change any more: found at once, instead of waited out."""

from collections.abc import Mapping

from ropsim.core import Diagnostic
from ropsim.flow import Origin
from ropsim.icr import Program
from ropsim.simulation.cell_run import CellRun
from ropsim.simulation.devices.device_run import NEVER
from ropsim.simulation.diagnostics import WAITS_IN_VAIN
from ropsim.simulation.run_options import RunOptions
from ropsim.simulation.serving import is_needed
from ropsim.simulation.station_run import StationRun


def are_endless(run: CellRun, options: RunOptions) -> bool:
    """Return whether every program at work waits for a channel and nothing can happen any more.

    That is so when none of the waits has a timeout, no channel has its value, no script of the cell changes
    one of them later, no device has anything left to do, and nobody may press keys. A program that does
    nothing but look at channels in a loop, and has found the same twice, waits too. What a sensor interface
    of a user's own delivers cannot be foreseen. A serving program that is not needed any more ends by itself.

    Args:
        run: the cell, between two steps of its stations.
        options: of the run.
    """
    stations = [run.stations[name] for name in run.at_work]
    if not all(_waits(at) and is_needed(run, at) for at in stations):
        return False
    if options.sensors is not None or run.watch.may_press:
        return False
    if any(device.due != NEVER for device in run.devices.values()):
        return False
    return all(_stays(run, at) for at in stations)


def end_waits(run: CellRun, programs: Mapping[str, Program]) -> None:
    """End the programs at work where they wait, each with a finding (S742) but for those that serve."""
    waiting = [run.stations[name] for name in run.at_work]
    run.findings += [_finding(run, at, programs) for at in waiting if not at.station.serves]
    for at in waiting:
        at.in_vain = True


def _waits(at: StationRun) -> bool:
    if at.in_vain:
        return False
    return at.awaits.timeout is None if at.awaits else at.polled is not None


def _stays(run: CellRun, at: StationRun) -> bool:
    """Return whether the channels stay as they are, and the one that is waited for has not come."""
    for channel in _channels(at):
        sample = run.sensors.read(channel, at.time)
        value = sample.value if sample.valid else False
        there = value == at.awaits.value if at.awaits else value != _reads(at)[channel]
        if there or run.sensors.changes_after(channel, at.time):
            return False
    return True


def _channels(at: StationRun) -> tuple[str, ...]:
    return (at.awaits.channel,) if at.awaits else tuple(sorted(_reads(at)))


def _reads(at: StationRun) -> Mapping[str, bool | float]:
    return at.polled.reads if at.polled else {}


def _finding(run: CellRun, at: StationRun, programs: Mapping[str, Program]) -> Diagnostic:
    name, origin = at.station.name, _origin(at)
    notes: list[str] = []
    hints: list[str] = []
    for channel in _channels(at):
        devices = [one for one, device in run.devices.items() if channel in device.device.tells]
        setters = (
            [] if _is_input(run, channel) else [one for one in programs if _sets(programs[one], channel)]
        )
        notes += [f"`{channel}` is set by the device `{one}`, which stands" for one in devices]
        for one in setters:
            whose = "this program" if one == name else f"the program of `{one}`"
            notes.append(f"`{channel}` is set by {whose}, which {_state(run, one)}")
        if not devices and not setters:
            notes.append(_nobody(run, channel))
        hints.append(_hint(run, channel, devices, setters))
    return WAITS_IN_VAIN.at(
        origin.span,
        f"`{name}` waits for {_wanted(at)} for ever, from t = {at.time:.2f} s on: {'; '.join(notes)}",
        label=f"pass {origin.visit}",
        hint=hints[0],
        data={
            "station": name,
            "channel": ", ".join(_channels(at)),
            "time_s": at.time,
            "pass": origin.visit,
        },
    )


def _origin(at: StationRun) -> Origin:
    step = at.awaits or at.polled
    return step.origin if step else Origin()


def _state(run: CellRun, name: str) -> str:
    if name not in run.at_work:
        return "has ended"
    at = run.stations[name]
    span = _origin(at).span
    return f"waits for {_wanted(at)}{f' on line {span.line}' if span else ''}"


def _nobody(run: CellRun, channel: str) -> str:
    if _is_input(run, channel):
        return f"`{channel}` is an input, and no change of it lies ahead"
    return f"`{channel}` is an output that no program sets"


def _hint(run: CellRun, channel: str, devices: list[str], setters: list[str]) -> str:
    if devices:
        return f"look at what `{devices[0]}` follows and at what lies on it"
    if setters:
        return "let one program speak before it waits for the other, or give the wait a timeout"
    if _is_input(run, channel):
        return f"give `{channel}` `changes` in the cell file, or press its key in a live run"
    return f"set `{channel}` in the program of another station, or wait for an input"


def _sets(program: Program, channel: str) -> bool:
    steps = (step for procedure in program.procedures for step in procedure.code)
    return any(step.mnemonic == "OUT" and step.operands[0] == channel for step in steps)


def _is_input(run: CellRun, channel: str) -> bool:
    signal = run.cell.signals.get(channel)
    return signal is not None and signal.is_input


def _wanted(at: StationRun) -> str:
    if at.awaits:
        return f"`{at.awaits.channel}` to {'come on' if at.awaits.value else 'go off'}"
    return "a change of " + " or ".join(f"`{channel}`" for channel in _channels(at))
