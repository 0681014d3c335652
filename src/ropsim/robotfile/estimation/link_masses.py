"""Masses of links by rule: shares of the mass of the arm, spread along the links as cylinders.

The shares come from arms with published masses, by their class; docs/explanation/estimates.md has the
arms, and how far the rule misses them. An arm of another number of axes has the shares of the six-axis arm of
its class with neighbouring links taken together; the links of more than seven axes count as wrists.
"""

from collections.abc import Mapping, Sequence
from math import isfinite, log10, pi
from types import MappingProxyType

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model import ArmClass, Joint, Link
from ropsim.robotfile.estimation.joint_centres import JointCentres, joint_centres
from ropsim.spatial import Array, Pose, frozen

DENSITY = 1500.0
"""Of a link taken for a cylinder [kg/m³]: castings and motors with the hollows between them."""
LIGHTEST, HEAVIEST = 50.0, 1000.0
"""Total masses between which the shares of industrial arms change [kg]."""
COBOT_MASS = 0.41
"""Mass of a cobot over that of an industrial arm of the same payload and reach."""

_LIGHT = (0.244, 0.412, 0.179, 0.118, 0.036, 0.011)
_HEAVY = (0.438, 0.226, 0.272, 0.045, 0.015, 0.004)
_COBOT = (0.251, 0.375, 0.147, 0.107, 0.085, 0.035)
_SEVEN = (0.215, 0.22, 0.15, 0.15, 0.15, 0.08, 0.035)
_SCARA = (0.27, 0.22, 0.035, 0.007)  # of the whole mass
_CENTRES: Mapping[ArmClass, tuple[float, ...]] = MappingProxyType(
    {
        ArmClass.INDUSTRIAL: (0.57, 0.43, 0.45, 0.53, 0.38, 0.55),
        ArmClass.COBOT: (0.8, 0.46, 0.55, 0.95, 0.6, 0.5),
        ArmClass.SEVEN_AXIS: (0.6, 0.5, 0.75, 0.55, 0.6, 0.3, 0.3),
    }
)
"""Centre of mass of a link, as a share of the way from its joint to the next one."""
_MIDDLE = 0.5
_GROUPS: Mapping[int, tuple[tuple[int, ...], ...]] = MappingProxyType(
    {
        1: ((0, 1, 2, 3, 4, 5),),
        2: ((1,), (2, 3, 4, 5)),
        3: ((0,), (1,), (2, 3, 4, 5)),
        4: ((0,), (1,), (2, 3), (4, 5)),
        5: ((0,), (1,), (2, 3), (4,), (5,)),
    }
)
"""Links of a six-axis arm that count as one in an arm of fewer axes."""


@frozen_dataclass
class LinkMasses:
    """Masses of the moving links of an arm.

    Attributes:
        total: with the base [kg].
        links: of each moving link [kg].
    """

    total: float
    links: tuple[float, ...]


def total_mass(arm_class: ArmClass, payload: float, reach: float) -> float:
    """Return the mass of an arm with its base, estimated from size and payload only [kg].

    38·p^0.20·R^1.88, cobots 0.41 times that: 80 % of 25 arms within 1.75.

    Args:
        arm_class: of the arm.
        payload: rated, p [kg].
        reach: from axis 2 to the interface of the stretched arm, R [m].
    """
    light = arm_class in (ArmClass.COBOT, ArmClass.SEVEN_AXIS)
    return float(38.0 * payload**0.20 * reach**1.88 * (COBOT_MASS if light else 1.0))


def extended_length(joints: Sequence[Joint], X_nM: Pose) -> float:
    """Return the length of the stretched arm from axis 2 to the mechanical interface [m]."""
    points = joint_centres(joints, X_nM).points[min(1, len(joints) - 1) :]
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def link_masses(arm_class: ArmClass, count: int, total: float) -> LinkMasses:
    """Return the masses of the moving links of an arm by its total mass.

    Args:
        arm_class: of the arm.
        count: number of its links.
        total: mass of the arm with its base [kg].
    """
    return LinkMasses(total, tuple((total * _shares(arm_class, count, total)).tolist()))


def link_masses_of_moving(arm_class: ArmClass, count: int, moving: float) -> LinkMasses:
    """Return the masses of the moving links of an arm by their sum; arguments as `link_masses`.

    Args:
        arm_class: of the arm.
        count: number of its links.
        moving: mass of all moving links together [kg].
    """
    total = moving
    for _ in range(32):  # the share changes by less than a seventh of the mass: contracts
        total = moving / float(_shares(arm_class, count, total).sum())
    return link_masses(arm_class, count, total)


def _shares(arm_class: ArmClass, count: int, total: float) -> Array:
    """Return the masses of the moving links over that of the arm with its base, shape (count,)."""
    if arm_class is ArmClass.SCARA:
        return _grouped(np.array(_SCARA), count, len(_SCARA))
    if arm_class is ArmClass.SEVEN_AXIS:
        return 0.845 * _grouped(np.array(_SEVEN), count, len(_SEVEN))
    if arm_class is ArmClass.COBOT:
        return 0.855 * _grouped(np.array(_COBOT), count, len(_COBOT))
    x = heaviness(total)
    return (0.71 + 0.09 * x) * _grouped((1.0 - x) * np.array(_LIGHT) + x * np.array(_HEAVY), count, 6)


def heaviness(total: float) -> float:
    """Return how heavy an arm is, from 0 for one of 50 kg to 1 for one of a tonne, by its logarithm."""
    return min(max(log10(total / LIGHTEST) / log10(HEAVIEST / LIGHTEST), 0.0), 1.0) if total > 0.0 else 0.0


def _grouped(shares: Array, count: int, known: int) -> Array:
    """Return shares for another number of links than the known ones, of the same sum.

    Args:
        shares: of the known links.
        count: number of shares to return.
        known: number of the known links.
    """
    if count == known:
        return shares
    whole = float(shares.sum())
    if count > known:
        longer = np.append(shares, np.full(count - known, shares[-1]))
    elif known == 6:
        longer = np.array([shares[list(group)].sum() for group in _GROUPS[count]])
    else:
        longer = np.append(shares[: count - 1], shares[count - 1 :].sum())
    return np.asarray(longer * (whole / longer.sum()))


def bodies(joints: Sequence[Joint], X_nM: Pose, arm_class: ArmClass, masses: Sequence[float]) -> list[Link]:
    """Return the links of a serial arm with centre of mass and tensor by rule, in their joint frames.

    Args:
        joints: from the base on.
        X_nM: mechanical interface in the frame of the last joint.
        arm_class: of the arm.
        masses: of the links [kg].
    """
    centres = joint_centres(joints, X_nM)
    points, count = _ends(centres, arm_class), len(joints)
    table = _CENTRES.get(arm_class, ())
    shares = table if len(table) == count else (_MIDDLE,) * count
    found = []
    for number, (mass, share) in enumerate(zip(masses, shares, strict=True)):
        X_JB = np.linalg.inv(centres.frames[number])
        begin, end = ((X_JB @ [*point, 1.0])[:3] for point in points[number : number + 2])
        found.append(cylinder(begin, end, mass, share))
    return found


def _ends(centres: JointCentres, arm_class: ArmClass) -> Array:
    """Return where links begin and the last one ends [m], shape (n + 1, 3).

    Parallel axes say nothing about heights: links of SCARA arms begin at the origins of their joints.
    """
    if arm_class is ArmClass.SCARA:
        return np.vstack((centres.frames[:, :3, 3], centres.points[-1]))
    return centres.points


def cylinder(begin: Array, end: Array, mass: float, share: float) -> Link:
    """Return a link as a cylinder of `DENSITY` along a line, at least as long as thick.

    r₀ = (m/2πρ)^⅓, L = max(|line|, 2·r₀), r = √(m/πρL).

    Args:
        begin: of the line [m], shape (3,).
        end: of the line [m], shape (3,).
        mass: [kg].
        share: of the line from its begin to the centre of mass.
    """
    if not (mass > 0.0 and isfinite(mass)):
        return Link(0.0, np.zeros(3), np.zeros((3, 3)))
    line = end - begin
    distance = float(np.linalg.norm(line))
    length = max(distance, 2.0 * (mass / (2.0 * pi * DENSITY)) ** (1.0 / 3.0))
    radius = (mass / (pi * DENSITY * length)) ** 0.5
    along, across = 0.5 * mass * radius**2, mass * (3.0 * radius**2 + length**2) / 12.0
    axis = line / distance if distance > 1e-9 else np.array([0.0, 0.0, 1.0])
    tensor = across * np.eye(3) + (along - across) * np.outer(axis, axis)
    return Link(mass, frozen(np.round(begin + share * line, 12) + 0.0), frozen(0.5 * (tensor + tensor.T)))
