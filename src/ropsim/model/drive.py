"""The drive of a joint: DC motor, gear, friction, amplifier."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
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

    viscous: float
    coulomb_positive: float
    coulomb_negative: float
    smoothing_speed: float = 5e-3


@dataclass(frozen=True, slots=True)
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


@dataclass(frozen=True, slots=True)
class Amplifier:
    """A voltage amplifier.

    Attributes:
        max_voltage: [V]; the output is clipped to ±max_voltage.
        max_current: [A]; the drive reports when the current exceeds it.
    """

    max_voltage: float
    max_current: float


@dataclass(frozen=True, slots=True)
class Drive:
    """Everything between the control signal and the joint.

    Attributes:
        ratio: G = motor angle / joint angle, signed.
        motor: the motor.
        friction: friction of motor and gear, on the motor side.
        amplifier: the amplifier.
    """

    ratio: float
    motor: DcMotor
    friction: Friction
    amplifier: Amplifier
