"""The state of a run at time 0."""

from ropsim.controller import ScriptedSensors, SensorInterface, standard_chain
from ropsim.flow import Fidelity
from ropsim.model import Cell, Payload
from ropsim.simulation.cell_run import CellRun
from ropsim.simulation.inputs import signal_track, usable_inputs, with_inputs
from ropsim.simulation.kinematic_plant import KinematicPlant
from ropsim.simulation.parts import initial_parts, payload
from ropsim.simulation.placements import at_start
from ropsim.simulation.plant import Plant
from ropsim.simulation.run_options import RunOptions
from ropsim.simulation.scenery import scenery_of
from ropsim.simulation.servo.plant import ServoPlant
from ropsim.simulation.standing import stood
from ropsim.spatial import Array, frozen


def start_run(cell: Cell, options: RunOptions) -> CellRun:
    """Return the running state of a cell whose arm stands at its start position."""
    inputs, findings = usable_inputs(cell, options.inputs)
    cell = with_inputs(cell, inputs)
    q: Array = cell.start if len(cell.start) else cell.robot.home
    scenery, parts = scenery_of(cell), initial_parts(cell)
    parts, _ = stood(parts, tuple(parts.seats), scenery, cell.supports)
    tool = cell.tools.get(cell.default_tool)
    load = payload(parts, scenery.parts, tool)
    sensors = ScriptedSensors(cell.signals)
    state = CellRun(
        cell=cell,
        chain=options.chain or standard_chain(cell),
        plant=_plant(cell, q, load, options, options.sensors or sensors),
        sensors=sensors,
        q_command=frozen(q),
        scenery=scenery,
        parts=parts,
        tool=tool,
        payload=load,
        progress=options.progress,
        last_tick=round(options.longest * cell.controller.rates.control_hz),
        watch=options.watch,
        findings=list(findings),
        placements=list(at_start(scenery.tree, parts, scenery.ground.poses)),
        inputs=list(inputs),
    )
    state.track("line", 0.0)
    state.track("move", -1.0)
    state.track("gripper", 0.0)
    state.track("payload", load.mass)
    for name, signal in cell.signals.items():
        state.tracks[f"signal.{name}"] = signal_track(signal, cell.controller.rates.control_hz)
    return state


def _plant(cell: Cell, q: Array, load: Payload, options: RunOptions, sensors: SensorInterface) -> Plant:
    if options.fidelity is Fidelity.KINEMATIC:
        record_ticks = options.record_ticks(cell.controller.rates.control_hz)
        return KinematicPlant(q, record_ticks, options.most_rows)
    return ServoPlant(cell, q, load, options, sensors)
