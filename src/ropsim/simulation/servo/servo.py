"""The servo-driven arm: joint controller, drives, gears, friction and rigid bodies, in compiled slices."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ropsim.codegen import Compiled, Engine, StoppedError, default_engine, load, pinned
from ropsim.controller import CompiledLaw, LawInput, PythonLaw, compiled_half, failed, law_of, rehearse
from ropsim.core import RopsimError
from ropsim.dynamics import (
    arm_numbers,
    barycentric,
    check_model,
    compiled,
    identifier,
    steady_drive,
    structure_of,
)
from ropsim.flow import JointReference
from ropsim.model import ControllerModel, Payload, RobotModel
from ropsim.simulation.servo.checks import (
    check_aux,
    check_drives,
    check_law,
    check_option,
    check_rates,
    check_reference,
    check_vector,
    diverged,
)
from ropsim.simulation.servo.plant_code import efforts, plant_code
from ropsim.simulation.servo.recorder import Recorder
from ropsim.simulation.servo.source import servo_functions
from ropsim.simulation.servo.state import ServoState, StateLayout
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
        bench: what its calls share.
    """

    robot: RobotModel
    law: CompiledLaw
    python_law: PythonLaw | None
    layout: StateLayout
    control_hz: int
    plant_steps: int
    kernel: Compiled
    bench: "_Bench"

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
            LawError: a law of your own does not work, or does not fit the drives.
            JointCountError: the arm has no joints, or not one link and one drive for each.
            ModelNumberError: a number of the model is not finite.
        """
        check_drives(robot)
        check_model(robot)
        check_rates(controller.rates)
        chosen = law or law_of(controller, robot)
        python_law = None if isinstance(chosen, CompiledLaw) else chosen
        inner = compiled_half(chosen, np.zeros(robot.n))
        check_law(inner, robot)
        kernel = _kernel(robot, inner, engine or default_engine(), law)
        layout = StateLayout.of(structure_of(robot).drives, inner.traits)
        rates = controller.rates
        bench = _Bench.of(kernel, inner, layout)
        return cls(robot, inner, python_law, layout, rates.control_hz, rates.plant_steps, kernel, bench)

    @property
    def period(self) -> float:
        """Return the control period [s]."""
        return 1.0 / self.control_hz

    def initial_state(self, q: npt.ArrayLike, payload: Payload = NO_PAYLOAD) -> ServoState:
        """Return the state at tick 0: at rest, held against gravity by the drives.

        An integral in the law starts at the output that holds them, so that the arm does not sag when the
        simulation begins.

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
        memory, pending = self._memory(values), self._pending(values)
        for k, drive in enumerate(self.robot.drives):
            held = steady_drive(drive, float(start[k]), 0.0, float(tau[k]))
            values[list(self.layout.drive(k))] = held.states
            values[self.layout.output.start + k] = held.output
            pending[:, k] = held.command
            if self.law.traits.hold_row is not None:
                memory[self.law.traits.hold_row, k] = held.command
        return ServoState(0, values, self.layout)

    def recorder(self, start: ServoState, decimation: int = 1) -> Recorder:
        """Return a recorder that begins at `start` and keeps one row per `decimation` control ticks.

        Raises:
            OptionError: the decimation is not a whole number of at least 1.
        """
        check_option("decimation", decimation)
        return Recorder(self.robot, start, decimation)

    def run(
        self,
        state: ServoState,
        reference: JointReference,
        payload: Payload,
        recorder: Recorder,
        aux: Array | None = None,
    ) -> ServoState:
        """Follow a reference and return the state after its last tick.

        One compiled call, however long the reference is. Standing still is a reference with constant `q`.

        Args:
            state: where to start; it stays as it is.
            reference: one row per control tick; row 0 is where the arm should be one control period from now.
            payload: body at the mechanical interface, constant over the call.
            recorder: gets the rows of these ticks.
            aux: values of the signals that the law reads, shape (ticks, a); None where it reads none.

        Raises:
            ServoArrayError: the reference, or the output of a law in Python, does not fit the arm.
            LawError: the law reaches beyond its arrays, or in Python raises an exception.
            DivergedError: the state has become NaN or infinite.
        """
        work = _Work(
            np.array(state.values),
            state.tick,
            check_reference(reference, self.robot.n),
            check_aux(aux, reference.ticks, self.law.traits.aux),
            payload,
            recorder,
        )
        if self.python_law is None:
            self._advance(work, slice(0, reference.ticks), self.bench.parameters)
        else:
            self._follow_python_law(self.python_law, work)
        after = ServoState(state.tick + reference.ticks, work.values, self.layout)
        if not after.is_finite():
            raise diverged(self.robot, after, self.control_hz)
        return after

    def _advance(self, work: "_Work", rows: slice, parameters: object) -> None:
        """Run one slice over some rows of the reference."""
        q_ref, qd_ref, qdd_ref = (array[rows] for array in work.reference)
        tick = work.tick + rows.start
        recorder = work.recorder
        log, row = recorder.claim(tick, len(q_ref))
        plan = (tick, recorder.decimation, row, self.plant_steps, self.period)
        values, room = work.values, self.bench.room
        given = (parameters, *self.bench.of_payload(self.robot, self.kernel, work.payload))
        state = (values, self._pending(values), self._memory(values))
        try:
            self.kernel(*state, q_ref, qd_ref, qdd_ref, work.aux[rows], *given, log, *room, *plan)
        except (ArithmeticError, ValueError) as error:  # plain Python raises where compiled code gives NaN
            after = ServoState(tick, work.values, self.layout)
            raise diverged(self.robot, after, self.control_hz) from error
        except (IndexError, StoppedError) as error:
            raise failed(self.law, error) from error

    def _follow_python_law(self, law: PythonLaw, work: "_Work") -> None:
        """Run one tick per slice, each with the output of the law in Python as its only parameter."""
        n = self.robot.n
        for k in range(len(work.reference[0])):
            ref = np.stack([array[k] for array in work.reference])
            meas = self._measured(work)
            now = LawInput((work.tick + k) * self.period, ref, meas, work.payload, work.aux[k].copy())
            try:
                answer = law.step(now, self._memory(work.values))
            except RopsimError:
                raise
            except Exception as error:  # whatever the code of a user raises is told
                raise failed(self.law, error) from error
            u = check_vector("u", answer, n)
            self._advance(work, slice(k, k + 1), u.reshape(1, n))

    def _measured(self, work: "_Work") -> Array:
        """Return coordinates, speeds and torques of the drives, shape (3, n)."""
        meas = np.empty((3, self.robot.n))
        meas[0], meas[1] = work.values[self.layout.q], work.values[self.layout.qd]
        x, u = work.values[: self.layout.integrated], work.values[self.layout.output]
        efforts(self.robot, x, u, meas[2])
        return meas

    def _memory(self, values: Array) -> Array:
        """Return what the law remembers, a view by rows."""
        return values[self.layout.law].reshape(self.layout.law_rows, self.robot.n)

    def _pending(self, values: Array) -> Array:
        """Return the outputs that wait for their tick, a view by rows."""
        return values[self.layout.pending].reshape(self.layout.delay, self.robot.n)


@dataclass(frozen=True, slots=True, eq=False)
class _Bench:
    """What the calls of a slice share; nothing of it lasts from one call to the next.

    Attributes:
        room: to work in.
        parameters: of the law.
        given: by payload, what the code of the plant and the law take for it.
    """

    room: tuple[object, object]
    parameters: object
    given: dict[Payload, tuple[object, object]]

    @classmethod
    def of(cls, kernel: Compiled, law: CompiledLaw, layout: StateLayout) -> "_Bench":
        room = (np.zeros((7, layout.n)), np.zeros((5, layout.integrated)))
        first, second = (pinned(kernel, array) for array in room)
        return cls((first, second), pinned(kernel, np.array(law.parameters)), {})

    def of_payload(self, robot: RobotModel, kernel: Compiled, payload: Payload) -> tuple[object, object]:
        """Return the constants of the plant, and tool and part as the law takes them."""
        if payload not in self.given:
            constants = plant_code(structure_of(robot)).constants(arm_numbers(robot, payload))
            load_ = np.array(barycentric(payload.mass, payload.com, payload.inertia))
            self.given[payload] = (pinned(kernel, constants), pinned(kernel, load_))
        return self.given[payload]


@dataclass(frozen=True, slots=True, eq=False)
class _Work:
    """One call of `Servo.run`: state vector (written in place), tick, reference, signals, load, recorder."""

    values: Array
    tick: int
    reference: tuple[Array, Array, Array]
    aux: Array
    payload: Payload
    recorder: Recorder


def _kernel(
    robot: RobotModel, law: CompiledLaw, engine: Engine, own: CompiledLaw | PythonLaw | None
) -> Compiled:
    """Return the compiled slice; `own` is the law of a user, which is tried first."""
    functions = servo_functions(structure_of(robot), law)
    name = f"{identifier(robot.name)}_servo_{law.name}"
    if not isinstance(own, CompiledLaw):
        return load(name, functions, engine)
    rehearse(law, robot.n)
    try:
        return load(name, functions, engine)
    except Exception as error:  # numba has a family of errors for code that it cannot compile
        raise failed(law, error) from error
