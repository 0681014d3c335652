"""What a block of a drive tells about itself: numbers, states, formulas, log columns, limits.

A block is static: it holds functions, not numbers. The numbers of one drive are attributes of its record in
`model`; formulas read them as traced scalars, in the order in which the block names them.
"""

from collections.abc import Callable, Sequence
from enum import Enum
from math import inf
from typing import Any, NamedTuple

from ropsim.codegen import Scalar
from ropsim.core import frozen_dataclass
from ropsim.model import InputKind

Numbers = Sequence[Scalar]


class Column(NamedTuple):
    """A quantity of a drive that is recorded.

    Attributes:
        name: of the channel.
        unit: SI unit; `{q}` stands for that of the joint coordinate, `{tau}` for that of its effort.
        text: what it is.
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
        sort: what breaks it.
        number: attribute of the amplifier that holds the largest magnitude.
        near: share of that magnitude from which on a lasting value counts as one at its limit.
    """

    column: str
    sort: LimitSort
    number: str
    near: float = 1.0 - 1e-9


class Torque(NamedTuple):
    """What a motor does: torque at its shaft and the rates of its states."""

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
    """A motor at its amplifier: what it is given now, and what it does with that."""

    given: Scalar
    does: Torque


class Steady(NamedTuple):
    """A block in a steady state: its states and what it needs from the block before it."""

    states: tuple[float, ...]
    needs: float


@frozen_dataclass
class AmplifierBlock:
    """An amplifier.

    Attributes:
        kind: of what it takes and puts out.
        numbers: attributes of its record that the formulas take, the largest magnitude of its output first.
        positive: attributes that must be positive.
        output: how its output is recorded.
        trace: `(numbers, command)` to the output, which holds until the next control tick.
        limits: that its record holds.
        within: `(numbers, output, keeping)` to what the motor is given at any instant of the tick, where
            `keeping(value)` is what would keep the first state of the motor at a value; None where the output
            holds whatever the motor does.
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
        takes: what its amplifier has to put out.
        numbers: attributes of its record that the formulas take.
        positive: those of them that must be positive.
        states: what it remembers.
        trace: `(numbers, states, input, movement of the shaft)` to torque and rates.
        inertia: `numbers` to the rotor inertia.
        steady: `(record, torque, shaft speed)` to the states, and the input, that go on giving the torque.
        pole: `record` to the rate at which its torque follows its input [rad/s].
        keeping: `(numbers, value, shaft speed)` to the input that would keep its first state at a value; None
            for a motor without states, or one whose amplifier does not look at it.
        most: `record` to the largest torque that it can give at standstill, whatever it is given; None where
            its amplifier alone sets that.
    """

    takes: InputKind
    numbers: tuple[str, ...]
    positive: tuple[str, ...]
    states: tuple[Column, ...]
    trace: Callable[[Numbers, Numbers, Scalar, Movement], Torque]
    inertia: Callable[[Numbers], Scalar]
    steady: Callable[[Any, float, float], Steady]
    pole: Callable[[Any], float]
    keeping: Callable[[Numbers, Scalar, Scalar], Scalar] | None = None
    most: Callable[[Any], float] | None = None


class Shaft(NamedTuple):
    """What a transmission lies between.

    Attributes:
        q: joint coordinate.
        qd: joint speed.
        motor: movement of the shaft to what the motor is given and does.
        inertia: of the rotor.
        friction: ratio G and speed seen at the joint, to the torque at the joint that friction takes.
    """

    q: Scalar
    qd: Scalar
    motor: Callable[[Movement], Turning]
    inertia: Scalar
    friction: Callable[[Scalar, Scalar], Scalar]


class Carried(NamedTuple):
    """What a transmission brings to the joint.

    Attributes:
        effort: torque or force of the drive at the joint, before friction that acts there.
        friction: torque or force that friction takes at the joint, and with it what the mass of a motor takes
            as its ratio changes; None where it acts on the motor alone.
        inertia: that the joint feels in addition to its links; None where the motor moves by itself.
        rates: of the states of the motor, then of the transmission.
        given: what the motor is given by its amplifier, in its own sense.
    """

    effort: Scalar
    friction: Scalar | None
    inertia: Scalar | None
    rates: tuple[Scalar, ...]
    given: Scalar


@frozen_dataclass
class TransmissionBlock:
    """A transmission; the first of its numbers has the sign of its ratio G.

    Attributes:
        numbers: attributes of its record that the formula takes.
        positive: those of them that must be positive.
        states: what it remembers.
        trace: `(numbers, states, shaft)` to what it brings to the joint.
        rest: `(record, joint coordinate, effort)` to its states, and the motor torque, at standstill.
    """

    numbers: tuple[str, ...]
    positive: tuple[str, ...]
    states: tuple[Column, ...]
    trace: Callable[[Numbers, Numbers, Shaft], Carried]
    rest: Callable[[Any, float, float], Steady]
