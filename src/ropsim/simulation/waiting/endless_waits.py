"""Programs that stand for ever, for a signal or held: found at once, instead of waited out."""

from collections.abc import Mapping

from ropsim.core import Diagnostic
from ropsim.flow import Origin
from ropsim.icr import Program
from ropsim.model import ROBOT
from ropsim.simulation.devices.device_run import NEVER
from ropsim.simulation.diagnostics.part_diagnostics import WAITS_IN_VAIN
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.run_options import RunOptions
from ropsim.simulation.state.sensing import SensedRun
from ropsim.simulation.state.station_run import StationRun
from ropsim.simulation.station.serving import is_needed
from ropsim.simulation.waiting.endless_holds import hold_finding, is_endless_hold
from ropsim.simulation.waiting.setters import device_note, program_setters


def are_endless(run: CellRun, options: RunOptions) -> bool:
    """Return whether every program at work is held or waits for a channel, and nothing changes that any more.

    This requires that no keys can be pressed, and that no manual end lies ahead. A program is held for ever
    if the override is 0 and no change of it is to come. A wait is endless when it has no timeout, its channel
    has not its value, no script of the cell changes that later, and no device has anything left to do. A
    program that only reads channels in a loop, and has found the same twice, also waits. The readings of a
    user's sensor interface cannot be foreseen. A serving program that is not needed any more ends regularly.

    Args:
        run: the cell, between two steps of its stations.
        options: of the run.
    """
    waiting = []
    for name in run.at_work:  # evaluated at every step; nearly always some program goes on
        at = run.stations[name]
        if not is_endless_hold(run, at):
            if not (_waits(at) and is_needed(run, at)):
                return False
            waiting.append(at)
    if run.watch.may_press or run.stop_tick is not None:
        return False
    if not waiting:
        return True
    if options.sensors is not None or any(device.due != NEVER for device in run.devices.values()):
        return False
    return all(_stays(run, at) for at in waiting)


def end_waits(run: CellRun, programs: Mapping[str, Program]) -> None:
    """End the programs at work, each with a finding (S742, S762) except serving ones."""
    standing = [run.stations[name] for name in run.at_work]
    run.findings += [
        hold_finding(run, at) if at.is_held else _finding(run, at, programs)
        for at in standing
        if not at.station.serves
    ]
    for at in standing:
        at.in_vain = True


def _waits(at: StationRun) -> bool:
    if at.in_vain:
        return False
    return at.awaits.timeout is None if at.awaits else at.polled is not None


def _stays(run: CellRun, at: StationRun) -> bool:
    """Return whether the channels stay unchanged, and the one that is waited for has not come."""
    for channel in _channels(at):
        sample = run.sensors.read(channel, at.time, SensedRun(run, at))
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
    if not _channels(at):
        return WAITS_IN_VAIN.at(
            origin.span,
            f"`{name}` waits for ever, from t = {at.time:.2f} s on: it looks at nothing that could change",
            label=f"pass {origin.visit}",
            hint="let the condition read a signal, or count the passes",
            data={"station": name, "channel": "", "time_s": at.time, **origin.data},
        )
    notes = [note for channel in _channels(at) for note in _notes(run, at, channel, programs)]
    return WAITS_IN_VAIN.at(
        origin.span,
        f"`{name}` waits for {_wanted(at)} for ever, from t = {at.time:.2f} s on: "
        f"{'; '.join(note for note, _ in notes)}",
        label=f"pass {origin.visit}",
        hint=notes[0][1],
        data={
            "station": name,
            "channel": ", ".join(_channels(at)),
            "time_s": at.time,
            **origin.data,
        },
    )


def _notes(
    run: CellRun, at: StationRun, channel: str, programs: Mapping[str, Program]
) -> list[tuple[str, str]]:
    """Return why a channel does not come, each reason with a hint."""
    name, level = at.station.name, _level(at, channel)
    word = "on" if level else "off"
    devices = [one for one in run.devices.values() if channel in one.device.tells]
    found = [device_note(run, one, channel, level, at.time) for one in devices]
    if devices:
        return found
    if _is_input(run, channel):
        hint = f"give `{channel}` `changes` in the cell file, or press its key in a live run"
        return [(f"`{channel}` is an input, and no change of it lies ahead", hint)]
    setters = _setting(at, channel, programs)
    hint = _hint(run, at, channel, programs)
    for one in setters:
        whose = "this program" if one == name else f"the program of `{one}`"
        found.append((f"`{channel}` is set by {whose}, which {_state(run, one)}", hint))
    if setters:
        return found
    if program_setters(programs, channel, not level):
        return [
            (f"no program ever sets `{channel}` {word}", f"let the program of another station set it {word}")
        ]
    hint = f"set `{channel}` in the program of another station, or wait for an input"
    return [(f"`{channel}` is an output that no program sets", hint)]


def _level(at: StationRun, channel: str) -> bool:
    """Return the value of a channel for which the program would continue."""
    return bool(at.awaits.value) if at.awaits else not _reads(at)[channel]


def _hint(run: CellRun, at: StationRun, channel: str, programs: Mapping[str, Program]) -> str:
    name, setters = at.station.name, _setting(at, channel, programs)
    others = [one for one in setters if one != name]
    if not others:
        return f"set `{channel}` in the program of another station: this one does nothing while it waits"
    waiting = [one for one in others if one in run.at_work]
    if not waiting:
        again = f"let the program of `{others[0]}` set `{channel}` as often as this one waits for it"
        if name == ROBOT:
            return again
        return f"{again}; if this one serves the others, write `serves = true` in `[stations.{name}]`"
    if name in _behind(run, waiting, programs):
        return "let one program speak before it waits for the other, or give the wait a timeout"
    return f"look at what the program of `{waiting[0]}` waits for"


def _behind(run: CellRun, names: list[str], programs: Mapping[str, Program]) -> set[str]:
    """Return the stations at work for which some wait, and for which these wait, and so on."""
    found: set[str] = set()
    ahead = list(names)
    while ahead:
        at = run.stations[ahead.pop()]
        setters = (one for channel in _channels(at) for one in _setting(at, channel, programs))
        fresh = [one for one in setters if one in run.at_work and one not in found]
        found.update(fresh)
        ahead += fresh
    return found


def _setting(at: StationRun, channel: str, programs: Mapping[str, Program]) -> list[str]:
    return program_setters(programs, channel, _level(at, channel))


def _origin(at: StationRun) -> Origin:
    step = at.awaits or at.polled
    return step.origin if step else Origin()


def _state(run: CellRun, name: str) -> str:
    if name not in run.at_work:
        return "has ended"
    at = run.stations[name]
    if at.is_held:
        return f"is held{f' on line {at.origin.span.line}' if at.origin.span else ''}"
    span = _origin(at).span
    return f"waits for {_wanted(at)}{f' on line {span.line}' if span else ''}"


def _is_input(run: CellRun, channel: str) -> bool:
    signal = run.cell.signals.get(channel)
    return signal is not None and signal.is_input


def _wanted(at: StationRun) -> str:
    if at.awaits:
        return f"`{at.awaits.channel}` to {'come on' if at.awaits.value else 'go off'}"
    return "a change of " + " or ".join(f"`{channel}`" for channel in _channels(at))
