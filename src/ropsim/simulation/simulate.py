"""Simulate an arm that follows joint references."""

from dataclasses import field

from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, PythonLaw
from ropsim.flow import JointReference, Recording, RunFacts
from ropsim.model import ROBOT, ControllerModel, Payload, RobotModel
from ropsim.simulation.recording.channels import joint_channels
from ropsim.simulation.servo.checks import check_option
from ropsim.simulation.servo.integration import integration_facts
from ropsim.simulation.servo.log import drive_powers
from ropsim.simulation.servo.servo import Servo
from ropsim.simulation.station.station_facts import station_facts, with_law
from ropsim.spatial import Array, record
from ropsim.version import __version__


@record
class SimulationOptions:
    """How a simulation runs.

    Attributes:
        decimation: control ticks between two rows of the recording.
        slice_ticks: control ticks per compiled call; does not change the result.
        start: joint coordinates at time 0 [rad | m], shape (n,); None = the first row of the reference.
        payload: body at the mechanical interface.
        law: another joint controller than that of the controller model.
        engine: who runs the generated code; None takes numba where it is installed.
    """

    decimation: int = 1
    slice_ticks: int = 20
    start: Array | None = None
    payload: Payload = field(default_factory=Payload)
    law: CompiledLaw | PythonLaw | None = None
    engine: Engine | None = None


def simulate(
    robot: RobotModel,
    controller: ControllerModel,
    reference: JointReference,
    options: SimulationOptions | None = None,
) -> Recording:
    """Return the recording of an arm that starts at rest and follows a reference.

    Channels, shape (rows, n) with the joint names as columns: q, qd, tau, current, voltage, q_ref, qd_ref,
    q_error and power. Row k is at time k · decimation / control_hz; row 0 is the start.

    Args:
        robot: arm with drives.
        controller: rates and gains.
        reference: one row per control tick, at least one; row 0 belongs to the end of the first tick.
        options: None for the defaults.

    Raises:
        NoDrivesError: the model of the arm has no drives.
        DriveDataError: a constant of a drive is impossible.
        OptionError: an option or a rate is out of range.
        ServoArrayError: reference, start or gains do not fit the arm.
        DivergedError: the state has become NaN or infinite.
    """
    options = options or SimulationOptions()
    check_option("decimation", options.decimation)
    check_option("slice_ticks", options.slice_ticks)
    check_option("reference.ticks", reference.ticks)
    servo = Servo.build(robot, controller, options.law, options.engine)
    state = servo.initial_state(reference.q[0] if options.start is None else options.start, options.payload)
    integration = integration_facts(servo, controller.rates, state, options.payload)
    recorder = servo.recorder(state, options.decimation)
    for first in range(0, reference.ticks, options.slice_ticks):
        rows = slice(first, first + options.slice_ticks)
        part = JointReference(reference.q[rows], reference.qd[rows], reference.qdd[rows])
        state = servo.run(state, part, options.payload, recorder)
    log = recorder.channels()
    log["q_error"] = log["q_ref"] - log["q"]
    log |= drive_powers(robot, log)
    hz = servo.control_hz
    station = station_facts(ROBOT, robot, controller, servo.plant_steps, integration)
    station = with_law(station, controller, options.law)
    facts = RunFacts(__version__, record_hz=hz / recorder.decimation, stations=(station,))
    channels = joint_channels(ROBOT, robot, log)
    return Recording(recorder.ticks / hz, channels, (), (), state.tick / hz, facts)
