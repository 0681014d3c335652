"""Facts about an arm beyond its model, from which estimates are made."""

from math import inf

from ropsim.core import frozen_dataclass
from ropsim.robotfile.estimation.torque_limits import TorqueTrust


@frozen_dataclass
class ArmFacts:
    """Facts about an arm that its model has no place for.

    Attributes:
        total_mass: of the arm with its base [kg]; inf where unknown.
        mass_source: where that mass is from.
        payload: that estimates are made for where the arm has no rated payload [kg]; inf for none.
        rotors: inertias of the rotors at the joints [kg·m² | kg]; empty where unknown.
        ratios: of the gears [- | rad/m]; empty where unknown.
        trust: who stands for the torque limits of the arm.
    """

    total_mass: float = inf
    mass_source: str = ""
    payload: float = inf
    rotors: tuple[float, ...] = ()
    ratios: tuple[float, ...] = ()
    trust: TorqueTrust = TorqueTrust.FILE
