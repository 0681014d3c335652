"""A whole program in a whole cell: interpreter, controller, drives, arm, parts.

`run` is the main loop; it reads like the generic controller's block diagram: the interpreter hands over
instructions, the slow side of the controller turns a move into joint references, the plant follows them.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

from ropsim.controller import LawError
from ropsim.core import Diagnostic
from ropsim.flow import (
    GripInstruction,
    Instruction,
    MessageEvent,
    MessageInstruction,
    ModalState,
    MoveInstruction,
    Origin,
    OutputEvent,
    OutputInstruction,
    Recording,
    SyncInstruction,
    WaitEvent,
    WaitInstruction,
)
from ropsim.icr import Finished, Machine, Program
from ropsim.model import Cell, Tool
from ropsim.simulation.cell_run import CellRun
from ropsim.simulation.diagnostics import RUN_TOO_LONG
from ropsim.simulation.gripping import grip
from ropsim.simulation.input_diagnostics import STOPPED
from ropsim.simulation.moving import move
from ropsim.simulation.record import recording_of
from ropsim.simulation.run_options import RunOptions
from ropsim.simulation.servo.diagnostics import DivergedError, ServoArrayError
from ropsim.simulation.start import start_run
from ropsim.simulation.world import SimulatedWorld


def run(cell: Cell, program: Program, options: RunOptions) -> Recording:
    """Run a verified program in a cell and return the recording with all findings.

    A move that cannot be made becomes a finding on its source line and is skipped; the program goes on,
    so that one run shows every such line.

    Args:
        cell: static model.
        program: verified ICR.
        options: fidelity, rates of recording, inputs, who looks on.

    Raises:
        DivergedError: S701, the state has become NaN or infinite; it names the source line.
    """
    state = start_run(cell, options)
    machine = Machine(program, _world(state, options))
    step = last = machine.advance()
    while not isinstance(step, Finished) and not state.is_over:
        with _blamed(step):
            _carry_out(state, step)
            state.watch.advanced(state)
            last, step = step, machine.advance()
    state.watch.ended(state)
    if state.stopped:
        state.findings.append(_stopped(last))
    elif state.cut_short or not isinstance(step, Finished):
        state.findings.append(_too_long(last, options))
    elif step.trap is not None:
        state.findings.append(step.trap)
    return recording_of(state, program, options)


def _carry_out(state: CellRun, step: Instruction) -> None:
    span = step.origin.span
    state.track("line", span.line if span else 0)
    state.take(_tool_in_force(state.cell, step.modal), state.parts)
    match step:
        case MoveInstruction():
            move(state, step)
        case GripInstruction():
            grip(state, step)
        case WaitInstruction():
            since = state.tick
            state.stand(round(step.duration * state.cell.controller.rates.control_hz))
            state.note(WaitEvent(*state.when(since), step.origin, pause=step.duration))
        case OutputInstruction(channel=channel, value=value):
            state.sensors.set_output(channel, value)
            state.track(f"signal.{channel}", float(value))
            state.note(OutputEvent(*state.when(state.tick), step.origin, channel=channel, value=value))
        case MessageInstruction():
            state.note(MessageEvent(*state.when(state.tick), step.origin, text=step.text))
        case SyncInstruction():
            # A program that does nothing but look at channels must see time pass.
            if state.waiting:
                state.stand(state.cell.controller.rates.interpolation_ticks)
    state.waiting = isinstance(step, SyncInstruction)


def _world(state: CellRun, options: RunOptions) -> SimulatedWorld:
    hz = state.cell.controller.rates.control_hz

    def stand(until: float) -> bool:
        state.stand(max(1, round(until * hz) - state.tick))
        return not state.cut_short

    return SimulatedWorld(
        options.sensors or state.sensors,
        lambda: state.time,
        stand,
        state.cell.controller.rates.interpolation_period,
        options.longest_wait,
        lambda: state.watch.reading(state),
    )


def _tool_in_force(cell: Cell, modal: ModalState) -> Tool | None:
    """Return the tool of the cell that is in force; None for the bare interface or a tool of the program."""
    return cell.tools.get(modal.tool or (cell.default_tool if modal.X_MT is None else ""))


@contextmanager
def _blamed(step: Instruction) -> Iterator[None]:
    """Put the source line and the pass of `step` on what the servo raises."""
    try:
        yield
    except (DivergedError, LawError, ServoArrayError) as error:
        found, visit = error.diagnostic, step.origin.visit
        data = {**found.data, "pass": visit}
        raise type(error)(replace(found, span=step.origin.span, label=f"pass {visit}", data=data)) from error


def _stopped(step: Instruction | Finished) -> Diagnostic:
    span = None if isinstance(step, Finished) else step.origin.span
    return STOPPED.at(span, "the run was ended here by hand")


def _too_long(step: Instruction | Finished, options: RunOptions) -> Diagnostic:
    origin = Origin() if isinstance(step, Finished) else step.origin
    return RUN_TOO_LONG.at(
        origin.span,
        f"the program still runs after {options.longest:g} s of simulated time, it was stopped here",
        label=f"pass {origin.visit}",
        hint="give the loop an end, or simulate fewer passes of it",
        data={"pass": origin.visit},
    )
