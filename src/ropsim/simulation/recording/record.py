"""From the running state to the recording: channels, events, findings, facts."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ropsim.core import Diagnostic, LateMapping
from ropsim.flow import (
    CalledTask,
    Channel,
    Destinations,
    Event,
    Fidelity,
    InputChange,
    MotionKind,
    MoveEvent,
    OverrideChange,
    Recording,
    RunContent,
    RunFacts,
    SkipEvent,
    StationFacts,
    channel_name,
    in_time,
)
from ropsim.icr import Program, code_lines, line_contents_of_all, program_id
from ropsim.kinematics import forward_batch
from ropsim.motion import SLOWED, Line, enter_distances
from ropsim.simulation.findings.checks import findings_at, station_findings
from ropsim.simulation.findings.circumstances import OWN_LAW, loop_words
from ropsim.simulation.findings.consequences import with_causes
from ropsim.simulation.findings.finished_station import FinishedStation, PressedOn
from ropsim.simulation.findings.load_findings import has_rated_payloads
from ropsim.simulation.parts.arrivals import Arrivals, are_untouched, arrivals
from ropsim.simulation.recording.channels import (
    correction_channel,
    device_channel,
    finger_channel,
    joint_channels,
    path_error_channel,
    path_speed_channel,
    pose_channels,
    track_channel,
    wrench_channel,
)
from ropsim.simulation.recording.path_corrections import corrections, without_corrections
from ropsim.simulation.recording.path_speeds import path_speeds
from ropsim.simulation.records.move_span import PathSpan
from ropsim.simulation.records.plant import CONTACT_WRENCH
from ropsim.simulation.records.tally_kernel import greatest
from ropsim.simulation.records.track import Track
from ropsim.simulation.servo.log import drive_powers
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.inputs import input_events
from ropsim.simulation.state.run_options import RunOptions
from ropsim.simulation.state.station_run import StationRun
from ropsim.simulation.station.station_facts import station_facts, with_law
from ropsim.spatial import Array
from ropsim.version import __version__

_ROWS_AT_ONCE = 16_384
"""Rows whose poses are computed together."""


def recording_of(run: CellRun, programs: Mapping[str, Program], options: RunOptions) -> Recording:
    """Return the recording of a run that has ended."""
    for at in run.stations.values():
        run.end_looking(at)
        at.rest_to_row()
    logs = {name: at.plant.log() for name, at in run.stations.items()}
    rows = _rows(run, logs)
    time = rows / run.hz
    channels: dict[str, Channel] = {}
    events: list[Event] = [*input_events(inputs_taken(run))]
    judged: list[Diagnostic] = []
    for name, at in run.stations.items():
        own = _station_channels(at, logs.pop(name), rows)
        source = programs[name].source if name in programs else ""
        channels |= {channel_name(quantity, name): channel for quantity, channel in own.items()}
        mine = [event for event in run.events if event.station == name]
        events += _with_errors(mine, at, rows, own["path_error"].values)
        events += at.activations.events(name, at.hz)
        loads = at.tracks.get("payload", Track())
        finished = FinishedStation(
            at.station.robot,
            source,
            at.hz,
            run.time,
            at.plant.tally,
            at.tracks["line"],
            loads,
            mine,
            _slowed_lines(run, source),
            OWN_LAW if name in options.laws else loop_words(at.station.robot, at.station.controller),
            _pressed(run, own, rows * (at.hz / run.hz)),
        )
        if not at.is_lost:
            judged += findings_at(name, programs, station_findings(finished))
    for at in run.stations.values():
        for body, profile in at.fingers.items():
            channels[channel_name("q", body)] = finger_channel(at.station.name, profile.rows(time))
    for name, device in run.devices.items():
        channels[channel_name("q", name)] = device_channel(device.device, device.profile.rows(time))
    for name in sorted(run.tracks):
        if name == "override" and not overrides_taken(run):
            continue
        channels[name] = track_channel("", name, run.tracks[name], run.tick, run.hz)
    events.sort(key=lambda event: event.time)
    arrived = _arrivals(run, programs)
    reported = run.reported.counted(run.findings, events)
    findings = tuple(with_causes((*reported, *arrived.findings, *judged), events))
    facts = _facts(run, programs, options, arrived)
    content = RunContent(
        run.content,
        {name: code_lines(one) for name, one in programs.items()},
        _line_contents(run, programs),
    )
    return Recording(time, channels, tuple(events), findings, run.time, facts, tuple(run.placements), content)


def _pressed(run: CellRun, channels: Mapping[str, Channel], ticks: Array) -> PressedOn | None:
    """Return how hard meant contacts pressed on a station, None without any; ticks are those of the rows."""
    wrench = channels.get(CONTACT_WRENCH)
    if wrench is None:
        return None
    return PressedOn(run.cell, ticks, np.linalg.norm(wrench.values[:, :3], axis=1))


def _slowed_lines(run: CellRun, source: str) -> frozenset[int]:
    """Return the lines of a source of which planning has said that a joint slows them."""
    spans = (one.span for one in run.findings if one.code == SLOWED.code)
    return frozenset(span.line for span in spans if span and span.source == source)


def _line_contents(run: CellRun, programs: Mapping[str, Program]) -> Mapping[str, Mapping[int, str]]:
    """Return the content on which the results of lines depend, on request: the text and the cell.

    Manual interventions, key presses and overrides, belong to the run and are no change of the text. If a run
    ends before a program, its present line and later lines have no result.
    """
    content, channels = run.content, run.input_changes
    done = {
        name: _done_lines(run, at, programs[name].source)
        for name, at in run.stations.items()
        if at.unfinished
    }

    def found() -> Mapping[str, Mapping[int, str]]:
        keys = line_contents_of_all(programs, content, channels=channels)
        return {
            name: {line: key for line, key in keys_.items() if name not in done or line in done[name]}
            for name, keys_ in keys.items()
        }

    return LateMapping(found)


def _done_lines(run: CellRun, at: StationRun, source: str) -> frozenset[int]:
    """Return the lines of its source that a program had behind it when its run was ended."""
    own = (event for event in run.events if event.station == at.station.name)
    events = [event for event in own if event.span and event.span.source == source]
    ends = {event.line: event.end for event in sorted(events, key=lambda one: one.end)}  # of the last pass
    passed = [int(line) for line in at.tracks.get("line", Track()).values]
    lines = {*passed, *ends}
    # Activities that are cut off end with the run; a run that is held between two instructions has nothing
    # under way.
    if passed and ends.get(passed[-1], run.time) > run.time - 1.0 / run.hz:
        lines.remove(passed[-1])
    return frozenset(lines)


def _rows(run: CellRun, logs: Mapping[str, Mapping[str, Array]]) -> Array:
    """Return the ticks of the cell's clock that have a row, rows of the station with the fewest."""
    ticks = [logs[name]["tick"] * at.cell_ticks for name, at in run.stations.items()]
    return min(ticks, key=len)


def _station_channels(at: StationRun, logged: Mapping[str, Array], rows: Array) -> dict[str, Channel]:
    """Return the channels of a station at ticks of the cell's clock, without its name before theirs."""
    own, ticks = logged["tick"], rows / at.cell_ticks
    log = {name: values for name, values in logged.items() if name != "tick"}
    log |= drive_powers(at.station.robot, log)
    if not np.array_equal(own, ticks):  # it is recorded at other ticks: linear between two rows
        log = {
            name: np.column_stack([np.interp(ticks, own, one) for one in values.T])
            for name, values in log.items()
        }
    log["q_error"] = log["q_ref"] - log["q"]
    robot = at.station.robot
    attained, turned = _tool_places(at, ticks, log["q"])
    command, commanded = attained, turned
    if log["q_ref"] is not log["q"]:
        command, commanded = _tool_places(at, ticks, log["q_ref"])

    def rotations(rows: slice) -> Array:
        flanges = forward_batch(robot, log["q_ref"][rows])
        return at.tool_frames.on(ticks[rows], flanges).matrices[:, :3, :3]

    points = without_corrections(at.paths, ticks, attained, rotations)
    error = path_errors(at.paths, ticks, log["q"], points)
    name, last = at.station.name, at.tick
    carried = {}
    if any(span.correction for span in at.paths):
        carried["correction"] = correction_channel(name, corrections(at.paths, ticks))
    if any(span.frame for span in at.paths):
        for kind, q, positions in (("command", log["q_ref"], command), ("attained", log["q"], attained)):
            speeds = path_speeds(at.paths, ticks / at.hz, ticks, q, positions)
            carried[f"{kind}_path_speed"] = path_speed_channel(name, kind, speeds)
    if CONTACT_WRENCH in log:
        carried[CONTACT_WRENCH] = wrench_channel(name, log[CONTACT_WRENCH])
    held = {one: track_channel(name, one, at.tracks[one], last, at.hz) for one in sorted(at.tracks)}
    return {
        **joint_channels(name, robot, log),
        **pose_channels(name, "attained", attained, turned),
        **pose_channels(name, "command", command, commanded),
        "path_error": path_error_channel(name, error),
        **carried,
        **held,
    }


def _tool_places(at: StationRun, ticks: Array, q: Array) -> tuple[Array, Array]:
    """Return positions [m] and orientations (w, x, y, z) of the TCP in the base frame, shapes (k, 3), (k, 4).

    Matrices, which take more than all that is kept of them, are those of a block of rows at a time.

    Args:
        at: the station.
        ticks: recorded ticks, shape (k,).
        q: joint coordinates there [rad | m], shape (k, n).
    """
    positions, turned = np.empty((len(ticks), 3)), np.empty((len(ticks), 4))
    for first in range(0, len(ticks), _ROWS_AT_ONCE):
        rows = slice(first, first + _ROWS_AT_ONCE)
        matrices, turned[rows] = at.tool_frames.on(ticks[rows], forward_batch(at.station.robot, q[rows]))
        positions[rows] = matrices[:, :3, 3]
    return positions, turned


def _facts(run: CellRun, programs: Mapping[str, Program], options: RunOptions, arrived: Arrivals) -> RunFacts:
    """Return the facts of the recording about its run."""
    slowest = min(run.stations.values(), key=lambda at: at.hz / at.plant.record_ticks)
    return RunFacts(
        ropsim=__version__,
        project=run.cell.name,
        fidelity=_fidelity(run, options),
        record_hz=slowest.hz / slowest.plant.record_ticks,
        checked=_checked(run),
        inputs=tuple(inputs_taken(run)),
        overrides=overrides_taken(run),
        stopped=run.stop_tick / run.hz if run.stop_tick is not None and run.is_stopped(run.tick) else None,
        parts_left=tuple(run.parts.left),
        destinations=Destinations(arrived.wanted, arrived.wanted - len(arrived.findings)),
        stations=tuple(_station_facts(run, name, programs.get(name), options) for name in run.stations),
    )


def _checked(run: CellRun) -> tuple[str, ...]:
    """Return the checks made by a run."""
    rated = has_rated_payloads([at.station.robot for at in run.stations.values()])
    return ("rated payload",) if rated else ()


def _fidelity(run: CellRun, options: RunOptions) -> Fidelity:
    """Return the fidelity of the run: kinematic for robots without drives, regardless of the request."""
    driven = any(station.robot.drives for station in run.cell.stations.values())
    return options.fidelity if driven else Fidelity.KINEMATIC


def _station_facts(run: CellRun, name: str, program: Program | None, options: RunOptions) -> StationFacts:
    station = run.cell.stations[name]
    skipped = sum(isinstance(event, SkipEvent) and event.station == name for event in run.events)
    plant = run.stations[name].plant
    facts = station_facts(name, station.robot, station.controller, plant.plant_steps, plant.integration)
    facts = replace(facts, skipped_moves=skipped)
    if program is not None:
        called = tuple(CalledTask(one.procedure, one.source, one.version) for one in program.libraries)
        facts = replace(
            facts, program=program.name, source=program.source, icr_id=program_id(program), called=called
        )
    if options.fidelity is Fidelity.DYNAMIC and station.robot.drives:
        facts = with_law(facts, station.controller, options.laws.get(name))
    return facts


def _arrivals(run: CellRun, programs: Mapping[str, Program]) -> Arrivals:
    """Return the state of the parts with a destination.

    Nothing is said where the run did not come to its end, and of programs that have nothing to do with parts:
    none has an instruction for a gripper, the cell has no devices, and all parts are where they were.
    """
    if run.is_stopped(run.tick) or any(at.cut_short or at.in_vain for at in run.stations.values()):
        return Arrivals(0, ())
    state, parts, moment = run.parts, run.scenery.parts, run.moment(run.tick)
    may_carry = bool(run.devices) or any(map(_grips, programs.values()))
    if not may_carry and are_untouched(state, parts, moment):
        return Arrivals(0, ())
    return arrivals(state, parts, run.scenery.tools, moment)


def _grips(program: Program) -> bool:
    return any(step.mnemonic == "GRIP" for procedure in program.procedures for step in procedure.code)


def inputs_taken(run: CellRun) -> list[InputChange]:
    """Return the changes of inputs that fell into the run, in order of time."""
    taken = in_time(one for one in run.inputs if one.time <= run.time)
    return [InputChange(float(one.time), one.signal, float(one.value)) for one in taken]


def overrides_taken(run: CellRun) -> tuple[OverrideChange, ...]:
    """Return the changes of the override that fell into the run, in order of time."""
    return tuple(OverrideChange(tick / run.hz, value) for tick, value in run.overrides if tick <= run.tick)


def path_errors(paths: list[PathSpan], ticks: Array, q: Array, attained: Array) -> Array:
    """Return the distance of the attained TCP from the path of the tool, NaN where there is none.

    Where external axes move the frame of a path, both are seen from where that frame really is.

    Args:
        paths: as followed, in order of time.
        ticks: recorded ticks, shape (k,).
        q: attained joint coordinates [rad | m], shape (k, n).
        attained: attained TCP positions in the base frame [m], shape (k, 3).

    Returns:
        Distances [m], shape (k,), as for the path accuracy AT_p of ISO 9283, of one pass.
    """
    errors = np.full(len(ticks), np.nan)
    places = np.searchsorted(ticks, [(span.start, span.end) for span in paths], side="right").tolist()
    lines: list[Line] = []
    spans: list[tuple[int, int]] = []
    for span, (first, last) in zip(paths, places, strict=True):
        if last <= first:
            continue
        if isinstance(span.path, Line) and not span.frame:
            lines.append(span.path)  # many lines: they are checked together
            spans.append((first, last))
            continue
        points = attained[first:last]
        seen = span.frame.positions(q[first:last], points) if span.frame else points
        errors[first:last] = span.path.distance(seen)
    if lines:
        enter_distances(lines, spans, attained, errors)
    return errors


def _with_errors(events: list[Event], at: StationRun, rows: Array, errors: Array) -> list[Event]:
    """Return the events; moves with a path of the tool get the largest path error on their way."""
    ticks = rows / at.cell_ticks
    spans = [(one.start, one.settled) for one in at.moves]
    places = np.searchsorted(ticks, spans, side="right")
    most = np.empty(len(spans))
    greatest(errors, np.array(places, dtype=np.float64).reshape(-1, 2), most)
    found = most.tolist()

    def with_error(event: Event) -> Event:
        if not isinstance(event, MoveEvent) or event.motion == MotionKind.PTP:
            return event
        return replace(event, path_error_max=found[event.ordinal])

    return [with_error(event) for event in events]
