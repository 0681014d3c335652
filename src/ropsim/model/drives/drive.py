"""The drive of a joint as a chain of blocks: amplifier, motor, transmission, friction."""

from enum import StrEnum
from math import copysign, inf

from ropsim.core import frozen_dataclass
from ropsim.model.drives.ball_screw import BallScrew
from ropsim.model.drives.current_loop import CurrentLoopMotor, LaggingMotor
from ropsim.model.drives.friction import Friction, FrictionLaw
from ropsim.model.drives.hydraulics import HydraulicCylinder, HydraulicMotor, HydraulicVane
from ropsim.model.drives.link_elasticity import LinkElasticity
from ropsim.model.drives.linkage import Linkage
from ropsim.model.drives.supply import HydraulicSupply
from ropsim.model.drives.thermal_motor import GuardedAmplifier, ThermalDcMotor


class InputKind(StrEnum):
    """Output of a joint controller, and input of the amplifier of a drive."""

    VOLTAGE = "voltage"
    EFFORT = "effort"
    CURRENT = "valve current"


@frozen_dataclass
class VoltageAmplifier:
    """A voltage amplifier.

    Attributes:
        max_voltage: [V]; the output is clipped to ±max_voltage.
        max_current: [A]; the drive reports when the current exceeds it.
    """

    max_voltage: float
    max_current: float


@frozen_dataclass
class CurrentLimitedAmplifier:
    """A voltage amplifier that lowers its voltage where the current of its motor would grow beyond a limit.

    Attributes:
        max_voltage: [V]; the output is clipped to ±max_voltage.
        max_current: [A]; the current stays within ±max_current as far as the voltage suffices for that.
    """

    max_voltage: float
    max_current: float


@frozen_dataclass
class EffortAmplifier:
    """An amplifier that commands the torque or force of its motor directly.

    Attributes:
        max_effort: [N·m | N] at the motor; the output is clipped to ±max_effort.
    """

    max_effort: float = inf


@frozen_dataclass
class ValveAmplifier:
    """An amplifier that drives the current through the coil of a servo valve.

    Attributes:
        max_input: [A]; the output is clipped to ±max_input.
    """

    max_input: float


@frozen_dataclass
class DcMotor:
    """A permanent-magnet DC motor: L·di/dt = u - R·i - Ke·ω, torque = Kt·i.

    Attributes:
        torque_constant: Kt [N·m/A].
        back_emf_constant: Ke [V·s/rad].
        resistance: R [ohm].
        inductance: L [H].
        rotor_inertia: J [kg·m²], rotor and gear input.
    """

    torque_constant: float
    back_emf_constant: float
    resistance: float
    inductance: float
    rotor_inertia: float


@frozen_dataclass
class IdealMotor:
    """A source of torque or force: the command acts at once.

    Attributes:
        rotor_inertia: J [kg·m²] or, of a linear motor, [kg]; rotor and gear input.
    """

    rotor_inertia: float = 0.0


@frozen_dataclass
class Gear:
    """A rigid gear without play.

    Attributes:
        ratio: G = motor angle / joint coordinate, signed.
    """

    ratio: float = 1.0


@frozen_dataclass
class ElasticGear:
    """A gear that twists under load: effort at the joint = k·(θ/G - q) + d·(ω/G - q̇), θ the motor angle.

    Attributes:
        ratio: G = motor angle / joint coordinate, signed.
        stiffness: k at the joint [N·m/rad | N/m].
        damping: d at the joint [N·m·s/rad | N·s/m].
    """

    ratio: float
    stiffness: float
    damping: float = 0.0


@frozen_dataclass
class BacklashGear:
    """A gear that twists under load and has play between its flanks.

    Where θ/G - q is within ±b/2, motor and joint do not feel each other. Beyond, by p, the effort at the
    joint is k·p + d·(ω/G - q̇), θ the motor angle; the damping is bounded by ±k·p, so that flanks do not pull
    (M. Nordin, P.-O. Gutman: Controlling mechanical systems with backlash - a survey, Automatica 38 (2002),
    1633-1649).

    Attributes:
        ratio: G = motor angle / joint coordinate, signed.
        stiffness: k at the joint [N·m/rad | N/m].
        damping: d at the joint [N·m·s/rad | N·s/m].
        backlash: b, the whole play at the joint while the motor is held [rad | m].
    """

    ratio: float
    stiffness: float
    damping: float
    backlash: float


Elastic = ElasticGear | BacklashGear
Amplifier = VoltageAmplifier | CurrentLimitedAmplifier | GuardedAmplifier | EffortAmplifier | ValveAmplifier
Electric = DcMotor | ThermalDcMotor | CurrentLoopMotor | LaggingMotor | IdealMotor
Motor = Electric | HydraulicMotor | HydraulicCylinder | HydraulicVane
Transmission = Gear | BallScrew | Elastic | Linkage


@frozen_dataclass
class Drive:
    """Everything between the control signal and the joint, block by block.

    Attributes:
        amplifier: takes the output of the joint controller.
        motor: turns that into torque at its shaft.
        transmission: brings the torque to the joint.
        friction: of motor and gear, on the motor side.
        supply: of oil with an accumulator, which drives with equal records share; None for one of constant
            pressure, and of electric motors.
        link: elasticity of the link that it moves; None for a rigid one.
    """

    amplifier: Amplifier
    motor: Motor
    transmission: Transmission
    friction: FrictionLaw = Friction()
    supply: HydraulicSupply | None = None
    link: LinkElasticity | None = None

    def ratio_at(self, q: float) -> float:
        """Return G = speed of the motor over that of the joint, signed, where the joint is at q [rad | m]."""
        gear = self.transmission
        return gear.ratio_at(q) if isinstance(gear, Linkage) else gear.ratio

    def shaft_at(self, q: float) -> float:
        """Return the angle of the shaft, or by how much the rod is out, where the joint is at q [rad | m]."""
        gear = self.transmission
        return gear.out_at(q) if isinstance(gear, Linkage) else gear.ratio * q

    @property
    def has_idle_hub(self) -> bool:
        """Return whether the hub before an elastic link has no inertia: none of its own, none of a rotor."""
        if self.link is None or self.link.hub_inertia:
            return False
        return isinstance(self.transmission, Elastic) or not self.turning_inertia

    @property
    def turning_inertia(self) -> float:
        """Return the inertia of what turns with the motor, that of a screw included [kg·m² | kg]."""
        gear = self.transmission
        screw = gear.screw_inertia if isinstance(gear, BallScrew) else 0.0
        return self.motor.rotor_inertia + screw

    @property
    def sense(self) -> float:
        """Return the sign of G, 1.0 or -1.0, which is the same in all of the range of the joint."""
        gear = self.transmission
        return gear.sense if isinstance(gear, Linkage) else copysign(1.0, gear.ratio)


def ideal_drive(max_effort: float = inf) -> Drive:
    """Return the drive that needs no data: the command of the joint controller acts on the joint at once.

    Args:
        max_effort: largest torque or force [N·m | N].
    """
    return Drive(EffortAmplifier(max_effort), IdealMotor(), Gear())
