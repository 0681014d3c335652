"""Simulate an arm that follows joint references."""

from collections.abc import Iterable, Iterator
from dataclasses import field, replace

from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, PythonLaw, joint_law
from ropsim.flow import JointReference, Recording, RunFacts
from ropsim.model import ROBOT, ControllerModel, Payload, RobotModel
from ropsim.simulation.recording.channels import joint_channels
from ropsim.simulation.servo.checks import check_option
from ropsim.simulation.servo.diagnostics import BAD_OPTIONS, DivergedError, OptionError
from ropsim.simulation.servo.integration import integration_facts
from ropsim.simulation.servo.log import drive_powers
from ropsim.simulation.servo.servo import Servo
from ropsim.simulation.state.variation import Variation, varied_law, varied_robot, without_shapes
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
    _check(options, reference)
    servo = Servo.build(robot, controller, options.law, options.engine)
    return _recorded(servo, controller, reference, options)


def simulate_variations(
    robot: RobotModel,
    controller: ControllerModel,
    reference: JointReference,
    variations: Iterable[Variation],
    options: SimulationOptions | None = None,
) -> Iterator[Recording | DivergedError]:
    """Yield the recording of an arm for each of several choices of its numbers; see `simulate`.

    Code is loaded once, or compiled where there is none yet. The law is that of the arm as it is given: what
    it believes about masses and friction does not vary. Integration steps follow from the numbers of each.

    Args:
        robot: arm with drives, as the law knows it.
        controller: rates and gains.
        reference: one row per control tick, at least one.
        variations: their numbers, in the order of the results.
        options: None for the defaults; `slice_ticks` has no part in it.

    Yields:
        the recording, or the error where the motion diverges.

    Raises:
        OptionError: S703, an option or a variation cannot be, or the law is one in Python.
        LawError: the law does not fit.
    """
    options = options or SimulationOptions()
    _check(options, reference)
    law = options.law or joint_law(controller, robot)
    if not isinstance(law, CompiledLaw):
        message = f"the law of arm `{robot.name}` is an object in Python, which runs tick by tick"
        raise OptionError(BAD_OPTIONS.at(None, message, hint="give a CompiledLaw, or call `simulate`"))
    bare = without_shapes(robot)
    servo = Servo.build(bare, controller, law, options.engine)
    for one in variations:
        made = servo.varied(varied_robot(bare, one), controller, varied_law(law, one))
        payload = options.payload if one.payload is None else one.payload
        chosen = replace(options, payload=payload, slice_ticks=reference.ticks)
        try:
            yield _recorded(made, controller, reference, chosen)
        except DivergedError as error:
            yield error


def _check(options: SimulationOptions, reference: JointReference) -> None:
    check_option("decimation", options.decimation)
    check_option("slice_ticks", options.slice_ticks)
    check_option("reference.ticks", reference.ticks)


def _recorded(
    servo: Servo, controller: ControllerModel, reference: JointReference, options: SimulationOptions
) -> Recording:
    """Return the recording of a servo that starts at rest and follows a reference."""
    robot = servo.robot
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
