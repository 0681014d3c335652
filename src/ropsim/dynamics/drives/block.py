"""Description of a block of a drive: numbers, states, formulas, log columns, limits.

A block is static: it holds functions, not numbers. The numbers of one drive are attributes of its record in
`model`; formulas read them as traced scalars, in the order in which the block names them.
"""

from collections.abc import Callable, Mapping, Sequence
from enum import Enum
from math import inf
from typing import Any, NamedTuple

from ropsim.codegen import Scalar
from ropsim.core import frozen_dataclass
from ropsim.model import InputKind
from ropsim.spatial import Array

Numbers = Sequence[Scalar]
Recorded = Mapping[str, Array]
"""Recorded columns of an axis, by quantity: coordinate `q`, speed `qd`, and the columns of its drive, shape
(rows,) each."""


class Column(NamedTuple):
    """A quantity of a drive that is recorded.

    Attributes:
        name: of the channel.
        unit: SI unit; `{q}` stands for that of the joint coordinate, `{tau}` for that of its effort.
        text: description.
        least: below this the quantity cannot be; a model that has it there says too much.
    """

    name: str
    unit: str
    text: str
    least: float = -inf


class LimitSort(Enum):
    """How a limit is broken: by the largest value, or by a value that stays at it."""

    PEAK = "peak"
    LASTING = "lasting"


class Limit(NamedTuple):
    """A limit that a run is held to.

    Attributes:
        column: name of the recorded quantity that it is about, such as `current`.
        sort: condition that violates it.
        number: attribute of the amplifier that holds the largest magnitude.
        near: share of that magnitude from which on a lasting value counts as one at its limit.
    """

    column: str
    sort: LimitSort
    number: str
    near: float = 1.0 - 1e-9


class Torque(NamedTuple):
    """Effect of a motor: torque at its shaft and the rates of its states."""

    torque: Scalar
    rates: tuple[Scalar, ...]


class Movement(NamedTuple):
    """How the shaft of a motor stands and moves.

    Attributes:
        place: of the shaft [rad], of the rod of a cylinder by how much it is out [m].
        speed: of either [rad/s | m/s].
    """

    place: Scalar
    speed: Scalar


class Turning(NamedTuple):
    """A motor at its amplifier: its present input, and its effect."""

    given: Scalar
    does: Torque


class Steady(NamedTuple):
    """A block in a steady state: its states and the required output of the block before it."""

    states: tuple[float, ...]
    needs: float


@frozen_dataclass
class AmplifierBlock:
    """An amplifier.

    Attributes:
        kind: kind of its input and output.
        numbers: attributes of its record that the formulas take, the largest magnitude of its output first.
        positive: attributes that must be positive.
        output: how its output is recorded.
        trace: `(numbers, command)` to the output, which holds until the next control tick.
        limits: that its record holds.
        within: `(numbers, output, keeping)` to the input of the motor at any instant of the tick, where
            `keeping(value)` is the input that would keep the first state of the motor at a value; None if the
            output does not depend on the motor.
    """

    kind: InputKind
    numbers: tuple[str, ...]
    positive: tuple[str, ...]
    output: Column
    trace: Callable[[Numbers, Scalar], Scalar]
    limits: tuple[Limit, ...]
    within: Callable[[Numbers, Scalar, Callable[[Scalar], Scalar]], Scalar] | None = None


@frozen_dataclass
class MotorBlock:
    """A motor.

    Attributes:
        takes: required output of its amplifier.
        numbers: attributes of its record that the formulas take.
        positive: numbers that must be positive.
        states: its states.
        trace: `(numbers, states, input, movement of the shaft)` to torque and rates.
        inertia: `numbers` to the rotor inertia.
        steady: `(record, torque, shaft speed)` to the states, and the input, that go on giving the torque.
        pole: `record` to the rate at which its torque follows its input [rad/s].
        power: `(record, recorded columns, shaft speed)` to the power that it draws from its supply [W],
            negative where it gives back.
        keeping: `(numbers, value, shaft speed)` to the input that would keep its first state at a value; None
            for a motor without states, or one whose amplifier does not read it.
        most: `record` to the largest torque at standstill for any input; None if the amplifier alone limits
            it.
        taken: `(numbers, states)` to the flow that it takes from its supply of oil [m³/s]; None where it is
            at none.
    """

    takes: InputKind
    numbers: tuple[str, ...]
    positive: tuple[str, ...]
    states: tuple[Column, ...]
    trace: Callable[[Numbers, Numbers, Scalar, Movement], Torque]
    inertia: Callable[[Numbers], Scalar]
    steady: Callable[[Any, float, float], Steady]
    pole: Callable[[Any], float]
    power: Callable[[Any, Recorded, Array], Array]
    keeping: Callable[[Numbers, Scalar, Scalar], Scalar] | None = None
    most: Callable[[Any], float] | None = None
    taken: Callable[[Numbers, Numbers], Scalar] | None = None


class Rubbing(NamedTuple):
    """Effect of friction at the joint.

    Attributes:
        torque: torque or force that friction takes there, except for what grows with the load.
        share: what it takes besides, over the magnitude of the effort that the drive brings there; negative
            in motion back, None where friction does not depend on the load.
        rates: of its states.
    """

    torque: Scalar
    share: Scalar | None = None
    rates: tuple[Scalar, ...] = ()

    def under(self, effort: Scalar) -> Scalar:
        """Return all that friction takes under an effort of the drive."""
        return self.torque if self.share is None else self.torque + self.share * abs(effort)


class Shaft(NamedTuple):
    """The two sides of a transmission.

    Attributes:
        q: joint coordinate.
        qd: joint speed.
        motor: maps the movement of the shaft to the input and effect of the motor.
        inertia: of the rotor.
        friction: ratio G and speed seen at the joint, to the effect of friction there.
    """

    q: Scalar
    qd: Scalar
    motor: Callable[[Movement], Turning]
    inertia: Scalar
    friction: Callable[[Scalar, Scalar], Rubbing]


class Carried(NamedTuple):
    """Effect of a transmission on the joint.

    Attributes:
        effort: torque or force of the drive at the joint, before friction that acts there.
        friction: what friction takes at the joint, including the inertial force of the motor due to its
            changing ratio; None where it acts on the motor alone.
        inertia: reflected inertia at the joint in addition to its links; None if the motor moves
            independently.
        rates: of the states of the motor, then of the transmission, then of friction.
        given: input of the motor from its amplifier, in the sense of the motor.
    """

    effort: Scalar
    friction: Rubbing | None
    inertia: Scalar | None
    rates: tuple[Scalar, ...]
    given: Scalar


class Steepness(NamedTuple):
    """How steep friction is at rest, seen at the joint.

    Attributes:
        slope: of friction over the speed [N·m·s/rad | N·s/m].
        stiffness: of what holds the joint as on a spring while it sticks [N·m/rad | N/m].
    """

    slope: float
    stiffness: float = 0.0


@frozen_dataclass
class FrictionBlock:
    """A law of friction.

    Attributes:
        numbers: attributes of its record that the formulas take.
        states: its states.
        trace: `(numbers, states, G, joint speed)` to its effect at the joint.
        sliding: `(numbers, G, joint speed)` to the same in steady motion, where no state is at hand.
        steady: `(record, motor speed)` to its states in steady motion.
        steepness: `(record, G, largest effort at the joint)` to how steep it is at rest; inf for an effort
            without limit.
    """

    numbers: tuple[str, ...]
    states: tuple[Column, ...]
    trace: Callable[[Numbers, Numbers, Scalar, Scalar], Rubbing]
    sliding: Callable[[Numbers, Scalar, Scalar], Rubbing]
    steady: Callable[[Any, float], tuple[float, ...]]
    steepness: Callable[[Any, float, float], Steepness]


@frozen_dataclass
class LinkBlock:
    """What lies between the drive of a joint and the link that it moves.

    Attributes:
        numbers: attributes of its record that the formula takes.
        positive: numbers that must be positive.
        states: coordinate and speed of the hub.
        trace: `(numbers, states, coordinate and speed of the joint, effect of the drive on the hub)` to its
            effect on the joint.
        hub: `(record, joint coordinate, effort)` to the coordinate of the hub at standstill.
    """

    numbers: tuple[str, ...]
    positive: tuple[str, ...]
    states: tuple[Column, ...]
    trace: Callable[[Numbers, Numbers, tuple[Scalar, Scalar], Carried], Carried]
    hub: Callable[[Any, float, float], float]


@frozen_dataclass
class TransmissionBlock:
    """A transmission; the first of its numbers has the sign of its ratio G.

    Attributes:
        numbers: attributes of its record that the formula takes.
        positive: numbers that must be positive.
        states: its states.
        trace: `(numbers, states, shaft)` to its effect on the joint.
        rest: `(record, joint coordinate, effort)` to its states, and the motor torque, at standstill.
        speed: `(record, recorded columns)` to the speed of the shaft of the motor [rad/s | m/s].
    """

    numbers: tuple[str, ...]
    positive: tuple[str, ...]
    states: tuple[Column, ...]
    trace: Callable[[Numbers, Numbers, Shaft], Carried]
    rest: Callable[[Any, float, float], Steady]
    speed: Callable[[Any, Recorded], Array]
