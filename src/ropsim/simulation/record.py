"""From the running state to the recording: channels, events, findings, header."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import Channel, Event, MotionKind, Recording
from ropsim.icr import Program, program_id
from ropsim.kinematics import forward_batch
from ropsim.model import Cell
from ropsim.simulation.arrivals import Arrivals, arrivals
from ropsim.simulation.cell_run import CellRun
from ropsim.simulation.channels import joint_channels, pose_channels, track_channel
from ropsim.simulation.inputs import InputChange, input_events, plain_inputs
from ropsim.simulation.move_span import MoveSpan
from ropsim.simulation.run_options import RunOptions
from ropsim.simulation.settling import settling_findings
from ropsim.simulation.verdicts import verdicts
from ropsim.spatial import Array, Pose
from ropsim.version import __version__


def recording_of(state: CellRun, program: Program, options: RunOptions) -> Recording:
    """Return the recording of a run that has ended."""
    log = state.plant.log()
    ticks = log.pop("tick")
    time = ticks / state.cell.controller.rates.control_hz
    log["q_error"] = log["q_ref"] - log["q"]
    channels = joint_channels(state.cell.robot, log)
    tool_poses = _tool_poses(state, ticks)
    attained = forward_batch(state.cell.robot, log["q"]) @ tool_poses
    command = forward_batch(state.cell.robot, log["q_ref"]) @ tool_poses
    channels |= pose_channels("attained", attained) | pose_channels("command", command)
    error = path_errors(state.moves, state.cell, ticks, attained[:, :3, 3])
    channels["path_error"] = Channel(error, "m", (), "distance of the attained TCP from the commanded line")
    for name in sorted(state.tracks):
        channels[name] = track_channel(name, state.tracks[name].at(ticks))
    events = sorted(
        [
            *_moves_with_errors(state, ticks, error),
            *state.activations.events(state.cell.controller.rates.control_hz),
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
    about = {**header(state, program, options), **_destinations(arrived)}
    return Recording(time, channels, tuple(events), findings, state.time, about, tuple(state.placements))


def header(state: CellRun, program: Program, options: RunOptions) -> Mapping[str, object]:
    """Return what the recording says about itself; plain values only."""
    cell, robot, rates = state.cell, state.cell.robot, state.cell.controller.rates
    given = plain_inputs(inputs_taken(state))
    origins = (*robot.origins, *cell.controller.origins)
    return {
        "ropsim": __version__,
        "project": cell.name,
        "program": program.name,
        "source": program.source,
        "icr_id": program_id(program),
        "fidelity": options.fidelity.value,
        "record_hz": rates.control_hz / state.plant.record_ticks,
        "rates": {
            "control_hz": rates.control_hz,
            "interpolation_ticks": rates.interpolation_ticks,
            "plant_steps": rates.plant_steps,
        },
        "skipped_moves": sum(event.kind == "skip" for event in state.events),
        "parts_left": list(state.parts.left),
        "estimated": [one.parameters for one in origins if one.kind == "estimated"],
        "checked": [],  # collisions are not looked at
        "robot": {
            "name": robot.name,
            "title": robot.title,
            "joint_names": [joint.name for joint in robot.axis_joints],
            "joint_types": [joint.measure.value for joint in robot.axis_joints],
            "lower": robot.lower_limits.tolist(),
            "upper": robot.upper_limits.tolist(),
            "max_speed": robot.max_speeds.tolist(),
            "max_effort": robot.max_efforts.tolist(),
            "max_current": [getattr(drive.amplifier, "max_current", None) for drive in robot.drives],
            "origins": [
                {"parameters": one.parameters, "kind": one.kind, "source": one.source} for one in origins
            ],
        },
        **({"inputs": given} if given else {}),
    }


def _arrivals(state: CellRun) -> Arrivals:
    """Return what became of the parts with a destination; a run that did not come to its end says nothing."""
    if state.cut_short:
        return Arrivals(0, ())
    return arrivals(state.parts, state.scenery.parts, state.attained())


def _destinations(arrived: Arrivals) -> dict[str, object]:
    """Return the entry of the header on destinations; nothing where no part has one."""
    reached = arrived.wanted - len(arrived.findings)
    return {"destinations": {"wanted": arrived.wanted, "reached": reached}} if arrived.wanted else {}


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
        if event.kind != "move" or event.data["kind"] != MotionKind.LIN.value:
            return event
        move = state.moves[int(str(event.data["ordinal"]))]
        first, last = np.searchsorted(ticks, [move.start, move.settled], side="right")
        worst = float(np.max(errors[first:last], initial=0.0))
        return replace(event, data={**event.data, "path_error_max": worst})

    return [with_error(event) for event in state.events]
