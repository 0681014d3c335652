"""The state of a run at time 0."""

import math

from ropsim.controller import CellSensors
from ropsim.dynamics import check_moved_masses
from ropsim.flow import Fidelity, in_time
from ropsim.model import Cell, Device, Payload, Station, link_name, tool_body
from ropsim.simulation.devices.axis_profile import AxisProfile, ProfileSegment
from ropsim.simulation.devices.device_run import DeviceRun
from ropsim.simulation.devices.table import DRIVINGS
from ropsim.simulation.findings.undriven import undriven
from ropsim.simulation.grips.feeding import supplies_of
from ropsim.simulation.parts.moment import Moment
from ropsim.simulation.parts.parts import initial_parts, payload
from ropsim.simulation.parts.placements import at_start
from ropsim.simulation.parts.scenery import Scenery, scenery_of
from ropsim.simulation.parts.standing import stood
from ropsim.simulation.records.plant import Plant
from ropsim.simulation.records.tool_frames import ToolFrames
from ropsim.simulation.records.track import tick_at
from ropsim.simulation.servo.checks import check_option, check_time
from ropsim.simulation.servo.stiffness import steep_findings
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.inputs import check_interventions, signal_track, usable_inputs, with_inputs
from ropsim.simulation.state.past_values import memory_ticks
from ropsim.simulation.state.run_options import RunOptions
from ropsim.simulation.state.sensing import Senses
from ropsim.simulation.state.station_run import StationRun
from ropsim.simulation.state.touching import Touching, touching_of
from ropsim.simulation.station.contact_stiffness import stiff_findings
from ropsim.simulation.station.kinematic_plant import KinematicPlant
from ropsim.simulation.station.own_entities import station_chain, station_sensors
from ropsim.simulation.station.servo_plant import ServoPlant
from ropsim.spatial import Pose, frozen


def start_run(cell: Cell, options: RunOptions) -> CellRun:
    """Return the running state of a cell whose arms stand at their start positions.

    Raises:
        OptionError: S703, an option cannot be.
        MissingMassError: M590 or M591, links that drives are to move have no mass.
    """
    check_option("record_hz", options.record_hz)
    check_option("most_rows", options.most_rows)
    check_time("longest", options.longest)
    check_time("longest_wait", options.longest_wait)
    check_interventions(options)
    inputs, findings = usable_inputs(cell, options.inputs)
    input_changes = cell.input_changes
    cell = with_inputs(cell, inputs)
    hz = math.lcm(*(station.controller.rates.control_hz for station in cell.stations.values()))
    content, parts = cell.content, initial_parts(cell)
    scenery = scenery_of(cell, content)
    sensors = CellSensors(cell.signals)
    senses = {
        name: Senses(options.sensors or station_sensors(cell, station, sensors), name)
        for name, station in cell.stations.items()
    }
    touchings = {name: touching_of(cell, name) for name in cell.stations}
    stations = {
        name: _station_run(cell, station, hz, scenery, options, (senses[name], touchings[name]))
        for name, station in cell.stations.items()
    }
    devices = {name: _device_run(cell, device, hz) for name, device in cell.devices.items()}
    moved = [at.carriers(0) for at in stations.values()] + [one.poses(0.0) for one in devices.values()]
    carriers = {body: pose for several in moved for body, pose in several.items()}
    parts, _ = stood(
        parts, tuple(parts.seats), scenery, cell.supports, Moment(carriers, scenery.moving(carriers))
    )
    run = CellRun(
        cell=cell,
        content=content,
        input_changes=input_changes,
        stations=stations,
        devices=devices,
        sensors=sensors,
        scenery=scenery,
        parts=parts,
        hz=hz,
        progress=options.progress,
        ordered=options.ordered,
        plan=options.plan,
        watch=options.watch,
        findings=[
            *findings,
            *undriven(cell, options.fidelity),
            *steep_findings(cell, options.fidelity),
            *stiff_findings(cell, options.fidelity),
        ],
        placements=list(at_start(scenery.tree, parts, scenery.objects)),
        tracks={f"signal.{name}": signal_track(signal, hz) for name, signal in cell.signals.items()},
        inputs=list(inputs),
        supplies=supplies_of(cell),
    )
    for change in in_time(options.overrides):
        run.override_from(tick_at(change.time, hz), change.value)
    if options.stopped is not None:
        run.stop_from(tick_at(options.stopped, hz))
    for one in senses.values():
        one.run = run
    for touching in touchings.values():
        if touching is not None:
            touching.run = run
    return run


def _device_run(cell: Cell, device: Device, hz: int) -> DeviceRun:
    bodies = tuple(link_name(k + 1, device.name) for k in range(len(device.mechanism.joints)))
    changes = [
        change for name in device.listens if name in cell.signals for change in cell.signals[name].changes
    ]
    scripted = tuple(sorted(tick_at(time, hz) for time, _ in changes))
    return DeviceRun(
        device,
        DRIVINGS[type(device.drive)](device.drive),
        bodies,
        scripted,
        AxisProfile([ProfileSegment(0.0, device.q_start, 0.0, 0.0)]),
    )


def _station_run(
    cell: Cell,
    station: Station,
    hz: int,
    scenery: Scenery,
    options: RunOptions,
    around: tuple[Senses, Touching | None],
) -> StationRun:
    mounted = station.tools.get(station.default_tool)
    load = payload({}, scenery.parts, mounted)
    control_hz = station.controller.rates.control_hz
    at = StationRun(
        station=station,
        chain=options.chains.get(station.name) or station_chain(cell, station),
        plant=_plant(cell, station, load, options, around),
        q_command=frozen(station.q_start),
        tool=mounted,
        tool_frames=ToolFrames.beginning_with(mounted.X_MT if mounted else Pose()),
        payload=load,
        last_tick=round(options.longest * control_hz),
        cell_ticks=hz // control_hz,
        memory=memory_ticks(cell, control_hz),
    )
    if options.longest_step is not None:
        at.stride = max(1, round(options.longest_step * control_hz))
    if cell.contacts and cell.devices:  # a device may begin to move what is touched
        at.stride = station.controller.rates.interpolation_ticks
    if options.watch.may_press:  # any intervention acts within an interpolation tick
        at.stride = station.controller.rates.interpolation_ticks
    for name, tool in station.tools.items():
        if tool.fingers:
            at.fingers[tool_body(name, station.name)] = AxisProfile(
                [ProfileSegment(0.0, tool.fingers.opened, 0.0, 0.0)]
            )
    at.track("line", 0.0)
    at.track("move", -1.0)
    at.track("gripper", 0.0)
    at.track("payload", load.mass)
    return at


def _plant(
    cell: Cell, station: Station, load: Payload, options: RunOptions, around: tuple[Senses, Touching | None]
) -> Plant:
    senses, touching = around
    if options.fidelity is Fidelity.KINEMATIC or not station.robot.drives:
        rates = station.controller.rates
        record_ticks = options.record_ticks(rates.control_hz)
        at, most = station.q_start, options.most_rows
        return KinematicPlant(station.robot, at, record_ticks, most, touching, rates.control_period)
    check_moved_masses(station.robot)
    return ServoPlant(cell, station, load, options, senses.read, touching)
