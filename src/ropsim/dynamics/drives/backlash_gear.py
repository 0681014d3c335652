"""A gear that twists and has play: between its flanks motor and joint move separately.

M. Nordin, P.-O. Gutman: Controlling mechanical systems with backlash - a survey, Automatica 38 (2002),
1633-1649, have the dead zone before the spring, and flanks that do not pull at each other.
"""

from math import copysign

from ropsim.codegen import maximum, minimum
from ropsim.dynamics.drives.block import Carried, Numbers, Shaft, Steady, TransmissionBlock
from ropsim.dynamics.drives.elastic_gear import ROTOR_STATES, rotor_speed, trace_rotor
from ropsim.model import BacklashGear


def _trace(p: Numbers, states: Numbers, shaft: Shaft) -> Carried:
    """Return the torque of the flanks, k·p + d·(ω/G - q̇), where they are pressed by p: θ/G - q less the play.

    Damping is at most as large as the force of the spring. So flanks do not pull, and what meets them begins
    to feel them without a jump.
    """
    ratio, stiffness, damping, backlash = p
    theta, omega = states
    twist, half = theta - shaft.q, 0.5 * backlash
    pressed = stiffness * (twist - minimum(maximum(twist, -half), half))
    most = abs(pressed)
    flanks = pressed + minimum(maximum(damping * (omega - shaft.qd), -most), most)
    return trace_rotor(shaft, ratio, states, flanks)


def _rest(gear: BacklashGear, q: float, effort: float) -> Steady:
    """Return the flanks that carry the effort; without any, the middle of the play."""
    play = copysign(0.5 * gear.backlash, effort) if effort else 0.0
    return Steady((q + effort / gear.stiffness + play, 0.0), effort / gear.ratio)


BACKLASH_GEAR = TransmissionBlock(
    ("ratio", "stiffness", "damping", "backlash"),
    ("stiffness", "backlash"),
    ROTOR_STATES,
    _trace,
    _rest,
    rotor_speed,
)
