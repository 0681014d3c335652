"""The chain of a drive: its blocks in series, as one traced formula."""

from collections.abc import Callable

from ropsim.codegen import Scalar
from ropsim.core import frozen_dataclass
from ropsim.dynamics.drives.block import (
    AmplifierBlock,
    Carried,
    Column,
    FrictionBlock,
    LinkBlock,
    MotorBlock,
    Movement,
    Numbers,
    Recorded,
    Rubbing,
    Shaft,
    TransmissionBlock,
    Turning,
)
from ropsim.dynamics.drives.table import AMPLIFIERS, FRICTIONS, LINKS, MOTORS, TRANSMISSIONS
from ropsim.model import Drive
from ropsim.spatial import Array


@frozen_dataclass
class DriveChain:
    """The blocks of a drive, without its numbers.

    Attributes:
        amplifier: takes the command of the joint controller.
        motor: takes the output of the amplifier.
        transmission: brings the torque of the motor to the joint.
        friction: of motor and transmission.
        is_supplied: whether its valve is at a supply with an accumulator, whose pressure is a state.
        link: what lies between all that and the link; None for a rigid one.
    """

    amplifier: AmplifierBlock
    motor: MotorBlock
    transmission: TransmissionBlock
    friction: FrictionBlock
    is_supplied: bool = False
    link: LinkBlock | None = None

    @property
    def states(self) -> tuple[Column, ...]:
        """Return the states: of the motor, then of the transmission, then of friction, then of the hub."""
        own = (*self.motor.states, *self.transmission.states, *self.friction.states)
        return (*own, *self.link.states) if self.link else own

    @property
    def size(self) -> int:
        """Return how many numbers a drive of these blocks has."""
        return sum(len(names) for names in self._names)

    def numbers(self, drive: Drive) -> tuple[float, ...]:
        """Return the numbers of a drive of these blocks, in the order in which the formulas take them."""
        records = (drive.amplifier, drive.motor, drive.transmission, drive.friction, drive.link)
        return tuple(
            float(getattr(record, name))
            for record, names in zip(records, self._names, strict=False)
            for name in names
        )

    def amplified(self, p: Numbers, command: Scalar) -> Scalar:
        """Return the output of the amplifier, in the sense of the motor.

        Args:
            p: numbers of the drive.
            command: of the joint controller; positive drives the joint forward, for any sign of G.
        """
        amplifier, _, gear, *_ = self._parts(p)
        return self.amplifier.trace(amplifier, command) * (gear[0] / abs(gear[0]))

    def supplied(self, p: Numbers, pressure: Scalar) -> Numbers:
        """Return the numbers of the drive with another pressure of its supply of oil."""
        names = [name for block in self._names for name in block]
        place = names.index("supply_pressure")
        return [*p[:place], pressure, *p[place + 1 :]]

    def taken(self, p: Numbers, states: Numbers) -> Scalar | None:
        """Return the flow that the drive takes from its supply of oil [m³/s]; None where it is at none.

        Args:
            p: numbers of the drive.
            states: of motor, transmission and friction.
        """
        if self.motor.taken is None:
            return None
        return self.motor.taken(self._parts(p)[1], states[: len(self.motor.states)])

    def trace(self, p: Numbers, q: Scalar, qd: Scalar, states: Numbers, u: Scalar) -> Carried:
        """Return the effect of the drive on its joint.

        Args:
            p: numbers of the drive.
            q: joint coordinate.
            qd: joint speed.
            states: of motor, transmission and friction.
            u: output of the amplifier, unless it reads its motor.
        """
        friction = self._parts(p)[3]
        first = len(self.motor.states) + len(self.transmission.states)
        rubbed = states[first : first + len(self.friction.states)]

        def taken(ratio: Scalar, speed: Scalar) -> Rubbing:
            return self.friction.trace(friction, rubbed, ratio, speed)

        return self._carried(p, (q, qd), states, u, taken)

    def side(self, p: Numbers, q: Scalar, qd: Scalar) -> Carried:
        """Return the effect of the drive without torque in steady motion, no state of which is known.

        Args:
            p: numbers of the drive.
            q: joint coordinate.
            qd: joint speed.
        """
        zero, friction = q.tracer.constant(0.0), self._parts(p)[3]

        def taken(ratio: Scalar, speed: Scalar) -> Rubbing:
            return self.friction.sliding(friction, ratio, speed)

        return self._carried(p, (q, qd), [zero] * len(self.states), zero, taken)

    def power(self, drive: Drive, columns: Recorded) -> Array:
        """Return the power that a drive of these blocks draws [W], negative while it returns some, (rows,).

        It excludes amplifier, controller, brakes, and the electrical side of a valve.

        Args:
            drive: its records.
            columns: recorded quantities of its axis by name: `q`, `qd`, the states of the drive and the
                output of its amplifier.
        """
        if self.link:  # the drive moves the hub
            hub = zip(("q", "qd"), self.link.states, strict=True)
            columns = {**columns, **{name: columns[state.name] for name, state in hub}}
        speed = self.transmission.speed(drive.transmission, columns)
        return self.motor.power(drive.motor, columns, speed)

    def _carried(
        self,
        p: Numbers,
        joint: tuple[Scalar, Scalar],
        states: Numbers,
        u: Scalar,
        taken: Callable[[Scalar, Scalar], Rubbing],
    ) -> Carried:
        _, motor, gear, *_ = self._parts(p)
        own = len(self.motor.states)
        end = own + len(self.transmission.states)

        def turning(shaft: Movement) -> Turning:
            given = self._given(p, u, shaft.speed)
            return Turning(given, self.motor.trace(motor, states[:own], given, shaft))

        inertia = self.motor.inertia(motor)
        if self.link is None:
            return self.transmission.trace(gear, states[own:end], Shaft(*joint, turning, inertia, taken))
        hub = states[-len(self.link.states) :]
        driven = self.transmission.trace(
            gear, states[own:end], Shaft(hub[0], hub[1], turning, inertia, taken)
        )
        return self.link.trace(self._parts(p)[4], hub, joint, driven)

    def _given(self, p: Numbers, u: Scalar, speed: Scalar) -> Scalar:
        """Return the input of the motor at a speed of its shaft."""
        within, keeping = self.amplifier.within, self.motor.keeping
        if within is None or keeping is None:
            return u
        amplifier, motor, *_ = self._parts(p)
        return within(amplifier, u, lambda value: keeping(motor, value, speed))

    @property
    def _names(self) -> tuple[tuple[str, ...], ...]:
        blocks = (self.amplifier, self.motor, self.transmission, self.friction)
        links = (self.link.numbers,) if self.link else ()
        return (*(block.numbers for block in blocks), *links)

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
        FRICTIONS[type(drive.friction)],
        drive.supply is not None,
        LINKS[type(drive.link)] if drive.link else None,
    )
