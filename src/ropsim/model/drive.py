"""The drive of a joint as a chain of blocks: amplifier, motor, transmission, friction."""

from enum import StrEnum
from math import inf

from ropsim.core import frozen_dataclass


class InputKind(StrEnum):
    """What a joint controller puts out, and what the amplifier of a drive takes."""

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
    """A source of torque or force: what is commanded acts at once.

    Attributes:
        rotor_inertia: J [kg·m²] or, of a linear motor, [kg]; rotor and gear input.
    """

    rotor_inertia: float = 0.0


@frozen_dataclass
class HydraulicMotor:
    """A hydraulic motor, or a cylinder with two equal areas, at a symmetric servo valve with four edges.

    The spool opens as x'' = ωn²·(i/i_r - x) - 2·ζ·ωn·x'. Each edge that is open lets Q = Q_r·|x|·√(2·Δp/Δp_r)
    through, the fall of pressure Δp_r of data sheets being that of both edges. Each chamber has
    p' = β/V·(Q - D·ω - leak), and the torque is D·(p_a - p_b) (H. E. Merritt, Hydraulic Control Systems,
    Wiley 1967). Of a cylinder ω is its speed [m/s], the torque a force [N], D its area [m²].

    Attributes:
        displacement: D [m³/rad | m²].
        chamber_volume: V of each chamber with its line, at mid-stroke [m³].
        leakage: from chamber to chamber [m³/(s·Pa)].
        rotor_inertia: J [kg·m²], or the moving mass [kg].
        supply_pressure: [Pa].
        return_pressure: [Pa].
        bulk_modulus: effective β of the oil [Pa].
        rated_flow: Q_r [m³/s], at the rated current and fall of pressure.
        rated_pressure_drop: Δp_r [Pa] over both edges.
        rated_input: i_r [A].
        natural_frequency: ωn of the spool [rad/s].
        damping_ratio: ζ of the spool.
        oil_density: [kg/m³], at which the flow is rated; no equation has it.
    """

    displacement: float
    chamber_volume: float
    leakage: float
    rotor_inertia: float
    supply_pressure: float
    return_pressure: float
    bulk_modulus: float
    rated_flow: float
    rated_pressure_drop: float
    rated_input: float
    natural_frequency: float
    damping_ratio: float
    oil_density: float = 870.0


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
class Friction:
    """Viscous and Coulomb friction on the motor side of the gear.

    The torque that the drive needs against friction, at the joint, is B·G²·q̇ + |G|·|Tc±|·tanh(q̇/v_s), with
    Tc+ for positive and Tc- for negative joint speed (Corke & Armstrong-Hélouvry 1994 give both).

    Attributes:
        viscous: B [N·m·s/rad] at the motor.
        coulomb_positive: Tc+ >= 0 [N·m] at the motor, for positive joint speed.
        coulomb_negative: Tc- <= 0 [N·m] at the motor, for negative joint speed.
        smoothing_speed: v_s [rad/s] at the joint.
    """

    viscous: float = 0.0
    coulomb_positive: float = 0.0
    coulomb_negative: float = 0.0
    smoothing_speed: float = 5e-3


Amplifier = VoltageAmplifier | CurrentLimitedAmplifier | EffortAmplifier | ValveAmplifier
Motor = DcMotor | IdealMotor | HydraulicMotor
Transmission = Gear | ElasticGear


@frozen_dataclass
class Drive:
    """Everything between the control signal and the joint, block by block.

    Attributes:
        amplifier: takes what the joint controller puts out.
        motor: turns that into torque at its shaft.
        transmission: brings the torque to the joint.
        friction: of motor and gear, on the motor side.
    """

    amplifier: Amplifier
    motor: Motor
    transmission: Transmission
    friction: Friction = Friction()

    @property
    def ratio(self) -> float:
        """Return G = motor angle / joint coordinate, signed."""
        return self.transmission.ratio


def ideal_drive(max_effort: float = inf) -> Drive:
    """Return the drive that needs no data: what the joint controller commands acts on the joint at once.

    Args:
        max_effort: largest torque or force [N·m | N].
    """
    return Drive(EffortAmplifier(max_effort), IdealMotor(), Gear())
