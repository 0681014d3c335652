"""The programs of a cell: interpreters, controllers, drives, arms and parts against one clock.

`run` is the main loop: the station that is least far continues, at equal times in the order of the names. A
station executes its program; within it the parts work as in the generic controller's block diagram: the
interpreter hands over instructions, the slow side of the controller turns a move into joint references, the
plant follows them.
"""

from collections.abc import Mapping

from ropsim.controller import LawError
from ropsim.flow import Recording
from ropsim.icr import Program
from ropsim.model import Cell
from ropsim.simulation.acting import act
from ropsim.simulation.findings.checks import findings_at
from ropsim.simulation.grips.handing import find_pulls
from ropsim.simulation.recording.record import recording_of
from ropsim.simulation.servo.diagnostics import DivergedError, ServoArrayError
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.run_options import RunOptions
from ropsim.simulation.station.start import start_run
from ropsim.simulation.station.working import work
from ropsim.simulation.waiting.endless_waits import are_endless, end_waits


def run(cell: Cell, programs: Mapping[str, Program], options: RunOptions) -> Recording:
    """Run verified programs in a cell and return the recording with all findings.

    A move that cannot be made becomes a finding on its source line and is skipped; the program goes on, so
    that one run shows all these lines. Where the state of an arm becomes NaN or infinite, or a law fails, the
    run ends with a finding on the line (S701, C601), once the other stations have come as far; the recording
    has what was until then.

    Args:
        cell: static model.
        programs: verified ICR by station; a station without one stands still.
        options: fidelity, rates of recording, inputs, who looks on.

    Raises:
        OptionError: S703, an option cannot be.
    """
    state = start_run(cell, options)
    for name, program in programs.items():
        state.at_work[name] = work(state, state.stations[name], program, options)
    forgotten = -1
    while state.at_work:
        if are_endless(state, options):
            if state.lost_tick is not None:
                break
            end_waits(state, programs)
        name = _least_far(state)
        if state.lost_tick is not None and state.stations[name].due >= state.lost_tick:
            break
        if device := state.next_device(until=state.stations[name].due):
            act(state, device)
            continue
        least = state.stations[name].due
        find_pulls(state, least, programs)
        if least != forgotten:
            forgotten = least
            state.forget(least)
        _work_on(state, name, programs)
        if name in state.at_work:
            state.watch.advanced(state)
    for name in state.at_work:
        state.stations[name].unfinished = True
    state.come_together()
    find_pulls(state, state.tick, programs)
    state.watch.ended(state)
    return recording_of(state, programs, options)


def _least_far(state: CellRun) -> str:
    """Return the station at work that has come least far, the first by name of those."""
    if len(state.at_work) == 1:
        return next(iter(state.at_work))
    return min(state.at_work, key=lambda one: (state.stations[one].due, one))


def _work_on(state: CellRun, name: str, programs: Mapping[str, Program]) -> None:
    """Let a station go on until time passes for it or its program ends."""
    known = len(state.findings)
    try:
        next(state.at_work[name])
    except StopIteration:
        del state.at_work[name]
    except (DivergedError, LawError, ServoArrayError) as error:
        at = state.stations[name]
        at.tick, at.is_lost, at.unfinished = at.plant.tick, True, True
        state.findings.append(error.diagnostic)
        state.lost_tick = min(at.due, state.lost_tick if state.lost_tick is not None else at.due)
        del state.at_work[name]
    if len(state.findings) > known:
        state.findings[known:] = findings_at(name, programs, state.findings[known:])
