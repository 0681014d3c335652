"""Motors in current loops: with what is known of the loop, or with its lag alone."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class CurrentLoopMotor:
    """A DC motor, or a brushless one in the axes of its rotor, whose current is controlled by its torque.

    L·di/dt = u - R·i - Ke·ω, torque = Kt·i. The loop wants i_r, the torque over Kt within ±i_max, and has u =
    kp·(i_r - i) + v + Ke·ω within ±u_max, v' = ki·(i_r - i + what u was clipped by/kp), kp = ω_c·L and ki =
    ω_c·R: so i follows i_r with the time constant 1/ω_c as long as the voltage suffices (L. Harnefors, H.-P.
    Nee: Model-based current control of AC machines using the internal model control method, IEEE Trans.
    Industry Applications 34 (1998), 133-141). Of a linear motor torques are forces, ω is its speed.

    Attributes:
        torque_constant: Kt [N·m/A].
        back_emf_constant: Ke [V·s/rad].
        resistance: R [ohm].
        inductance: L [H].
        rotor_inertia: J [kg·m²], rotor and gear input.
        max_voltage: u_max [V].
        max_current: i_max [A].
        bandwidth: ω_c of the loop [rad/s].
    """

    torque_constant: float
    back_emf_constant: float
    resistance: float
    inductance: float
    rotor_inertia: float
    max_voltage: float
    max_current: float
    bandwidth: float


@frozen_dataclass
class LaggingMotor:
    """A source of torque or force that follows its command: dτ/dt = ω_c·(command - τ).

    It is a motor in a current loop of which nothing else is known, with a voltage that always suffices.

    Attributes:
        bandwidth: ω_c [rad/s].
        rotor_inertia: J [kg·m²] or, of a linear motor, [kg]; rotor and gear input.
    """

    bandwidth: float
    rotor_inertia: float = 0.0
