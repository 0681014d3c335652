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
from ropsim.simulation.servo.kept_drives import driven_anew
from ropsim.simulation.servo.recorder import Recorder
from ropsim.simulation.servo.servo import Servo
from ropsim.simulation.servo.state import ServoState
from ropsim.simulation.servo.tick_recorder import TickRecorder
from ropsim.simulation.state.run_options import RunOptions
from ropsim.spatial import Array


class ServoPlant:
    """Follows references as drives, gears, friction and inertia allow.

    Args:
        cell: with the signals.
        station: the arm and its controller.
        payload: body at the mechanical interface at time 0.
        options: the joint controller and how densely to record.
        read: delivers the signals that the law reads, by name at a time [s].

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
    ) -> None:
        robot, law = station.robot, options.laws.get(station.name)
        self._name, self._servo = station.name, Servo.build(robot, station.controller, law)
        self._drive = driven_anew if law or self._servo.python_law else options.drive
        self._read = read
        if options.sensors is None:
            check_signals(self._servo.law, cell)
        self._state = self._servo.initial_state(station.q_start, payload)
        self._integration = integration_facts(self._servo, station.controller.rates, self._state, payload)
        record_ticks = options.record_ticks(self._servo.control_hz)
        others = len(cell.stations) + len(cell.devices) > 1
        kind = TickRecorder if others else Recorder
        self._recorder = kind(robot, self._state, record_ticks, options.most_rows)
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
            self._state = replace(self._state, tick=self._state.tick + reference.ticks)
            return
        try:
            self._state = self._driven(reference, payload)
        except RopsimError:
            self._is_lost = True
            self._go_as_far_as_possible(reference, payload)
            raise

    def _go_as_far_as_possible(self, reference: JointReference, payload: Payload) -> None:
        """Advance to the end of the last tick at which nothing is wrong, by halves."""
        sound, wrong = 0, reference.ticks
        while wrong - sound > 1:
            middle = (sound + wrong) // 2
            try:
                self._state = self._driven(reference.part(sound, middle), payload)
                sound = middle
            except RopsimError:
                wrong = middle

    def _driven(self, reference: JointReference, payload: Payload) -> ServoState:
        aux = self._signals(reference.ticks)
        return self._drive(self._name, self._servo, self._state, reference, payload, self._recorder, aux)

    def hold(self, q: Array, ticks: int, payload: Payload) -> None:
        """Advance by `ticks` control ticks with a constant reference."""
        self.follow(constant(q, ticks), payload)

    def log(self) -> dict[str, Array]:
        """Return the recorded channels, and their ticks as `tick`."""
        return {"tick": self._recorder.ticks, **self._recorder.channels()}

    def at(self, tick: float) -> dict[str, Array]:
        """Return the recorded channels at a tick, linear between two rows, shape (n,) each."""
        return self._recorder.at(tick)

    def q_at(self, tick: float) -> Array:
        """Return the attained joint coordinates at a tick that is not forgotten [rad | m], shape (n,)."""
        return self._recorder.q_at(tick)

    def forget(self, tick: int) -> None:
        """Allow discarding positions of the arm before a tick."""
        self._recorder.forget(tick)

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
