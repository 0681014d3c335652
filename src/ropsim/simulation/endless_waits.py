"""Waits for signals that nothing in the cell can change any more: found at once, instead of waited out."""

from collections.abc import Mapping

from ropsim.core import Diagnostic
from ropsim.flow import AwaitInstruction
from ropsim.icr import Program
from ropsim.simulation.cell_run import CellRun
from ropsim.simulation.devices.device_run import NEVER
from ropsim.simulation.diagnostics import WAITS_IN_VAIN
from ropsim.simulation.run_options import RunOptions
from ropsim.simulation.station_run import StationRun


def are_endless(run: CellRun, options: RunOptions) -> bool:
    """Return whether every program at work waits for a channel and nothing can happen any more.

    That is so when none of the waits has a timeout, no channel has its value, no script of the cell changes
    one of them later, no device has anything left to do, and nobody may press keys. What a sensor interface
    of a user's own delivers cannot be foreseen.

    Args:
        run: the cell, between two steps of its stations.
        options: of the run.
    """
    stations = [run.stations[name] for name in run.at_work]
    if not all(at.awaits and at.awaits.timeout is None and not at.in_vain for at in stations):
        return False
    if options.sensors is not None or run.watch.may_press:
        return False
    if any(device.due != NEVER for device in run.devices.values()):
        return False
    return all(_stays_away(run, at, at.awaits) for at in stations if at.awaits)


def end_waits(run: CellRun, programs: Mapping[str, Program]) -> None:
    """End the programs at work where they wait, each with a finding (S742)."""
    for name in run.at_work:
        at = run.stations[name]
        if at.awaits:
            run.findings.append(_finding(run, at, at.awaits, programs))
            at.in_vain = True


def _stays_away(run: CellRun, at: StationRun, step: AwaitInstruction) -> bool:
    sample = run.sensors.read(step.channel, at.time)
    value = sample.value if sample.valid else False
    return value != step.value and not run.sensors.changes_after(step.channel, at.time)


def _finding(
    run: CellRun, at: StationRun, step: AwaitInstruction, programs: Mapping[str, Program]
) -> Diagnostic:
    name, channel = at.station.name, step.channel
    devices = [one for one, device in run.devices.items() if channel in device.device.tells]
    setters = [] if _is_input(run, channel) else [one for one in programs if _sets(programs[one], channel)]
    notes = [f"`{channel}` is set by the device `{one}`, which stands" for one in devices]
    for one in setters:
        whose = "this program" if one == name else f"the program of `{one}`"
        notes.append(f"`{channel}` is set by {whose}, which {_state(run, one)}")
    return WAITS_IN_VAIN.at(
        step.origin.span,
        f"`{name}` waits for {_wanted(step)}, and nothing can change that any more "
        f"(t = {at.time:.2f} s): the run ends here",
        label=f"pass {step.origin.visit}",
        notes=tuple(notes) or (_nobody(run, channel),),
        hint=_hint(run, channel, devices, setters),
        data={
            "station": name,
            "channel": channel,
            "value": bool(step.value),
            "time_s": at.time,
            "pass": step.origin.visit,
        },
    )


def _state(run: CellRun, name: str) -> str:
    step = run.stations[name].awaits if name in run.at_work else None
    if step is None:
        return "has ended"
    line = f" on line {step.origin.span.line}" if step.origin.span else ""
    return f"waits for {_wanted(step)}{line}"


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


def _wanted(step: AwaitInstruction) -> str:
    return f"`{step.channel}` to {'come on' if step.value else 'go off'}"
