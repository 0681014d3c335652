"""A planar arm of two links in a vertical plane: the textbook case with answers in closed form."""

from dataclasses import replace
from functools import lru_cache
from math import pi

from ropsim.model import (
    DARK_GREY,
    Box,
    DhRow,
    JointLimits,
    Link,
    OriginKind,
    ParameterOrigin,
    Prism,
    RobotModel,
    Shape,
    around,
    ideal_drive,
    interface_from_dh,
    joints_from_dh,
    links_from_dh,
    rod,
)
from ropsim.spatial import Pose, frozen

_DH = (DhRow(a=1.0, alpha=0.0, d=0.0), DhRow(a=1.0, alpha=0.0, d=0.0))
_MOST = (
    120.0,
    50.0,
)  # torques [N·m]: three times the torque that holds the stretched arm with 1 kg at its end
_LIMITS = tuple(
    JointLimits(-pi, pi, max_speed=3.0, max_acceleration=10.0, max_jerk=100.0, max_effort=most)
    for most in _MOST
)


@lru_cache(maxsize=1)
def model() -> RobotModel:
    """Return two links of 1 m with point masses of 1 kg in their middles, each on its own motor.

    The arm moves in the x-z plane of the base frame; positive angles lift it. At rest the torques are
    9.81·(2, 0.5) N·m for q = (0, 0) and 9.81·(1.5, 0) N·m for q = (0, π/2).
    """
    upright = Pose(frozen([0.0, 0.0, 0.0]), frozen([1.0, 1.0, 0.0, 0.0]))  # Rx(π/2): axes along -y
    return RobotModel(
        name="two_link",
        title="Planar two-link arm",
        joints=joints_from_dh(_DH, _LIMITS, upright),
        links=_links(),
        drives=(ideal_drive(_MOST[0]), ideal_drive(_MOST[1])),
        X_nM=interface_from_dh(_DH),
        home=frozen([0.5, 1.0]),
        dh=_DH,
        origins=(
            ParameterOrigin(
                "lengths and masses",
                OriginKind.PUBLISHED,
                "two-link case of Corke's Robotics Toolbox (unit tests)",
            ),
            ParameterOrigin("limits and home position", OriginKind.ESTIMATED, "round numbers for teaching"),
            ParameterOrigin(
                "drives",
                OriginKind.ESTIMATED,
                "torque sources without inertia or friction; torques that carry 1 kg",
            ),
        ),
        base_shapes=(
            Shape(Box((0.3, 0.03, 0.3)), Pose(frozen([0.0, 0.115, 0.0])), DARK_GREY),
            rod((0.0, 0.1, 0.0), (0.0, 0.0, 0.0), 0.08, 0.06, "#6d7781"),
        ),
    )


def _links() -> tuple[Link, ...]:
    """Return two slats with round ends, the second in front of the first, on hubs about their axes."""
    slat = Prism(around(((0.0, 0.0, 0.06), (1.0, 0.0, 0.045))), 0.04)
    looks = (
        (Shape(slat, Pose(), "#dfe3e6"), rod((1.0, 0.0, 0.04), (1.0, 0.0, 0.05), 0.03, None, DARK_GREY)),
        (
            Shape(slat, Pose(frozen([0.0, 0.0, 0.05])), "#e2702b"),
            rod((0.0, 0.0, 0.09), (0.0, 0.0, 0.1), 0.03, 0.025, DARK_GREY),
        ),
    )
    bodies = links_from_dh(_DH, (1.0, 1.0), ((-0.5, 0.0, 0.0),) * 2, ((0.0, 0.0, 0.0),) * 2)
    return tuple(replace(link, shapes=shapes) for link, shapes in zip(bodies, looks, strict=True))
