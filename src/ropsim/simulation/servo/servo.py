"""The servo-driven arm: joint controller, drives, gears, friction and rigid bodies, in compiled slices."""

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from ropsim.codegen import Compiled, Engine, StoppedError, bound, default_engine
from ropsim.controller import (
    CompiledLaw,
    LawInput,
    PythonLaw,
    compiled_half,
    joint_law,
    law_arrays,
    law_model,
    step_failed,
    stopped,
)
from ropsim.core import RopsimError
from ropsim.dynamics import (
    arm_numbers,
    barycentric,
    check_model,
    closed_coordinates,
    structure_of,
)
from ropsim.flow import JointReference
from ropsim.kinematics import without_linear_loops
from ropsim.model import ControllerKind, ControllerModel, Payload, Rates, RobotModel
from ropsim.simulation.servo.bench import Bench, compiled_slice
from ropsim.simulation.servo.checks import (
    check_aux,
    check_drives,
    check_law,
    check_option,
    check_output,
    check_rates,
    check_reference,
    check_vector,
)
from ropsim.simulation.servo.diagnostics import BAD_OPTIONS, DivergedError, OptionError
from ropsim.simulation.servo.divergence import diverged, first_fault, has_passed, is_sound, volume_at_rest
from ropsim.simulation.servo.held_state import full_supplies, held_drives, remember_chains, sagging
from ropsim.simulation.servo.plant_code import efforts, plant_code
from ropsim.simulation.servo.plant_steps import plant_steps_of
from ropsim.simulation.servo.recorder import Recorder
from ropsim.simulation.servo.sensing import Sensing, Sensors, is_timed, sensing_of, sensor_rows
from ropsim.simulation.servo.slice_log import Log
from ropsim.simulation.servo.source import NO_SENSORS, servo_functions
from ropsim.simulation.servo.state import ServoState, StateLayout
from ropsim.spatial import Array

NO_PAYLOAD = Payload()


@dataclass(frozen=True, slots=True, eq=False)
class Servo:
    """An arm under its joint controller; make it with `Servo.build`.

    The law runs at the beginning of each control tick, with reference and measurement of that instant; its
    output holds over the tick, and the amplifier clips it. Drives and arm are one system of equations (joint
    coordinates, speeds, states of the drives) that the classical Runge-Kutta method of fourth order
    integrates with `plant_steps` equal steps per tick. Nothing is random and sums keep their order: the same
    calls yield the same bits, independent of the slices of a reference.

    Attributes:
        robot: the arm, with couplings for parallelograms, which stay parallelograms.
        law: the compiled law; for a law in Python the one that holds its output.
        python_law: the law in Python, if there is one.
        layout: of the state vector.
        control_hz: control ticks per second.
        plant_steps: integration steps per control tick.
        sensors: that stand between the arm and the law.
        kernel: the compiled slice.
        bench: arrays shared by its calls.
    """

    robot: RobotModel
    law: CompiledLaw
    python_law: PythonLaw | None
    layout: StateLayout
    control_hz: int
    plant_steps: int
    sensors: Sensors
    kernel: Compiled
    bench: Bench

    @classmethod
    def build(
        cls,
        robot: RobotModel,
        controller: ControllerModel,
        law: CompiledLaw | PythonLaw | None = None,
        engine: Engine | None = None,
        outside_rows: int = 0,
    ) -> "Servo":
        """Return the servo; generates and compiles its slice, or loads it from the cache on disk.

        Args:
            robot: arm with drives.
            controller: rates, and the gains where no law is given.
            law: another law than that of the controller model.
            engine: who runs the slice; None takes numba where it is installed.
            outside_rows: 1 where efforts from outside act on the axes (`ServoState.pressed`), else 0.

        Raises:
            NoDrivesError: the model of the arm has no drives.
            DriveDataError: a constant of a drive is impossible.
            GainError: the gains do not fit the arm.
            OptionError: a rate is not a whole number of at least 1.
            ServoArrayError: the parameters of the law do not fit the arm.
            LawError: a law of your own does not work, or does not fit the drives.
            JointCountError: the arm has no joints, or not exactly one link and one drive for each.
            ModelNumberError: a number of the model is not finite.
        """
        check_drives(robot)
        check_model(robot)
        robot = without_linear_loops(robot)
        check_rates(controller.rates)
        chosen = law or joint_law(controller, robot)
        python_law = None if isinstance(chosen, CompiledLaw) else chosen
        inner = compiled_half(chosen, np.zeros(robot.n))
        check_law(inner, robot)
        sensing = sensing_of(controller, inner)
        own = chosen if law is not None or controller.kind is ControllerKind.FILE else None
        layout = StateLayout.of(structure_of(robot), inner.traits, sensing.kept, outside_rows)
        within = sensing if python_law is None else NO_SENSORS
        functions = servo_functions(structure_of(robot), inner, within, outside_rows)
        kernel = compiled_slice(robot, inner, functions, engine or default_engine(), own)
        return cls._made(robot, controller, (inner, python_law), sensing, (layout, kernel))

    def varied(self, robot: RobotModel, controller: ControllerModel, law: CompiledLaw) -> "Servo":
        """Return the servo of the same structure with other numbers; no code is generated or compiled.

        Args:
            robot: arm that differs in numbers only.
            controller: rates, and sensors of the same kinds.
            law: that of this servo, with other parameters or another model of the arm.

        Raises:
            DriveDataError: a constant of a drive is impossible.
            OptionError: S703, the arm or the law has another structure.
            ModelNumberError: a number of the model is not finite.
        """
        check_drives(robot)
        check_model(robot)
        robot = without_linear_loops(robot)
        is_same = law.source == self.law.source and law.traits == self.law.traits
        if not is_same or structure_of(robot) != structure_of(self.robot):
            message = f"arm `{robot.name}` or law `{law.name}` differs in more than numbers"
            raise OptionError(BAD_OPTIONS.at(None, message, hint="build another servo for it"))
        sensing = sensing_of(controller, law)
        return self._made(robot, controller, (law, self.python_law), sensing, (self.layout, self.kernel))

    @classmethod
    def _made(
        cls,
        robot: RobotModel,
        controller: ControllerModel,
        laws: tuple[CompiledLaw, PythonLaw | None],
        sensing: Sensing,
        code: tuple[StateLayout, Compiled],
    ) -> "Servo":
        """Return a servo around code that is there."""
        (inner, python_law), (layout, kernel) = laws, code
        steps = plant_steps_of(robot, controller.rates)
        rates = replace(controller.rates, plant_steps=steps)
        numbers = sensor_rows(controller, inner)
        bench = Bench.of(kernel, inner, numbers, layout, rates, robot)
        sensors = Sensors(sensing, numbers, is_timed(controller, inner))
        return cls(robot, inner, python_law, layout, rates.control_hz, steps, sensors, kernel, bench)

    @property
    def period(self) -> float:
        """Return the control period [s]."""
        return 1.0 / self.control_hz

    def with_shorter_steps(self, parts: int) -> "Servo":
        """Return the servo with so many times as many integration steps, and work arrays of its own."""
        rates = Rates(self.control_hz, plant_steps=parts * self.plant_steps)
        bench = Bench.of(self.kernel, self.law, self.sensors.numbers, self.layout, rates, self.robot)
        return replace(self, plant_steps=parts * self.plant_steps, bench=bench)

    def initial_state(self, q: npt.ArrayLike, payload: Payload = NO_PAYLOAD) -> ServoState:
        """Return the state at tick 0: at rest on its reference, held against gravity by the drives.

        An integral in the law starts at the output that holds them, so that the arm does not sag when the
        simulation begins.

        Args:
            q: joint coordinates [rad | m], shape (n,).
            payload: body at the mechanical interface.

        Raises:
            ServoArrayError: `q` has another shape or is not finite.
            LoopError: M592, closed chains do not close there.
        """
        n = self.robot.n
        start = check_vector("q", q, n)
        layout = self.layout
        values = np.zeros(layout.size)
        values[layout.q] = at = sagging(self.robot, start, payload)
        layout.in_force(values)[0] = start
        values[layout.supplies] = full_supplies(self.robot)
        if self.robot.cuts:
            values[list(layout.loops.passive)] = closed_coordinates(self.robot, at)
            values[layout.loops.side] = volume_at_rest(self.robot)
            remember_chains(self.law.traits, layout.memory(values), values[list(layout.loops.passive)])
        memory, pending = layout.memory(values), layout.waiting(values)
        for k, held in enumerate(held_drives(self.robot, at, payload)):
            values[list(layout.drive(k))] = held.states
            values[layout.output.start + k] = held.output
            pending[:, k] = held.command
            if self.law.traits.hold_row is not None:
                memory[self.law.traits.hold_row, k] = held.command
        state = ServoState(0, values, layout)
        if layout.sensor_rows:
            values.flags.writeable = True
            self.sensors.begin(self._frame(state), layout.kept(values))
            values.flags.writeable = False
        return state

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
        recorder: Log,
        aux: Array | None = None,
    ) -> ServoState:
        """Follow a reference and return the state after its last tick.

        One compiled call, however long the reference is. Standing still is a reference with constant `q`.

        Args:
            state: initial state; it stays unchanged.
            reference: one row per control tick; row 0 is where the arm should be one control period from now.
                Row k comes into force at the end of tick k; the last one is in force in the state returned.
            payload: body at the mechanical interface, constant over the call.
            recorder: gets the rows of these ticks.
            aux: values of the signals that the law reads, shape (ticks, a); None where it reads none.

        Raises:
            ServoArrayError: the reference, or the output of a law in Python, does not fit the arm.
            LawError: the law reaches beyond its arrays, or in Python raises an exception.
            DivergedError: the state has become NaN or infinite; it names the tick at which that began.
        """
        rows = check_reference(reference, self.layout.n)
        ticks = len(rows[0])
        signals = check_aux(aux, ticks, self.law.traits.aux)
        self.bench.values[:] = state.values
        if self.python_law is None:
            self._advance(state, rows, signals, payload, recorder)
        else:
            self._follow_python_law(self.python_law, state, rows, signals, payload, recorder)
        return ServoState(state.tick + ticks, self.bench.values.copy(), self.layout)

    def _advance(
        self, state: ServoState, reference: "_Rows", signals: Array, payload: Payload, recorder: Log
    ) -> None:
        """Run one slice from a state on, which the bench holds."""
        log, log_row = recorder.claim(state.tick, len(signals))
        call = self.bench.slices.get(payload) or self._slice(payload)
        try:
            call(*reference, signals, log, state.tick, recorder.decimation, log_row, recorder.tally.table)
        except (ArithmeticError, ValueError) as error:  # plain Python raises where compiled code yields NaN
            raise self._fault(state, reference, signals, call, recorder) or error from error
        except (IndexError, StoppedError) as error:
            arrays = self._arguments_at_stop(state, reference, signals, call, payload)
            raise stopped(self.law, error, arrays) from error
        values = self.bench.values
        if not is_sound(values, self.layout) or has_passed(values, self.layout):
            fault = self._fault(state, reference, signals, call, recorder)
            if fault:
                raise fault

    def _arguments_at_stop(
        self, state: ServoState, reference: "_Rows", signals: Array, call: Compiled, payload: Payload
    ) -> dict[str, Array]:
        """Return the arguments of the law at the tick at which a slice stopped."""
        values, no_log, no_tally = self.bench.values, np.empty((1, 1)), np.zeros((4, self.bench.width))
        values[:], before, k = state.values, state, 0
        for k in range(len(signals)):
            before = ServoState(state.tick + k, values.copy(), self.layout)
            rows = (array[k : k + 1] for array in reference)
            try:
                call(*rows, signals[k : k + 1], no_log, before.tick, before.tick + 2, 0, no_tally)
            except (IndexError, StoppedError):
                break
        frame, memory = self._frame(before), self.layout.memory(before.values).copy()
        self.sensors.measure(frame, self.layout.kept(before.values).copy(), before.tick)
        made = law_arrays(self.law, self.robot.n)
        made |= {"ref": before.reference.copy(), "meas": frame[:3].copy(), "sensed": frame[4:].copy()}
        load_ = np.array(barycentric(payload.mass, payload.com, payload.inertia))
        return {**made, "state": memory, "load": load_, "aux": signals[k].copy()}

    def _fault(
        self, state: ServoState, reference: "_Rows", signals: Array, call: Compiled, recorder: Log
    ) -> DivergedError | None:
        """Return the error of a slice, at the tick where that began; None where there is none at any tick."""
        values, no_log, no_tally = self.bench.values, np.empty((1, 1)), np.zeros_like(recorder.tally.table)
        values[:] = state.values

        def advance(k: int) -> None:
            rows = (array[k : k + 1] for array in reference)
            call(*rows, signals[k : k + 1], no_log, state.tick + k, state.tick + k + 2, 0, no_tally)  # no row

        ticks = first_fault(self.robot, values, self.layout, len(signals), advance)
        if ticks is None:
            return None
        after = ServoState(state.tick + ticks, values.copy(), self.layout)
        return diverged(self.robot, after, Rates(self.control_hz, plant_steps=self.plant_steps))

    def _slice(self, payload: Payload) -> Compiled:
        """Return the slice with the constants of the plant, and tool and part as the law takes them."""
        code = plant_code(structure_of(self.robot), self.layout.outside_rows)
        constants = code.constants(arm_numbers(self.robot, payload))
        load_ = np.array(barycentric(payload.mass, payload.com, payload.inertia))
        made = self.bench.slices[payload] = bound(self.bench.slice, constants, load_)
        return made

    def _follow_python_law(
        self,
        law: PythonLaw,
        state: ServoState,
        reference: "_Rows",
        signals: Array,
        payload: Payload,
        recorder: Log,
    ) -> None:
        """Run one tick per slice, each with the output of the law in Python as its only parameter."""
        n, memory = self.robot.n, self.layout.memory(self.bench.values)
        model = law_model(self.robot)
        for k in range(len(signals)):
            before = ServoState(state.tick + k, self.bench.values.copy(), self.layout)
            frame = self._frame(before)
            self.sensors.measure(frame, self.layout.kept(self.bench.values), before.tick)
            now = LawInput(
                before.tick * self.period,
                before.reference.copy(),
                frame[:3],
                payload,
                signals[k].copy(),
                frame[4:],
                model,
            )
            try:
                answer = law.step(now, memory)
            except RopsimError:
                raise
            except Exception as error:  # any exception of a user's code is reported
                raise step_failed(law, error, now.time) from error
            self.bench.parameters[0] = check_output(answer, n, before.tick, self.control_hz)
            q, qd, qdd = (array[k : k + 1] for array in reference)
            self._advance(before, (q, qd, qdd), signals[k : k + 1], payload, recorder)

    def _frame(self, state: ServoState) -> Array:
        """Return true values of what a law is given, shape (4 + r, n).

        These are coordinates of joints, speeds as measured at the motors, torques of drives, a row of zeros,
        and the states of the drives that the law reads.
        """
        found = self.layout.sensed(self.law.traits.sensed)
        rows = [[0.0 if one is None else state.values[one] for one in places] for places in found]
        q, speeds = state.sensed
        return np.array([q, speeds, self.efforts(state), np.zeros(self.robot.n), *rows])

    def efforts(self, state: ServoState) -> Array:
        """Return the torques of the drives at the joints in a state [N·m | N], shape (n,)."""
        tau = np.empty(self.robot.n)
        efforts(self.robot, state.values[: self.layout.integrated], state.output, tau)
        return tau


_Rows = tuple[Array, Array, Array]
"""Coordinates, speeds and accelerations of a reference, as compiled code takes them."""
