"""The servo-driven arm: joint controller, drives, gears, friction and rigid bodies, in compiled slices."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from ropsim.codegen import Compiled, Engine, default_engine, load
from ropsim.controller import CompiledLaw, PythonLaw, external_law, law_of
from ropsim.dynamics import arm_numbers, check_model, compiled, identifier, steady_drive, structure_of
from ropsim.flow import JointReference
from ropsim.model import ControllerModel, Payload, RobotModel
from ropsim.simulation.recorder import Recorder
from ropsim.simulation.servo_checks import (
    check_drives,
    check_law,
    check_option,
    check_rates,
    check_reference,
    check_vector,
    diverged,
)
from ropsim.simulation.servo_source import plant_code, servo_functions
from ropsim.simulation.servo_state import ServoState, StateLayout
from ropsim.spatial import Array

NO_PAYLOAD = Payload()


@dataclass(frozen=True, slots=True, eq=False)
class Servo:
    """An arm under its joint controller; make it with `Servo.build`.

    The law runs once per control tick, its output holds over the tick, and the amplifier clips it. Drives and
    arm are one system of equations (joint coordinates, speeds, states of the drives) that the classical
    Runge-Kutta method of fourth order integrates with `plant_steps` equal steps per tick. Nothing is random
    and sums keep their order: the same calls give the same bits, however a reference is cut into slices.

    Attributes:
        robot: the arm.
        law: the compiled law; for a law in Python the one that holds its output.
        python_law: the law in Python, if there is one.
        layout: of the state vector.
        control_hz: control ticks per second.
        plant_steps: integration steps per control tick.
        kernel: the compiled slice.
    """

    robot: RobotModel
    law: CompiledLaw
    python_law: PythonLaw | None
    layout: StateLayout
    control_hz: int
    plant_steps: int
    kernel: Compiled

    @classmethod
    def build(
        cls,
        robot: RobotModel,
        controller: ControllerModel,
        law: CompiledLaw | PythonLaw | None = None,
        engine: Engine | None = None,
    ) -> "Servo":
        """Return the servo; generates and compiles its slice, or loads it from the cache on disk.

        Args:
            robot: arm with drives.
            controller: rates, and the gains where no law is given.
            law: another law than that of the controller model.
            engine: who runs the slice; None takes numba where it is installed.

        Raises:
            NoDrivesError: the model of the arm has no drives.
            DriveDataError: a constant of a drive is impossible.
            GainError: the gains do not fit the arm.
            OptionError: a rate is not a whole number of at least 1.
            ServoArrayError: the parameters of the law do not fit the arm.
            ChainTooLongError: no code can be generated for the arm.
            ModelNumberError: a number of the model is not finite.
        """
        check_drives(robot)
        check_model(robot)
        check_rates(controller.rates)
        inner, python_law = _split(law or law_of(controller, robot.drives), robot.n)
        check_law(inner, robot.n)
        name = f"{identifier(robot.name)}_servo_{inner.name}"
        structure = structure_of(robot)
        kernel = load(name, servo_functions(structure, inner), engine or default_engine())
        layout = StateLayout.of(structure.drives, len(inner.state_names))
        rates = controller.rates
        return cls(robot, inner, python_law, layout, rates.control_hz, rates.plant_steps, kernel)

    @property
    def period(self) -> float:
        """Return the control period [s]."""
        return 1.0 / self.control_hz

    def initial_state(self, q: npt.ArrayLike, payload: Payload = NO_PAYLOAD) -> ServoState:
        """Return the state at tick 0: at rest, held against gravity by the drives.

        An integral in the law starts at the output that holds them, so that the arm does not sag when the
        simulation begins; a law in Python is told to reset.

        Args:
            q: joint coordinates [rad | m], shape (n,).
            payload: body at the mechanical interface.

        Raises:
            ServoArrayError: `q` has another shape or is not finite.
        """
        n = self.robot.n
        start = check_vector("q", q, n)
        tau = np.empty(n)
        rest = np.zeros(n)
        # a single evaluation: plain Python is faster than compiling it
        compiled(self.robot, payload, Engine.PYTHON).rigid_inverse(start, rest, rest, np.zeros(6), tau)
        values = np.zeros(self.layout.size)
        values[self.layout.q] = start
        memory = values[self.layout.law].reshape(self.layout.law_rows, n)
        for k, drive in enumerate(self.robot.drives):
            held = steady_drive(drive, float(start[k]), 0.0, float(tau[k]))
            values[list(self.layout.drive(k))] = held.states
            values[self.layout.output.start + k] = held.output
            if self.law.hold_row is not None:
                memory[self.law.hold_row, k] = held.command
        if self.python_law is not None:
            self.python_law.reset(start)
        return ServoState(0, values, self.layout)

    def recorder(self, start: ServoState, decimation: int = 1) -> Recorder:
        """Return a recorder that begins at `start` and keeps one row per `decimation` control ticks.

        Raises:
            OptionError: the decimation is not a whole number of at least 1.
        """
        check_option("decimation", decimation)
        return Recorder(self.robot, start, decimation)

    def run(
        self, state: ServoState, reference: JointReference, payload: Payload, recorder: Recorder
    ) -> ServoState:
        """Follow a reference and return the state after its last tick.

        One compiled call, however long the reference is. Standing still is a reference with constant `q`.

        Args:
            state: where to start; it stays as it is.
            reference: one row per control tick; row 0 is where the arm should be one control period from now.
            payload: body at the mechanical interface, constant over the call.
            recorder: gets the rows of these ticks.

        Raises:
            ServoArrayError: the reference, or the output of a law in Python, does not fit the arm.
            DivergedError: the state has become NaN or infinite.
        """
        work = _Work(
            np.array(state.values),
            state.tick,
            check_reference(reference, self.robot.n),
            _constants(self.robot, payload),
            recorder,
        )
        if self.python_law is None:
            self._advance(work, slice(0, reference.ticks), np.array(self.law.parameters))
        else:
            self._follow_python_law(self.python_law, work)
        after = ServoState(state.tick + reference.ticks, work.values, self.layout)
        if not after.is_finite():
            raise diverged(self.robot, after, self.control_hz)
        return after

    def _advance(self, work: "_Work", rows: slice, parameters: Array) -> None:
        """Run one slice over some rows of the reference."""
        n = self.robot.n
        q_ref, qd_ref, qdd_ref = (array[rows] for array in work.reference)
        tick = work.tick + rows.start
        recorder = work.recorder
        log, row = recorder.claim(tick, len(q_ref))
        plan = (tick, recorder.decimation, row, self.plant_steps, self.period)
        size = self.layout.integrated
        memory = work.values[self.layout.law].reshape(self.layout.law_rows, n)
        state = (work.values[:size], work.values[self.layout.output], memory)
        room = (np.empty((3, n)), np.zeros((3, n)), np.empty((5, size)))
        try:
            self.kernel(*state, q_ref, qd_ref, qdd_ref, parameters, work.constants, log, *room, *plan)
        except (ArithmeticError, ValueError) as error:  # plain Python raises where compiled code gives NaN
            after = ServoState(tick, work.values, self.layout)
            raise diverged(self.robot, after, self.control_hz) from error

    def _follow_python_law(self, law: PythonLaw, work: "_Work") -> None:
        """Run one tick per slice, each with the output of the law in Python as its only parameter."""
        n = self.robot.n
        for k in range(len(work.reference[0])):
            ref = np.stack([array[k] for array in work.reference])
            meas = work.values[: 2 * n].reshape(2, n).copy()
            u = check_vector("u", law.step(ref, meas, (work.tick + k) * self.period), n)
            self._advance(work, slice(k, k + 1), u.reshape(1, n))


@dataclass(frozen=True, slots=True, eq=False)
class _Work:
    """One call of `Servo.run`: state vector (written in place), tick, reference, constants, recorder."""

    values: Array
    tick: int
    reference: tuple[Array, Array, Array]
    constants: Array
    recorder: Recorder


def _split(law: CompiledLaw | PythonLaw, n: int) -> tuple[CompiledLaw, PythonLaw | None]:
    """Return the compiled half of a law and the half in Python, if there is one."""
    return (law, None) if isinstance(law, CompiledLaw) else (external_law(n), law)


@lru_cache(maxsize=256)
def _constants(robot: RobotModel, payload: Payload) -> Array:
    """Return what the code of the plant makes of the numbers of an arm with a payload."""
    return plant_code(structure_of(robot)).constants(arm_numbers(robot, payload))
