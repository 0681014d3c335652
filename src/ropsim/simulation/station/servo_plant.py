"""The servo-driven arm as a plant: true drives and dynamics, in compiled slices."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ropsim.core import RopsimError
from ropsim.flow import IntegrationFacts, JointReference
from ropsim.model import Cell, Payload, Station
from ropsim.planning import Sample
from ropsim.simulation.records.plant import constant
from ropsim.simulation.records.tally import Tally
from ropsim.simulation.servo.checks import check_signals
from ropsim.simulation.servo.integration import integration_facts
from ropsim.simulation.servo.kept_drives import Driving, driven_anew
from ropsim.simulation.servo.recorder import Recorder
from ropsim.simulation.servo.servo import Servo
from ropsim.simulation.servo.state import ServoState
from ropsim.simulation.servo.tick_recorder import TickRecorder
from ropsim.simulation.state.past_values import memory_ticks
from ropsim.simulation.state.run_options import RunOptions
from ropsim.simulation.state.touching import Touching
from ropsim.simulation.station.wrench_log import WrenchLog
from ropsim.spatial import Array


class ServoPlant:
    """Follows references as drives, gears, friction and inertia allow.

    Args:
        cell: with the signals.
        station: the arm and its controller.
        payload: body at the mechanical interface at time 0.
        options: the joint controller and how densely to record.
        read: delivers the signals that the law reads, by name at a time [s].
        touching: meant contacts; None where there are none.

    Raises:
        LawError: C602, the law reads a signal that the cell does not have.
    """

    def __init__(
        self,
        cell: Cell,
        station: Station,
        payload: Payload,
        options: RunOptions,
        read: Callable[[str, float], Sample],
        touching: Touching | None = None,
    ) -> None:
        robot, law = station.robot, options.laws.get(station.name)
        self._name, self._servo = (
            station.name,
            Servo.build(robot, station.controller, law, outside_rows=0 if touching is None else 1),
        )
        self._drive = driven_anew if law or self._servo.python_law else options.drive
        self._read = read
        if options.sensors is None:
            check_signals(self._servo.law, cell)
        self._state = self._servo.initial_state(station.q_start, payload)
        self._integration = integration_facts(self._servo, station.controller.rates, self._state, payload)
        record_ticks = options.record_ticks(self._servo.control_hz)
        others = len(cell.stations) + len(cell.devices) > 1
        kind = TickRecorder if others or memory_ticks(cell, self._servo.control_hz) else Recorder
        self._recorder = kind(robot, self._state, record_ticks, options.most_rows)
        self._pressed = None
        if touching is not None:
            self._pressed = WrenchLog(touching, self._state.tick, record_ticks, options.most_rows)
        self._is_lost = False

    @property
    def q(self) -> Array:
        """Return the attained joint coordinates [rad | m], shape (n,)."""
        return self._state.q

    @property
    def qd(self) -> Array:
        """Return the attained joint speeds [rad/s | m/s], shape (n,)."""
        return self._state.qd

    @property
    def sensed(self) -> Array:
        """Return coordinates and speeds as motors measure them, before elastic links, shape (2, n)."""
        return self._state.sensed

    @property
    def effort(self) -> Array:
        """Return the torques of the drives at the joints [N·m | N], shape (n,)."""
        return self._servo.efforts(self._state)

    @property
    def record_ticks(self) -> int:
        """Return the control ticks between two recorded rows."""
        return self._recorder.record_ticks

    @property
    def tally(self) -> Tally:
        """Return the worst of all control ticks so far."""
        return self._recorder.tally

    @property
    def wrench(self) -> Array:
        """Return the contact force [N] and moment [N·m] at the mechanical interface; see `Plant.wrench`."""
        return self._pressed.wrench if self._pressed else np.zeros(6)

    @property
    def plant_steps(self) -> int:
        """Return the integration steps of drives and arm per control tick; 1 where nothing is integrated."""
        return self._servo.plant_steps

    @property
    def integration(self) -> IntegrationFacts:
        """Return how drives and arm are integrated."""
        return self._integration

    @property
    def tick(self) -> int:
        """Return the control tick that it has come to."""
        return self._state.tick

    def follow(self, reference: JointReference, payload: Payload) -> None:
        """Advance by one control tick per row of `reference`, in one compiled call at the most.

        After an error it stands at the end of the last tick at which all its numbers were finite, and stays
        there.
        """
        if self._is_lost:
            self._recorder.freeze(self._state, reference.ticks)
            if self._pressed:
                self._pressed.enter(self._state.tick, reference.ticks, np.zeros(6))
            self._state = replace(self._state, tick=self._state.tick + reference.ticks)
            return
        first = self._state.tick
        try:
            self._drive_along(reference, payload)
        except RopsimError:
            self._is_lost = True
            self._go_as_far_as_possible(reference, payload, first)
            raise

    def _go_as_far_as_possible(self, reference: JointReference, payload: Payload, first: int) -> None:
        """Advance to the end of the last tick at which nothing is wrong, by halves.

        Args:
            reference: that could not be followed to its end.
            payload: body at the mechanical interface.
            first: tick at which it begins.
        """
        wrong = first + reference.ticks
        while wrong - self._state.tick > 1:
            middle = (self._state.tick + wrong) // 2
            try:
                self._drive_along(reference.part(self._state.tick - first, middle - first), payload)
            except RopsimError:
                wrong = middle

    def _drive_along(self, reference: JointReference, payload: Payload) -> None:
        """Follow a reference in one compiled call, or tick by tick while something may be touched."""
        signals = self._signals(reference.ticks)
        if self._pressed is None:
            self._state = self._driven(self._drive, reference, payload, signals)
            return
        done, half = 0, 0.5 * self._servo.period
        while done < reference.ticks:
            state = self._state
            found = self._pressed.touching.exerted(state.q + half * state.qd, state.qd, state.tick, payload)
            until = min(done + max(found.quiet, 1), reference.ticks)
            self._state = state.pressed(found.efforts)
            drive = self._drive if found.quiet > 1 else driven_anew
            try:
                self._state = self._driven(drive, reference.part(done, until), payload, signals[done:until])
            except RopsimError:
                self._state = state
                raise
            self._pressed.enter(state.tick, until - done, found.wrench)
            done = until

    def _driven(
        self, drive: Driving, reference: JointReference, payload: Payload, signals: Array
    ) -> ServoState:
        return drive(self._name, self._servo, self._state, reference, payload, self._recorder, signals)

    def hold(self, q: Array, ticks: int, payload: Payload) -> None:
        """Advance by `ticks` control ticks with a constant reference."""
        self.follow(constant(q, ticks), payload)

    def log(self) -> dict[str, Array]:
        """Return the recorded channels, and their ticks as `tick`."""
        pressed = self._pressed.channels() if self._pressed else {}
        return {"tick": self._recorder.ticks, **self._recorder.channels(), **pressed}

    def at(self, tick: float) -> dict[str, Array]:
        """Return the recorded channels at a tick, linear between two rows, shape (n,) each."""
        pressed = self._pressed.at(tick) if self._pressed else {}
        return {**self._recorder.at(tick), **pressed}

    def q_at(self, tick: float) -> Array:
        """Return the attained joint coordinates at a tick that is not forgotten [rad | m], shape (n,)."""
        return self._recorder.q_at(tick)

    def wrench_at(self, tick: float) -> Array:
        """Return the contact wrench at a tick that is not forgotten, as `wrench`; shape (6,)."""
        return self._pressed.wrench_at(tick) if self._pressed else np.zeros(6)

    def forget(self, tick: int) -> None:
        """Allow discarding positions of the arm before a tick."""
        self._recorder.forget(tick)
        if self._pressed:
            self._pressed.forget(tick)

    def _signals(self, ticks: int) -> Array:
        """Return the signals of the law at the next ticks, shape (ticks, a); 0 where a signal is not valid.

        All of a slice is read before it, when the arm is where it begins.
        """
        names = self._servo.law.traits.aux
        values = np.zeros((ticks, len(names)))
        for column, name in enumerate(names):
            for k in range(ticks):
                sample = self._read(name, (self._state.tick + k) * self._servo.period)
                values[k, column] = float(sample.value) if sample.valid else 0.0
        return values
