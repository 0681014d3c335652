"""Responses of drives and arm, kept by the state in which they began, the reference and the payload.

A servo-driven arm forgets: some seconds behind an edit its state is that of the run before, to the bit, and
from there on nothing need be simulated that is known.
"""

from collections.abc import Callable
from typing import TypeAlias

from ropsim.core import RopsimError
from ropsim.flow import JointReference
from ropsim.model import Payload
from ropsim.simulation.records.kept_results import KeptResults
from ropsim.simulation.servo.recorder import Recorder
from ropsim.simulation.servo.servo import Servo
from ropsim.simulation.servo.state import ServoState
from ropsim.spatial import Array, fingerprint, record

Driving: TypeAlias = Callable[[str, Servo, ServoState, JointReference, Payload, Recorder, Array], ServoState]
"""Lets the servo of the station of a name follow a reference; see `Servo.run`."""

MOST_BYTES = 200_000_000
"""Number of rows and references that are kept: 7 minutes of motion of six axes at a control rate of 1 kHz."""


def driven_anew(
    station: str,
    servo: Servo,
    state: ServoState,
    reference: JointReference,
    payload: Payload,
    recorder: Recorder,
    aux: Array,
) -> ServoState:
    """Follow a reference without using kept responses."""
    del station
    before = recorder.tally.table.copy()
    try:
        after = servo.run(state, reference, payload, recorder, aux)
    except RopsimError:
        recorder.rewind(state.tick, before)
        raise
    recorder.take()
    return after


@record
class _Driven:
    """A slice.

    Attributes:
        reference: that was followed, mostly rows of a plan that is kept as well.
        aux: signals that the law read, shape (ticks, a).
        rows: of the log, at every control tick, shape (ticks, w).
        tally: judged quantities, ticks counted from where it began, shape (4, w).
        values: the state vector at its end.
    """

    reference: JointReference
    aux: Array
    rows: Array
    tally: Array
    values: Array


class KeptDrives:
    """Slices of the stations of a cell, each under the joint controller of its model.

    Args:
        most: room for rows and references [bytes].

    Attributes:
        anew: control ticks that were simulated, since the run began.
    """

    def __init__(self, most: int = MOST_BYTES) -> None:
        self.anew = 0
        self._kept: KeptResults[_Driven] = KeptResults(most)

    @property
    def used(self) -> int:
        """Return how much room is taken, about [bytes]."""
        return self._kept.used

    def begin(self) -> None:
        """Take notice that another run begins."""
        self._kept.begin()
        self.anew = 0

    def drive(
        self,
        station: str,
        servo: Servo,
        state: ServoState,
        reference: JointReference,
        payload: Payload,
        recorder: Recorder,
        aux: Array,
    ) -> ServoState:
        """Follow a reference, or enter its kept response into the recording.

        Args:
            station: name of the station in the cell.
            servo: of it, under the joint controller of its model.
            state: where to start.
            reference: one row per control tick.
            payload: body at the mechanical interface.
            recorder: gets the rows of these ticks.
            aux: values of the signals that the law reads, shape (ticks, a).
        """
        when = state.tick if servo.sensors.is_timed else 0
        key = station, state.values.tobytes(), fingerprint(payload), (reference.ticks, when)
        driven = self._kept.get(key)
        if driven is None or not (_are_same(driven.reference, reference) and _same(driven.aux, aux)):
            self.anew += reference.ticks
            log = recorder.slice_log()
            after = servo.run(state, reference, payload, log, aux)
            driven = _Driven(reference, aux, log.rows, log.tally.since(state.tick), after.values)
            self._kept.put(key, driven, log.rows.nbytes)
        recorder.enter(state.tick, driven.rows, driven.tally)
        return ServoState(state.tick + reference.ticks, driven.values, state.layout)


def _are_same(one: JointReference, other: JointReference) -> bool:
    """Return whether two references have the same bits."""
    return _same(one.q, other.q) and _same(one.qd, other.qd) and _same(one.qdd, other.qdd)


def _same(one: Array, other: Array) -> bool:
    """Return whether two arrays have the same bits; arrays at the same address are equal."""
    if one.shape != other.shape:
        return False
    place, same = one.__array_interface__, other.__array_interface__
    if place["data"][0] == same["data"][0] and one.strides == other.strides:
        return True
    return one.tobytes() == other.tobytes()
