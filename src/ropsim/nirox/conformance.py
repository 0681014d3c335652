"""How much of an arm a file says: its conformance class."""

from enum import StrEnum

from ropsim.model import RobotModel


class ConformanceClass(StrEnum):
    """The classes of NIROX files; each asks for what those before it ask for.

    Masses and geometry are those of all moving links, drives those of all axes; an arm without closed chains
    needs no cuts.
    """

    CC1 = "kinematics"
    CC2 = "masses"
    CC3 = "drives"
    CC4 = "cuts of closed chains"
    CC5 = "geometry"


def conformance_of(robot: RobotModel) -> ConformanceClass:
    """Return the greatest class whose demands a robot meets; the dynamics need CC2, the drives CC3."""
    weighs = all(link.mass or link.inertia.any() for link in robot.links)
    if not weighs:
        return ConformanceClass.CC1
    if not robot.drives:
        return ConformanceClass.CC2
    drawn = all(link.shapes for link in robot.links)
    return ConformanceClass.CC5 if drawn else ConformanceClass.CC4
