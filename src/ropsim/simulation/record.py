"""From the running state to the recording: channels, events, findings, facts."""

from dataclasses import replace

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import (
    Destinations,
    Event,
    Fidelity,
    InputChange,
    MotionKind,
    MoveEvent,
    Recording,
    RunFacts,
    SkipEvent,
)
from ropsim.icr import Program, program_id
from ropsim.kinematics import forward_batch
from ropsim.model import ROBOT, Cell
from ropsim.simulation.arrivals import Arrivals, arrivals
from ropsim.simulation.cell_run import CellRun
from ropsim.simulation.channels import joint_channels, path_error_channel, pose_channels, track_channel
from ropsim.simulation.inputs import input_events
from ropsim.simulation.move_span import MoveSpan
from ropsim.simulation.run_options import RunOptions
from ropsim.simulation.settling import settling_findings
from ropsim.simulation.station_facts import station_facts, with_law
from ropsim.simulation.verdicts import verdicts
from ropsim.spatial import Array, Pose
from ropsim.version import __version__


def recording_of(state: CellRun, program: Program, options: RunOptions) -> Recording:
    """Return the recording of a run that has ended."""
    hz = state.cell.controller.rates.control_hz
    log = state.plant.log()
    ticks = log.pop("tick")
    time = ticks / hz
    log["q_error"] = log["q_ref"] - log["q"]
    channels = joint_channels(ROBOT, state.cell.robot, log)
    tool_poses = _tool_poses(state, ticks)
    attained = forward_batch(state.cell.robot, log["q"]) @ tool_poses
    command = forward_batch(state.cell.robot, log["q_ref"]) @ tool_poses
    channels |= pose_channels(ROBOT, "attained", attained) | pose_channels(ROBOT, "command", command)
    error = path_errors(state.moves, state.cell, ticks, attained[:, :3, 3])
    channels["path_error"] = path_error_channel(ROBOT, error)
    for name in sorted(state.tracks):
        channels[name] = track_channel(ROBOT, name, state.tracks[name], state.tick, hz)
    events: list[Event] = sorted(
        [
            *_moves_with_errors(state, ticks, error),
            *state.activations.events(ROBOT, hz),
            *input_events(inputs_taken(state)),
        ],
        key=lambda event: event.time,
    )
    arrived = _arrivals(state)
    findings: tuple[Diagnostic, ...] = (
        *state.findings,
        *arrived.findings,
        *verdicts(state.cell, time, channels, program.source),
        *settling_findings(events, state.time, program.source),
    )
    facts = _facts(state, program, options, arrived)
    return Recording(time, channels, tuple(events), findings, state.time, facts, tuple(state.placements))


def _facts(state: CellRun, program: Program, options: RunOptions, arrived: Arrivals) -> RunFacts:
    """Return what the recording says about its run."""
    cell = state.cell
    station = replace(
        station_facts(ROBOT, cell.robot, cell.controller),
        program=program.name,
        source=program.source,
        icr_id=program_id(program),
        skipped_moves=sum(isinstance(event, SkipEvent) for event in state.events),
    )
    if options.fidelity is Fidelity.DYNAMIC:
        station = with_law(station, cell.controller, options.law)
    return RunFacts(
        ropsim=__version__,
        project=cell.name,
        fidelity=options.fidelity,
        record_hz=cell.controller.rates.control_hz / state.plant.record_ticks,
        checked=(),  # collisions are not looked at
        inputs=tuple(inputs_taken(state)),
        parts_left=tuple(state.parts.left),
        destinations=Destinations(arrived.wanted, arrived.wanted - len(arrived.findings)),
        stations=(station,),
    )


def _arrivals(state: CellRun) -> Arrivals:
    """Return what became of the parts with a destination; a run that did not come to its end says nothing."""
    if state.cut_short:
        return Arrivals(0, ())
    return arrivals(state.parts, state.scenery.parts, state.attained())


def inputs_taken(state: CellRun) -> list[InputChange]:
    """Return the changes of inputs that fell into the run, in order of time."""
    return sorted(one for one in state.inputs if one.time <= state.time)


def path_errors(moves: list[MoveSpan], cell: Cell, ticks: Array, attained: Array) -> Array:
    """Return the distance of the attained TCP from the line of each LIN move, NaN elsewhere.

    Args:
        moves: as carried out.
        cell: the cell.
        ticks: recorded ticks, shape (k,).
        attained: attained TCP positions in the base frame [m], shape (k, 3).

    Returns:
        Distances [m], shape (k,), in the sense of path accuracy AT_p of ISO 9283 for one cycle.
    """
    errors = np.full(len(ticks), np.nan)
    lines = [move for move in moves if move.move.kind is MotionKind.LIN and move.end > move.start]
    if not lines:
        return errors
    ends = forward_batch(cell.robot, np.array([q for move in lines for q in (move.q_start, move.q_end)]))
    for k, move in enumerate(lines):
        first, last = np.searchsorted(ticks, [move.start, move.settled], side="right")
        a, b = ((ends[2 * k + side] @ move.X_MT.matrix())[:3, 3] for side in (0, 1))
        errors[first:last] = distance_from_segment(attained[first:last], a, b)
    return errors


def distance_from_segment(points: Array, a: Array, b: Array) -> Array:
    """Return the distances of `points` (k, 3) from the segment from `a` to `b`, shape (k,)."""
    along = b - a
    share = np.clip((points - a) @ along / max(float(along @ along), 1e-300), 0.0, 1.0)
    return np.asarray(np.linalg.norm(points - a - share[:, None] * along, axis=1))


def _tool_poses(state: CellRun, ticks: Array) -> Array:
    """Return X_MT at each recorded tick, shape (k, 4, 4): that of the latest move, before it of the first."""
    if not state.moves:
        tool = state.cell.tools.get(state.cell.default_tool)
        return np.broadcast_to((tool.X_MT if tool else Pose()).matrix(), (len(ticks), 4, 4))
    poses: list[Pose] = []
    for move in state.moves:
        if move.X_MT not in poses:
            poses.append(move.X_MT)
    which = np.array([poses.index(move.X_MT) for move in state.moves])
    index = np.searchsorted(np.array([move.start for move in state.moves]), ticks, side="left") - 1
    matrices: Array = np.stack([pose.matrix() for pose in poses])
    return np.asarray(matrices[which[np.maximum(index, 0)]])


def _moves_with_errors(state: CellRun, ticks: Array, errors: Array) -> list[Event]:
    """Return the events; LIN moves get the largest path error on their way."""

    def with_error(event: Event) -> Event:
        if not isinstance(event, MoveEvent) or event.motion is not MotionKind.LIN:
            return event
        move = state.moves[event.ordinal]
        first, last = np.searchsorted(ticks, [move.start, move.settled], side="right")
        return replace(event, path_error_max=float(np.max(errors[first:last], initial=0.0)))

    return [with_error(event) for event in state.events]
