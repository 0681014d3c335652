"""Elasticity of a link, lumped at the output of the drive that moves it."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class LinkElasticity:
    """A spring and a damper between the output of a drive, its hub, and the link that it moves.

    The drive moves the hub at the coordinate h, which its motor knows; the link is at the coordinate q of the
    joint, and the torque between them is k·(h - q) + d·(ḣ - q̇). The hub has the inertia of its own, and that
    of the drive seen through its gear. A beam of length L that is clamped at the hub and bears a force at its
    tip yields there as a rigid one behind k = 3·E·I/L does; one that is twisted has k = G·J/L (S. P.
    Timoshenko: Strength of Materials, part I, deflection of beams, torsion).

    Attributes:
        stiffness: k at the joint [N·m/rad | N/m].
        damping: d at the joint [N·m·s/rad | N·s/m].
        hub_inertia: of the hub alone [kg·m² | kg].
    """

    stiffness: float
    damping: float = 0.0
    hub_inertia: float = 0.0
