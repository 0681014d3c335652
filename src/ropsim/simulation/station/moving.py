"""Moves of a run: plan a sequence, follow it, settle at its end."""

from collections.abc import Iterator, Sequence

from ropsim.core import Diagnostic
from ropsim.flow import (
    Guard,
    MessageEvent,
    MessageInstruction,
    MotionKind,
    MoveEvent,
    MoveInstruction,
    OutputEvent,
    SkipEvent,
)
from ropsim.kinematics import forward
from ropsim.planning import NEXT_IS_SKIPPED, MotionPlan, MotionSequence, TimedMove, stopped_by
from ropsim.simulation.records.move_span import MoveSpan, PathSpan
from ropsim.simulation.records.planned_sequence import PlannedMotion
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.in_force import put_in_force
from ropsim.simulation.state.station_run import StationRun
from ropsim.simulation.state.world import SimulatedWorld
from ropsim.simulation.station.correcting import Correcting
from ropsim.simulation.station.following import Follower
from ropsim.simulation.station.guarding import Lookout
from ropsim.simulation.station.sequences import ProgramSequence, ends_with_list, why_it_ends
from ropsim.simulation.station.settle import settle
from ropsim.spatial import Pose


def move(run: CellRun, at: StationRun, sequence: ProgramSequence, world: SimulatedWorld) -> Iterator[None]:
    """Plan the moves of a motion sequence and follow them; moves that cannot be planned are skipped.

    Moves behind a skipped one are planned again from the position of the arm.
    """
    done, moves = 0, sequence.moves
    while done < len(moves) and not at.is_over:
        order = MotionSequence(moves[done:], at.q_command, at.payload, sequence.ahead)
        run.ordered(at.station.name, order)
        planned = run.plan(at.station.name, at.chain, order)
        if motion := planned.motion:
            done_then = done + len(motion.plan.moves)
            if done_then < len(moves):
                _report(run, at, stopped_by(moves[done_then - 1], NEXT_IS_SKIPPED))
            elif not ends_with_list(sequence):
                _report(run, at, stopped_by(moves[-1], why_it_ends(sequence)))
            texts = [sequence.said_before(done + number) for number in range(len(motion.plan.moves))]
            yield from _follow(run, at, motion, texts, world)
            done = done_then
        if (refusal := planned.refusal) and not at.cut_short:
            _say(run, at, sequence.said_before(done))
            world.q_met = None
            _skip(run, at, moves[done], refusal.diagnostics)
            done += 1
    if done == len(moves) and not at.cut_short:
        _say(run, at, sequence.said_before(done))


def _report(run: CellRun, at: StationRun, findings: Sequence[Diagnostic]) -> None:
    """Add findings of a plan to the run: each sort of a line only for its first pass; others are counted."""
    for one in findings:
        if run.reported.is_new(at.station.name, one, len(run.findings)):
            run.findings.append(one)


def _say(run: CellRun, at: StationRun, texts: Sequence[MessageInstruction]) -> None:
    for text in texts:
        run.note(at, at.tick, MessageEvent(*at.when(at.tick), text.origin, text=text.text))


def _skip(run: CellRun, at: StationRun, move: MoveInstruction, why: tuple[Diagnostic, ...]) -> None:
    put_in_force(run, at, move)
    run.findings.extend(why)
    run.note(at, at.tick, SkipEvent(*at.when(at.tick), move.origin, motion=move.kind))


def _follow(
    run: CellRun,
    at: StationRun,
    motion: PlannedMotion,
    texts: Sequence[Sequence[MessageInstruction]],
    world: SimulatedWorld,
) -> Iterator[None]:
    """Follow a plan move by move and piece by piece, and settle at its end."""
    planned = motion.plan
    _report(run, at, planned.findings)
    follower = Follower(run, at, motion)
    for number, one in enumerate(planned.moves):
        _say(run, at, texts[number])
        put_in_force(run, at, one.move)
        since, ordinal, first = at.tick, len(at.moves), follower.clock.place
        at.track("move", ordinal)
        world.q_met = None
        follower.lookout = _lookout(run, at, world, one.move.guard) if one.move.guard else None
        tracking = one.move.tracking
        follower.correcting = Correcting(at, world, one, tracking, planned.reference) if tracking else None
        yield from _to(run, at, follower, one)
        if follower.lookout:
            run.findings += _condition_findings(follower.lookout, follower, one, first)
        run.findings += follower.correcting.findings() if follower.correcting else ()
        end, out = at.tick, None
        if number == len(planned.moves) - 1 and not at.cut_short:
            out = yield from settle(run, at, one.move)
        at.moves.append(MoveSpan(one.move, since, end, at.tick))
        at.track("move", -1)
        done = MoveEvent(
            *at.when(since),
            one.move.origin,
            motion=one.move.kind,
            ordinal=ordinal,
            travel=(end - since) / at.hz,
            settle=(at.tick - end) / at.hz,
            zone=float(one.move.modal.zone),
            flown=one.zone,
            blending=follower.blended(since, end) / at.hz,
            critical=motion.critical[number],
            path_speed=_path_speed(at, one.move),
            reached=one.reached,
            target=_commanded(at, one.X_MT) if tracking else motion.places[number],
            out_of_position=out,
            free_orientation=one.move.has_free_orientation,
        )
        run.note(at, since, done)
        run.moved += 1
        run.progress(f"move {run.moved}")
        if at.cut_short:
            break
    _enter_paths(at, planned, follower)


def _lookout(run: CellRun, at: StationRun, world: SimulatedWorld, guard: Guard) -> Lookout:
    signal = run.cell.signals.get(guard.channel)
    return Lookout(guard, world, at, at.time, signal.sensor if signal is not None else None)


def _condition_findings(
    lookout: Lookout, follower: Follower, one: TimedMove, first: float
) -> tuple[Diagnostic, ...]:
    """Return the findings on the condition of a move that has ended; it began at a place of the plan."""
    if follower.at.cut_short:
        return ()
    if follower.ended_at == first and lookout.world.guard_met:
        came = "the arm came through a zone and braked at once" if first > 0.0 else "the arm did not go"
        return (lookout.held_before(one.move, came),)
    return () if follower.ended else tuple(filter(None, (lookout.missed(one.move),)))


def _path_speed(at: StationRun, move: MoveInstruction) -> float | None:
    """Return the speed set by program or cell for the path of the tool [m/s]; None in joint space."""
    if move.kind == MotionKind.PTP:
        return None
    controller, given = at.station.controller, move.modal.path_speed
    return (controller.path.speed if given is None else given) * controller.speed_override


def _commanded(at: StationRun, X_MT: Pose) -> tuple[float, ...]:
    """Return where the TCP is commanded to be now, in the base frame [m]."""
    return tuple((forward(at.station.robot, at.q_command) @ X_MT).position.tolist())


def _to(run: CellRun, at: StationRun, follower: Follower, one: TimedMove) -> Iterator[None]:
    """Follow the plan to the end of a move; outputs on its way are set."""
    for trigger in one.triggers:
        yield from follower.until(trigger.tick)
        if at.cut_short or follower.ended:
            return
        channel, value = trigger.trigger.channel, trigger.trigger.value
        run.set_output(at, channel, value)
        done = OutputEvent(*at.when(at.tick), one.move.origin, channel=channel, value=value)
        run.note(at, at.tick, done)
    yield from follower.until(one.last)


def _enter_paths(at: StationRun, planned: MotionPlan, follower: Follower) -> None:
    """Note which paths of the tool have been followed; the last one goes on while the arm settles."""
    come = follower.clock.place
    correction = follower.correcting.followed() if follower.correcting else None
    for segment in planned.path_segments:
        if segment.path is None or segment.first >= come:
            continue
        end = follower.tick_at(segment.last) if segment.last < min(come, planned.ticks) else at.tick
        first = follower.tick_at(segment.first)
        at.paths.append(PathSpan(segment.path, first, end, segment.frame, correction))
