"""A ball screw that turns what a motor turns into what a joint slides."""

from math import inf, pi

from ropsim.core import frozen_dataclass


@frozen_dataclass
class BallScrew:
    """A screw that its motor turns; the nut on it slides with the joint.

    With the ratio G = 1/p, p the lead for each radian, its nut is pushed with G·τ·η₁ by a motor torque τ that
    drives it, and with G·τ/η₂ by one that brakes it: friction in the threads helps to hold a load (DIN
    69051-4, ISO 3408-5; for screws with little friction η₂ = 2 - 1/η₁).

    Attributes:
        lead: p, way of the nut for each radian of the screw, signed [m/rad].
        efficiency: η₁, from motor to nut, more than 0 and at most 1.
        back_efficiency: η₂, from nut to motor, more than 0 and at most 1.
        screw_inertia: of screw and coupling, besides that of the rotor [kg·m²].
    """

    lead: float
    efficiency: float = 1.0
    back_efficiency: float = 1.0
    screw_inertia: float = 0.0

    @property
    def ratio(self) -> float:
        """Return G = 1/p, turn of the motor over way of the joint [rad/m]; inf without a lead."""
        return 1.0 / self.lead if self.lead else inf


def lead_per_turn(lead: float) -> float:
    """Return the way of a nut for a whole turn [m], as the shortest number that `lead_of_turn` leads back.

    Args:
        lead: way for each radian [m/rad].
    """
    turn = 2.0 * pi * lead
    shorter = (float(f"{turn:.{digits}g}") for digits in range(6, 18))
    return next((one for one in shorter if lead_of_turn(one) == lead), turn)


def lead_of_turn(turn: float) -> float:
    """Return the way of a nut for each radian [m/rad] from that for a whole turn [m]."""
    return turn / (2.0 * pi)


def usual_back_efficiency(efficiency: float) -> float:
    """Return 2 - 1/η₁, the efficiency of a screw that its nut drives; 0 for one that locks itself."""
    return max(2.0 - 1.0 / efficiency, 0.0)
