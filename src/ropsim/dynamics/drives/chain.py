"""The chain of a drive: its blocks in series, as one traced formula."""

from ropsim.codegen import Scalar
from ropsim.core import frozen_dataclass
from ropsim.dynamics.drives.block import (
    AmplifierBlock,
    Carried,
    Column,
    MotorBlock,
    Movement,
    Numbers,
    Shaft,
    TransmissionBlock,
    Turning,
)
from ropsim.dynamics.drives.friction import FRICTION_NUMBERS, trace_friction
from ropsim.dynamics.drives.table import AMPLIFIERS, MOTORS, TRANSMISSIONS
from ropsim.model import Drive


@frozen_dataclass
class DriveChain:
    """The blocks of a drive, without its numbers.

    Attributes:
        amplifier: takes the command of the joint controller.
        motor: takes the output of the amplifier.
        transmission: brings the torque of the motor to the joint.
    """

    amplifier: AmplifierBlock
    motor: MotorBlock
    transmission: TransmissionBlock

    @property
    def states(self) -> tuple[Column, ...]:
        """Return the states: of the motor, then of the transmission."""
        return (*self.motor.states, *self.transmission.states)

    @property
    def size(self) -> int:
        """Return how many numbers a drive of these blocks has."""
        return sum(len(names) for names in self._names)

    def numbers(self, drive: Drive) -> tuple[float, ...]:
        """Return the numbers of a drive of these blocks, in the order in which the formulas take them."""
        records = (drive.amplifier, drive.motor, drive.transmission, drive.friction)
        return tuple(
            float(getattr(record, name))
            for record, names in zip(records, self._names, strict=True)
            for name in names
        )

    def amplified(self, p: Numbers, command: Scalar) -> Scalar:
        """Return the output of the amplifier, in the sense of the motor.

        Args:
            p: numbers of the drive.
            command: of the joint controller; positive drives the joint forward, for any sign of G.
        """
        amplifier, _, gear, _ = self._parts(p)
        return self.amplifier.trace(amplifier, command) * (gear[0] / abs(gear[0]))

    def trace(self, p: Numbers, q: Scalar, qd: Scalar, states: Numbers, u: Scalar) -> Carried:
        """Return the effect of the drive on its joint.

        Args:
            p: numbers of the drive.
            q: joint coordinate.
            qd: joint speed.
            states: of motor and transmission.
            u: output of the amplifier, unless it reads its motor.
        """
        _, motor, gear, friction = self._parts(p)
        own = len(self.motor.states)

        def turning(shaft: Movement) -> Turning:
            given = self._given(p, u, shaft.speed)
            return Turning(given, self.motor.trace(motor, states[:own], given, shaft))

        def taken(ratio: Scalar, speed: Scalar) -> Scalar:
            return trace_friction(friction, ratio, speed)

        shaft = Shaft(q, qd, turning, self.motor.inertia(motor), taken)
        return self.transmission.trace(gear, states[own:], shaft)

    def _given(self, p: Numbers, u: Scalar, speed: Scalar) -> Scalar:
        """Return the input of the motor at a speed of its shaft."""
        within, keeping = self.amplifier.within, self.motor.keeping
        if within is None or keeping is None:
            return u
        amplifier, motor, _, _ = self._parts(p)
        return within(amplifier, u, lambda value: keeping(motor, value, speed))

    @property
    def _names(self) -> tuple[tuple[str, ...], ...]:
        blocks = (self.amplifier, self.motor, self.transmission)
        return (*(block.numbers for block in blocks), FRICTION_NUMBERS)

    def _parts(self, p: Numbers) -> list[Numbers]:
        parts, first = [], 0
        for names in self._names:
            parts.append(p[first : first + len(names)])
            first += len(names)
        return parts


def chain_of(drive: Drive) -> DriveChain:
    """Return the blocks that a drive is made of."""
    return DriveChain(
        AMPLIFIERS[type(drive.amplifier)],
        MOTORS[type(drive.motor)],
        TRANSMISSIONS[type(drive.transmission)],
    )
