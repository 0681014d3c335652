"""A link that yields at the output of its drive: the hub has a coordinate and a speed of its own.

W. J. Book: Controlled motion in an elastic world, ASME J. Dyn. Sys. Meas. Control 115 (1993), 252-261.
"""

from ropsim.codegen import Scalar
from ropsim.dynamics.drives.block import Carried, Column, LinkBlock, Numbers
from ropsim.model import LinkElasticity

HUB_STATES = (
    Column("hub_coordinate", "{q}", "coordinate of the hub, which the drive moves before its elastic link"),
    Column("hub_speed", "{q}/s", "speed of the hub"),
)
"""h and ḣ, where the drive has its joint."""


def _trace(p: Numbers, states: Numbers, joint: tuple[Scalar, Scalar], drive: Carried) -> Carried:
    """Return the torque of the spring, and (J_h + J·G²)·ḧ = effort - friction - spring."""
    stiffness, damping, own = p
    hub, speed = states
    q, qd = joint
    spring = stiffness * (hub - q) + damping * (speed - qd)
    left = drive.effort - spring
    if drive.friction is not None:
        left = left - drive.friction.under(drive.effort)
    inertia = own if drive.inertia is None else own + drive.inertia
    return Carried(spring, None, None, (*drive.rates, speed, left / inertia), drive.given)


def _hub(link: LinkElasticity, q: float, effort: float) -> float:
    return q + effort / link.stiffness


LINK_ELASTICITY = LinkBlock(
    numbers=("stiffness", "damping", "hub_inertia"),
    positive=("stiffness",),
    states=HUB_STATES,
    trace=_trace,
    hub=_hub,
)
