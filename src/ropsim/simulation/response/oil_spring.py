"""What a hydraulic axis stands on at a place: its lever, the mass at its rod, and the spring of its oil.

H. E. Merritt: Hydraulic Control Systems, Wiley 1967, chapter 6: with the valve closed, a mass m swings on the
oil of both chambers at ω² = β·(A_a²/V_a + A_b²/V_b)/m.
"""

from math import pi, sqrt

import numpy as np

from ropsim.dynamics import gravity, mass_matrix, steady_drive
from ropsim.model import Drive, Hydraulic, Payload, RobotModel
from ropsim.simulation.servo.held_state import without_dead_zones
from ropsim.spatial import Array, record

_SLOW = 0.01
"""Share of the speed limit of a joint at which the opening of its valve is looked at."""


@record
class OilSpring:
    """A hydraulic axis at a place of the arm.

    Attributes:
        axis: its number, from 0.
        lever: way of the rod or angle of the shaft over that of the joint, magnitude [m/rad | rad/rad | 1].
        mass: of arm, load and rod as the rod feels it [kg], or as the shaft does [kg·m²].
        stiffness: of the oil in both chambers at the rod [N/m], or at the shaft [N·m/rad].
        hz: frequency at which the axis alone swings on it [Hz].
        forward: speed of the joint over the opening of its valve, 1 at the rated current, where it goes
            forward [rad/s | m/s].
        back: the same where it goes back.
    """

    axis: int
    lever: float
    mass: float
    stiffness: float
    hz: float
    forward: float
    back: float


def oil_springs(robot: RobotModel, q: Array, payload: Payload) -> tuple[OilSpring, ...]:
    """Return the hydraulic axes of an arm at rest; none of an electric one.

    Args:
        robot: with drives.
        q: coordinates [rad | m], shape (n,).
        payload: tool and part.
    """
    hydraulic = [k for k, drive in enumerate(robot.drives) if isinstance(drive.motor, Hydraulic)]
    if not hydraulic:
        return ()
    arm = without_dead_zones(robot)
    masses, efforts = np.diag(mass_matrix(arm, q, payload)), gravity(arm, q, payload)
    found = []
    for axis in hydraulic:
        drive, place = arm.drives[axis], float(q[axis])
        lever, stiffness = abs(drive.ratio_at(place)), _motor(drive).oil_stiffness(drive.shaft_at(place))
        mass = float(masses[axis]) / lever**2 if lever else np.inf
        speed = _SLOW * float(arm.max_speeds[axis])
        effort = float(efforts[axis])
        still = steady_drive(drive, place, 0.0, effort).command
        forward, back = (
            way * speed / (steady_drive(drive, place, way * speed, effort).command - still)
            for way in (1.0, -1.0)
        )
        rated = _motor(drive).rated_input
        hz = sqrt(stiffness / mass) / (2.0 * pi)
        found.append(OilSpring(axis, lever, mass, stiffness, hz, abs(forward) * rated, abs(back) * rated))
    return tuple(found)


def _motor(drive: Drive) -> Hydraulic:
    assert isinstance(drive.motor, Hydraulic)
    return drive.motor
