"""Laws of friction of a drive, on the motor side of its gear.

All have a viscous and a Coulomb part, which are left of them in fast motion without load.
"""

from math import nextafter
from types import MappingProxyType
from typing import ClassVar

from ropsim.core import frozen_dataclass
from ropsim.model.drives.friction_parts import RESISTS, SMOOTHING, FrictionRanges
from ropsim.model.findings.number_range import FROM_ZERO, POSITIVE, UP_TO_ZERO, NumberRange

_STRIBECK = (POSITIVE, "give the speed of the motor over which its friction falls")
_PART = NumberRange(0.0, nextafter(1.0, 0.0), "0 or more and less than 1")


@frozen_dataclass
class Friction:
    """Viscous and Coulomb friction on the motor side of the gear.

    The torque that the drive needs against friction, at the joint, is B·G²·q̇ + |G|·|Tc±|·tanh(q̇/v_s), with
    Tc+ for positive and Tc- for negative joint speed (both in Corke & Armstrong-Hélouvry 1994).

    Attributes:
        viscous: B [N·m·s/rad] at the motor.
        coulomb_positive: Tc+ >= 0 [N·m] at the motor, for positive joint speed.
        coulomb_negative: Tc- <= 0 [N·m] at the motor, for negative joint speed.
        smoothing_speed: v_s [rad/s] at the joint.
    """

    RANGES: ClassVar[FrictionRanges] = MappingProxyType(
        {
            "viscous": RESISTS,
            "coulomb_positive": RESISTS,
            "coulomb_negative": (UP_TO_ZERO, RESISTS[1]),
            "smoothing_speed": SMOOTHING,
        }
    )

    viscous: float = 0.0
    coulomb_positive: float = 0.0
    coulomb_negative: float = 0.0
    smoothing_speed: float = 5e-3


@frozen_dataclass
class StribeckFriction:
    """Friction that is larger at low speeds: dry at rest, lubricated in motion.

    At the motor it is B·ω + (Tc + (Ts - Tc)·exp(-|ω/ω_s|^δ))·tanh(q̇/v_s), ω the speed of the motor (B.
    Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit: A survey of models, analysis tools and compensation
    methods for the control of machines with friction, Automatica 30 (1994), 1083-1138). The peak is as high
    as Ts where v_s is far below the Stribeck speed as seen at the joint, ω_s/|G|. An arm at rest creeps.

    Attributes:
        viscous: B [N·m·s/rad] at the motor.
        coulomb: Tc [N·m] at the motor, of fast motion.
        breakaway: Ts >= Tc [N·m] at the motor, of slow motion.
        stribeck_speed: ω_s [rad/s] of the motor, over which the one becomes the other.
        exponent: δ; 2 of a Gaussian, 1 of an exponential curve.
        smoothing_speed: v_s [rad/s] at the joint.
    """

    RANGES: ClassVar[FrictionRanges] = MappingProxyType(
        {
            "viscous": RESISTS,
            "coulomb": RESISTS,
            "breakaway": RESISTS,
            "stribeck_speed": _STRIBECK,
            "exponent": (POSITIVE, "2 is a Gaussian curve"),
            "smoothing_speed": SMOOTHING,
        }
    )

    viscous: float
    coulomb: float
    breakaway: float
    stribeck_speed: float
    exponent: float = 2.0
    smoothing_speed: float = 5e-3

    @property
    def coulomb_positive(self) -> float:
        """Return Tc [N·m], for positive joint speed."""
        return self.coulomb

    @property
    def coulomb_negative(self) -> float:
        """Return -Tc [N·m], for negative joint speed."""
        return -self.coulomb


@frozen_dataclass
class LoadFriction:
    """Friction of a gear whose dry part grows with the torque that the drive brings to the joint.

    At the joint it is B·G²·q̇ + (|G|·Tc + μ·|τ|)·tanh(q̇/v_s), τ the torque of the drive there (P. Hamon, M.
    Gautier, P. Garrec: Dynamic identification of robots with a dry friction model depending on load and
    velocity, IROS 2010, 6187-6193): a gear that drives has the efficiency 1 - μ.

    Attributes:
        viscous: B [N·m·s/rad] at the motor.
        coulomb: Tc [N·m] at the motor, without load.
        load_share: μ, from 0 to less than 1.
        smoothing_speed: v_s [rad/s] at the joint.
    """

    RANGES: ClassVar[FrictionRanges] = MappingProxyType(
        {
            "viscous": RESISTS,
            "coulomb": RESISTS,
            "load_share": (_PART, "a gear that loses all of its load would not turn"),
            "smoothing_speed": SMOOTHING,
        }
    )

    viscous: float
    coulomb: float
    load_share: float
    smoothing_speed: float = 5e-3

    @property
    def coulomb_positive(self) -> float:
        """Return Tc [N·m], for positive joint speed."""
        return self.coulomb

    @property
    def coulomb_negative(self) -> float:
        """Return -Tc [N·m], for negative joint speed."""
        return -self.coulomb


@frozen_dataclass
class LugreFriction:
    """Friction of bristles that bend until they slip: what is at rest sticks, as on a spring.

    At the motor it is σ0·z + σ1·z' + B·ω with z' = ω - σ0·|ω|/g(ω)·z, the bend z of the bristles, and g(ω) =
    Tc + (Ts - Tc)·exp(-(ω/ω_s)²), the friction of steady sliding (C. Canudas de Wit, H. Olsson, K. J. Åström,
    P. Lischinsky: A new model for control of systems with friction, IEEE Trans. Automatic Control 40 (1995),
    419-425). Bristles follow their speed with 2000/s at the most, which only fast changes of a fast motion
    feel. Where no state is at hand, as in inverse dynamics, plans and the torque that a law feeds forward, it
    is that of steady sliding with tanh(q̇/v_s) in place of its jump.

    Attributes:
        viscous: B [N·m·s/rad] at the motor.
        coulomb: Tc > 0 [N·m] at the motor, of fast motion.
        breakaway: Ts >= Tc [N·m] at the motor, from which on what sticks slips.
        stribeck_speed: ω_s [rad/s] of the motor.
        bristle_stiffness: σ0 [N·m/rad] at the motor.
        bristle_damping: σ1 [N·m·s/rad] at the motor.
        smoothing_speed: v_s [rad/s] at the joint.
    """

    RANGES: ClassVar[FrictionRanges] = MappingProxyType(
        {
            "viscous": RESISTS,
            "coulomb": RESISTS,
            "breakaway": RESISTS,
            "stribeck_speed": _STRIBECK,
            "bristle_stiffness": (POSITIVE, "breakaway torque over the angle within which a motor sticks"),
            "bristle_damping": (FROM_ZERO, "check the sign"),
            "smoothing_speed": SMOOTHING,
        }
    )

    viscous: float
    coulomb: float
    breakaway: float
    stribeck_speed: float
    bristle_stiffness: float
    bristle_damping: float = 0.0
    smoothing_speed: float = 5e-3

    @property
    def coulomb_positive(self) -> float:
        """Return Tc [N·m], for positive joint speed."""
        return self.coulomb

    @property
    def coulomb_negative(self) -> float:
        """Return -Tc [N·m], for negative joint speed."""
        return -self.coulomb


FrictionLaw = Friction | StribeckFriction | LoadFriction | LugreFriction
