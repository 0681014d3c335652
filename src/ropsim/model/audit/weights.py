"""Masses of an arm as a whole: too heavy for its length, too light for its payload, one for all links."""

from collections.abc import Iterator, Sequence
from math import isfinite

import numpy as np

from ropsim.core import Diagnostic
from ropsim.model.findings import doubt_diagnostics as kinds
from ropsim.model.findings.place import Attribute, AuditPlace, PlaceOf
from ropsim.model.mechanism.links import JointType, Link
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.model.robots.robot import RobotModel

DENSEST = 50.0
"""Most mass of an arm over the cube of its length [kg/m³].

Forty arms of makers and libraries have 1 to 39; one whose file adds up to 3.3 t instead of 1.1 t has 56.
"""
SHORTEST = 0.3
"""Length from which that rule holds [m]; shorter arms may weigh as much as one of this length."""
LIGHTEST = 0.8
"""Least mass of the moving links over the rated payload; the LBR iiwa 14, the lightest known, has 1.8."""
SAME = 3
"""Number of links from which equal numbers are no coincidence."""


def length_of(robot: Mechanism) -> float:
    """Return the sum of the lengths from joint to joint and to the interface, and of all strokes [m]."""
    steps = sum(float(np.linalg.norm(joint.placement.position)) for joint in robot.joints)
    slides = (joint for joint in robot.axis_joints if joint.type is JointType.PRISMATIC)
    strokes = sum(max(abs(joint.lower), abs(joint.upper)) for joint in slides)
    return steps + float(np.linalg.norm(robot.interface.position)) + strokes


def heaviest(length: float) -> float:
    """Return what an arm of a length [m] weighs at most [kg]."""
    return DENSEST * max(length, SHORTEST) ** 3


def one_mass(links: Sequence[Link]) -> float | None:
    """Return the mass [kg] that all links with a mass have; None where they differ or are few."""
    masses = [link.mass for link in links if link.mass > 0.0]
    return masses[0] if len(masses) >= SAME and len(set(masses)) == 1 else None


def weight_doubts(robot: Mechanism, place_of: PlaceOf) -> Iterator[Diagnostic]:
    """Yield the doubts about the sum of the masses of the links.

    Args:
        robot: audited mechanism; only robots have a rated payload.
        place_of: where its numbers stand in the file that it was read from.
    """
    length, total = length_of(robot), sum(link.mass for link in robot.links)
    if total > heaviest(length):
        number = max(range(len(robot.links)), key=lambda k: robot.links[k].mass)
        yield kinds.UNLIKELY_MASS.at(
            place_of(AuditPlace(number, Attribute.MASS)),
            f"the links of `{robot.name}` have {total:.4g} kg at {length:.3g} m of length, "
            f"no arm has more than {heaviest(length):.3g} kg",
            hint="masses are in kg; are these in grams?",
            data={"mass_kg": total, "length_m": length},
        )
    payload = robot.rated_payload if isinstance(robot, RobotModel) else 0.0
    if isfinite(payload) and 0.0 < total < LIGHTEST * payload:
        yield kinds.LIGHT_ARM.at(
            place_of(AuditPlace(0, Attribute.MASS)),
            f"the links of `{robot.name}` have {total:.4g} kg, its rated payload is {payload:g} kg",
            hint="masses are in kg; is the payload that of this arm?",
            data={"mass_kg": total, "payload_kg": payload},
        )
