"""A station at work: it carries out its program, instruction by instruction."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import assert_never

from ropsim.controller import LawError
from ropsim.core import Diagnostic
from ropsim.flow import (
    AwaitEvent,
    AwaitInstruction,
    GripInstruction,
    Instruction,
    MessageEvent,
    MessageInstruction,
    MoveInstruction,
    OutputEvent,
    OutputInstruction,
    SyncInstruction,
    WaitEvent,
    WaitInstruction,
)
from ropsim.icr import Finished, Machine, Program
from ropsim.simulation.diagnostics.input_diagnostics import STOPPED
from ropsim.simulation.diagnostics.run_diagnostics import RUN_TOO_LONG
from ropsim.simulation.grips.gripping import grip
from ropsim.simulation.records.adapting import adapted
from ropsim.simulation.records.repeated_reads import RepeatedReads
from ropsim.simulation.records.steps import Steps
from ropsim.simulation.servo.diagnostics import DivergedError, ServoArrayError
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.in_force import put_in_force
from ropsim.simulation.state.run_options import RunOptions
from ropsim.simulation.state.sensing import Senses
from ropsim.simulation.state.station_arm import StationArm
from ropsim.simulation.state.station_run import StationRun
from ropsim.simulation.state.world import SimulatedWorld
from ropsim.simulation.station.moving import move
from ropsim.simulation.station.sequences import gather
from ropsim.simulation.station.serving import Serving, is_needed


def work(run: CellRun, at: StationRun, program: Program, options: RunOptions) -> Iterator[None]:
    """Carry out a program at a station to its end.

    Where it yields, time has passed for the station; it goes on when all others have come to that time, so
    its readings, outputs, grips and releases are in order of time with those of the others.

    Args:
        run: the cell.
        at: the station.
        program: verified ICR.
        options: how long a wait and a program may last.

    Raises:
        DivergedError: S701, the state has become NaN or infinite; it names the source line.
    """
    world = SimulatedWorld(
        Senses(options.sensors or run.sensors, at.station.name, run).read,
        lambda: at.time,
        lambda: run.watch.reading(run),
        options.longest_wait,
        StationArm(at),
    )
    machine = Machine(program, world)
    steps = Steps(adapted(machine.advance, options.adapt))
    serving, reads = Serving(), RepeatedReads()
    yield from _while_held(run, at)
    step = steps.take()
    with _blamed(at):
        while not isinstance(step, Finished) and not (at.is_over or at.in_vain or at.dismissed):
            if not is_needed(run, at) and serving.comes_round(machine, step):
                at.dismissed = True
                break
            again = isinstance(step, SyncInstruction) and reads.comes_round(machine.code_place, at.tick)
            at.polled = world.polling.poll(machine, step, at.tick, again=again)
            sequence = gather(step, steps) if isinstance(step, MoveInstruction) else None
            if sequence:
                yield from move(run, at, sequence, world)
            else:
                yield from _carry_out(run, at, step, world, again=again)
            if isinstance(step, SyncInstruction):
                reads.add(machine.code_place, at.tick)
            at.is_busy = False
            yield
            yield from _while_held(run, at)
            step = steps.take()
            if (
                at.polling_wait
                and not isinstance(step, WaitInstruction)
                and type(step) is not SyncInstruction
            ):
                run.end_looking(at)  # it does something else now: a step of a live run ends before that
                yield
                yield from _while_held(run, at)
    if at.in_vain or at.dismissed:
        return  # the end of the wait has been reported; the served programs have ended
    if isinstance(step, Finished) and not at.cut_short:
        run.findings += filter(None, (step.trap,))
        return
    at.unfinished = True
    if run.is_stopped(at.due):
        run.findings.append(_stopped(at))
    else:
        run.findings.append(_too_long(at, options))


def _while_held(run: CellRun, at: StationRun) -> Iterator[None]:
    """Stand as long as the override is 0: a program that is held begins nothing."""
    while run.override(at.due) == 0.0 and not (at.is_over or at.in_vain):
        at.polled, at.is_held = None, True
        yield from at.stand(at.station.controller.rates.interpolation_ticks)
    at.is_held = False


def _stood(
    run: CellRun, at: StationRun, since: int, step: Instruction, pause: float, world: SimulatedWorld
) -> None:
    """Note that the program has stood from a tick on, for a time or because it looks again and again."""
    stood = WaitEvent(*at.when(since), step.origin, pause=pause, looked=world.polling.channels)
    if stood.looked:
        run.note_looking(at, since, stood)
    else:
        run.note(at, since, stood)


def _carry_out(
    run: CellRun, at: StationRun, step: Instruction, world: SimulatedWorld, *, again: bool
) -> Iterator[None]:
    put_in_force(run, at, step)
    if again:  # time must advance for a program that only polls
        since, rates = at.tick, at.station.controller.rates
        yield from at.stand(rates.interpolation_ticks)
        _stood(run, at, since, step, rates.interpolation_period, world)
    match step:
        case GripInstruction():
            yield from grip(run, at, step)
        case WaitInstruction():
            since = at.tick
            yield from at.stand(round(step.duration * at.hz))
            _stood(run, at, since, step, float(step.duration), world)
        case OutputInstruction(channel=channel, value=value):
            run.set_output(at, channel, value)
            done = OutputEvent(*at.when(at.tick), step.origin, channel=channel, value=value)
            run.note(at, at.tick, done)
        case MessageInstruction():
            run.note(at, at.tick, MessageEvent(*at.when(at.tick), step.origin, text=step.text))
        case AwaitInstruction():
            since = at.tick
            at.awaits = step
            yield from _await(run, at, step, world)
            at.awaits = None
            found = (*at.when(since), step.origin)
            came = AwaitEvent(*found, channel=step.channel, value=step.value, came=world.came)
            run.note(at, since, came)
        case MoveInstruction() | SyncInstruction():
            pass  # a move has its sequence; what a synchronisation reads is read by the program
        case _:
            assert_never(step)


def _await(run: CellRun, at: StationRun, step: AwaitInstruction, world: SimulatedWorld) -> Iterator[None]:
    """Stand until a channel has a value, or its timeout is over; report to the program which it was."""
    start, period = at.time, at.station.controller.rates.interpolation_period
    limit = world.longest_wait if step.timeout is None else step.timeout
    world.came = True
    while world.read(step.channel) != step.value:
        at.dismissed = not is_needed(run, at)
        if at.dismissed or at.time - start >= limit:
            world.came = False
            return
        until = min(at.time + period, start + limit)
        yield from at.stand(max(1, round(until * at.hz) - at.tick))
        if at.cut_short or at.in_vain:
            world.came = False
            return


@contextmanager
def _blamed(at: StationRun) -> Iterator[None]:
    """Put the source line and the pass of the instruction in force on exceptions of the servo."""
    try:
        yield
    except (DivergedError, LawError, ServoArrayError) as error:
        found, origin = error.diagnostic, at.origin
        data = {**found.data, **origin.data}
        label = f"pass {origin.visit}"
        raise type(error)(replace(found, span=origin.span, label=label, data=data)) from error


def _stopped(at: StationRun) -> Diagnostic:
    """Return S761 at the instruction at which the station has come to stand, at the time of that."""
    return STOPPED.at(
        at.origin.span,
        "the run was ended here by hand",
        label=f"pass {at.origin.visit}",
        data={**at.origin.data, "time_s": at.time},
    )


def _too_long(at: StationRun, options: RunOptions) -> Diagnostic:
    """Return S723 at the instruction in force, at the time of its station."""
    return RUN_TOO_LONG.at(
        at.origin.span,
        f"the program still runs after {options.longest:g} s of simulated time, it was stopped here",
        label=f"pass {at.origin.visit}",
        hint="give the loop an end or fewer passes, or a long wait a shorter time",
        data={**at.origin.data, "time_s": at.time},
    )
