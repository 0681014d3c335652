"""The state of a servo-driven arm: one flat vector with a named layout."""

from ropsim.controller import LawTraits
from ropsim.core import frozen_dataclass
from ropsim.dynamics import LOOP_NUMBERS, ArmStructure, LoopState
from ropsim.simulation.records.fields import Field, fields
from ropsim.spatial import Array, record

MOTOR_SPEED = "motor_speed"
"""Name of the state of drives with elastic gears: the speed of the motor over the gear ratio."""

HUB_COORDINATE, HUB_SPEED = "hub_coordinate", "hub_speed"
"""Names of the states of drives before elastic links, whose motors know where their hubs are."""


@frozen_dataclass
class StateLayout:
    """Where things stand in the state vector.

    In order: q, qd, states of the drives, pressures of supplies with accumulators, and of closed chains the
    coordinates that they determine, their speeds, what is left between their frames, and what tells dead
    centres; outputs of the amplifiers, efforts at the axes from outside where something can exert them, the
    reference in force, outputs of the law that do not act yet, states of the law, those of the sensors. All
    before the outputs of the amplifiers is integrated; the others change at control ticks.

    Attributes:
        n: number of joints.
        drives: states of the drives, by name.
        integrated: how many numbers the equations of motion have.
        delay: rows of n outputs on their way from the law to the amplifiers, the oldest first.
        law_rows: rows of n numbers that the law remembers.
        sensor_rows: rows of n numbers that sensors hold, or that are on their way from them.
        passive: number of coordinates that closed chains determine.
        outside_rows: 1 where efforts from outside act on the axes, else 0.
        supplied: drives at each supply of oil with an accumulator, from 0.
    """

    n: int
    drives: tuple[Field, ...]
    integrated: int
    delay: int
    law_rows: int
    sensor_rows: int = 0
    passive: int = 0
    outside_rows: int = 0
    supplied: tuple[tuple[int, ...], ...] = ()

    @classmethod
    def of(
        cls, structure: ArmStructure, traits: LawTraits, sensor_rows: int = 0, outside_rows: int = 0
    ) -> "StateLayout":
        """Return the layout of an arm of this structure, with drives, under a law whose sensors keep rows."""
        chains, p = structure.drives, structure.passive
        n = len(chains)
        names = tuple(tuple(state.name for state in chain.states) for chain in chains)
        drives = fields(names, 2 * n)
        integrated = (drives[-1].place.stop if drives else 2 * n) + len(structure.supplies)
        integrated += 2 * p + LOOP_NUMBERS if p else 0
        rows = len(traits.state_names)
        return cls(
            n, drives, integrated, traits.delay, rows, sensor_rows, p, outside_rows, structure.supplies
        )

    @property
    def size(self) -> int:
        """Return the length of the vector."""
        rows = 4 + self.outside_rows + self.delay + self.law_rows + self.sensor_rows
        return self.integrated + rows * self.n

    @property
    def q(self) -> slice:
        """Return the place of the joint coordinates [rad | m]."""
        return slice(0, self.n)

    @property
    def qd(self) -> slice:
        """Return the place of the joint speeds [rad/s | m/s]."""
        return slice(self.n, 2 * self.n)

    @property
    def driven(self) -> int:
        """Return how many numbers belong to axes and drives: those of closed chains follow behind them."""
        return self.integrated - (2 * self.passive + LOOP_NUMBERS if self.passive else 0)

    @property
    def supplies(self) -> slice:
        """Return the place of the pressures of the supplies with accumulators [Pa]."""
        return slice(self.driven - len(self.supplied), self.driven)

    @property
    def loops(self) -> LoopState:
        """Return the places of all coordinates and speeds, in an arm with closed chains."""
        p, first, gap = self.passive, self.driven, self.integrated - LOOP_NUMBERS
        drives = range(2 * self.n, first)
        return LoopState(self.n, range(first, first + p), range(first + p, gap), drives, gap)

    @property
    def output(self) -> slice:
        """Return the place of the output of the amplifiers, in the sense of the motors."""
        return slice(self.integrated, self.integrated + self.n)

    @property
    def outside(self) -> slice:
        """Return the place of the efforts at the axes from outside; empty where nothing exerts them."""
        return slice(self.output.stop, self.output.stop + self.outside_rows * self.n)

    @property
    def reference(self) -> slice:
        """Return the place of the reference in force: coordinates, speeds and accelerations."""
        first = self.outside.stop
        return slice(first, first + 3 * self.n)

    @property
    def pending(self) -> slice:
        """Return the place of the outputs of the law that do not act yet, by rows."""
        first = self.reference.stop
        return slice(first, first + self.delay * self.n)

    @property
    def law(self) -> slice:
        """Return the place of the states of the law, by rows."""
        first = self.pending.stop
        return slice(first, first + self.law_rows * self.n)

    def in_force(self, values: Array) -> Array:
        """Return the reference in force, shape (3, n); a view of a state vector."""
        return values[self.reference].reshape(3, self.n)

    def waiting(self, values: Array) -> Array:
        """Return the outputs of the law that do not act yet, shape (delay, n); a view of a state vector."""
        return values[self.pending].reshape(self.delay, self.n)

    def memory(self, values: Array) -> Array:
        """Return the states of the law, shape (law_rows, n); a view of a state vector."""
        return values[self.law].reshape(self.law_rows, self.n)

    def kept(self, values: Array) -> Array:
        """Return what sensors hold, shape (sensor_rows, n); a view of a state vector."""
        return values[self.law.stop :].reshape(self.sensor_rows, self.n)

    def remembered(self, values: Array) -> Array:
        """Return the states of the law and below them what sensors hold; a view of a state vector."""
        return values[self.pending.stop :].reshape(-1, self.n)

    @property
    def measured_speeds(self) -> tuple[int, ...]:
        """Return the places of the speeds measured for a law: of the motor if it is a separate state."""
        motors = self._places(HUB_SPEED) | self._places(MOTOR_SPEED)
        return tuple(motors.get(axis, self.n + axis) for axis in range(self.n))

    @property
    def measured_coordinates(self) -> tuple[int, ...]:
        """Return the places of the coordinates measured for a law: of the hub before an elastic link."""
        hubs = self._places(HUB_COORDINATE)
        return tuple(hubs.get(axis, axis) for axis in range(self.n))

    def _places(self, name: str) -> dict[int, int]:
        """Return where a state stands, for each drive that has it."""
        fields = (field for field in self.drives if field.name == name)
        return {axis: field.first + k for field in fields for k, axis in enumerate(field.axes)}

    def sensed(self, names: tuple[str, ...]) -> list[tuple[int | None, ...]]:
        """Return for each name where that state of each drive stands; None for a drive without it."""
        places = {
            field.name: dict(zip(field.axes, range(field.first, field.place.stop), strict=True))
            for field in self.drives
        }
        return [tuple(places.get(name, {}).get(axis) for axis in range(self.n)) for name in names]

    def drive(self, axis: int) -> tuple[int, ...]:
        """Return the places of the states of one drive, in the order of its chain."""
        return tuple(field.first + field.axes.index(axis) for field in self.drives if axis in field.axes)


@record
class ServoState:
    """Everything that the future of a servo-driven arm depends on, besides a law written in Python.

    Attributes:
        tick: control ticks since time 0.
        values: the state vector, shape (layout.size,), read-only.
        layout: its layout.
    """

    tick: int
    values: Array
    layout: StateLayout

    def __post_init__(self) -> None:
        self.values.flags.writeable = False

    @property
    def q(self) -> Array:
        """Return the joint coordinates [rad | m], shape (n,)."""
        return self.values[self.layout.q]

    @property
    def qd(self) -> Array:
        """Return the joint speeds [rad/s | m/s], shape (n,)."""
        return self.values[self.layout.qd]

    @property
    def sensed(self) -> Array:
        """Return coordinates and speeds as a law is given them: those of motors, shape (2, n)."""
        layout = self.layout
        return self.values[[layout.measured_coordinates, layout.measured_speeds]]

    @property
    def output(self) -> Array:
        """Return the output of the amplifiers over the last tick, in the sense of the motors, shape (n,)."""
        return self.values[self.layout.output]

    def pressed(self, efforts: Array) -> "ServoState":
        """Return the state with other efforts from outside over the next ticks [N·m | N], shape (n,)."""
        values = self.values.copy()
        values[self.layout.outside] = efforts
        return ServoState(self.tick, values, self.layout)

    @property
    def reference(self) -> Array:
        """Return the reference of this tick, shape (3, n).

        Its rows are coordinates [rad | m], speeds and accelerations; the law receives it at the beginning of
        the next tick, together with the measurement there.
        """
        return self.layout.in_force(self.values)

    @property
    def law(self) -> Array:
        """Return the states of the law, shape (rows, n)."""
        return self.layout.memory(self.values)

    def drive(self, name: str) -> Array:
        """Return a state of the drives that have it, such as `current` [A], in the order of the joints.

        Raises:
            KeyError: no drive has this state.
        """
        for field in self.layout.drives:
            if field.name == name:
                return self.values[field.place]
        raise KeyError(name)
