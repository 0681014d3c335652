"""The servo-driven arm as a plant: true drives and dynamics, in compiled slices."""

from ropsim.flow import JointReference
from ropsim.model import Cell, Payload
from ropsim.simulation.plant import constant
from ropsim.simulation.recorder import Recorder
from ropsim.simulation.run_options import RunOptions
from ropsim.simulation.servo import Servo
from ropsim.spatial import Array


class ServoPlant:
    """Follows references as drives, gears, friction and inertia allow.

    Args:
        cell: with the arm and its controller.
        q: joint coordinates at time 0 [rad | m], shape (n,).
        payload: body at the mechanical interface at time 0.
        options: the joint controller and how densely to record.
    """

    def __init__(self, cell: Cell, q: Array, payload: Payload, options: RunOptions) -> None:
        self._servo = Servo.build(cell.robot, cell.controller, options.law)
        self._state = self._servo.initial_state(q, payload)
        record_ticks = options.record_ticks(self._servo.control_hz)
        self._recorder = Recorder(cell.robot, self._state, record_ticks, options.most_rows)

    @property
    def q(self) -> Array:
        """Return the attained joint coordinates [rad | m], shape (n,)."""
        return self._state.q

    @property
    def record_ticks(self) -> int:
        """Return the control ticks between two recorded rows."""
        return self._recorder.decimation

    def follow(self, reference: JointReference, payload: Payload) -> None:
        """Advance by one control tick per row of `reference`, in one compiled call."""
        self._state = self._servo.run(self._state, reference, payload, self._recorder)

    def hold(self, q: Array, ticks: int, payload: Payload) -> None:
        """Advance by `ticks` control ticks with a constant reference."""
        self.follow(constant(q, ticks), payload)

    def log(self) -> dict[str, Array]:
        """Return the recorded channels, and their ticks as `tick`."""
        return {"tick": self._recorder.ticks, **self._recorder.channels()}

    def at(self, tick: float) -> dict[str, Array]:
        """Return the recorded channels at a tick, linear between two rows, shape (n,) each."""
        return self._recorder.at(tick)
