"""A SCARA arm with the dimensions of an Adept Cobra 600, for cells with assembly and sorting."""

from dataclasses import replace
from functools import lru_cache
from math import pi, radians

from ropsim.model import (
    DhRow,
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    IdealMotor,
    JointLimits,
    JointType,
    Link,
    OriginKind,
    ParameterOrigin,
    RobotModel,
    interface_from_dh,
    joints_from_dh,
    links_from_dh,
)
from ropsim.robots import scara_shapes
from ropsim.spatial import frozen

_DH = (
    DhRow(a=0.325, alpha=0.0, d=0.387),
    DhRow(a=0.275, alpha=pi, d=0.0),
    DhRow(a=0.0, alpha=0.0, d=0.0, type=JointType.PRISMATIC),
    DhRow(a=0.0, alpha=0.0, d=0.0),
)

_LIMITS = (
    JointLimits(radians(-105), radians(105), radians(360), radians(2000), radians(40000), 180.0),
    JointLimits(radians(-150), radians(150), radians(500), radians(3500), radians(70000), 90.0),
    JointLimits(0.0, 0.21, 1.1, 12.0, 300.0, 400.0),
    JointLimits(radians(-360), radians(360), radians(1200), radians(9000), radians(180000), 8.0),
)
_MASSES = (11.0, 9.0, 1.4, 0.3)
_COMS = ((-0.15, 0.0, 0.05), (-0.12, 0.0, -0.06), (0.0, 0.0, -0.12), (0.0, 0.0, -0.02))
_INERTIAS = ((0.05, 0.18, 0.18), (0.06, 0.14, 0.13), (0.02, 0.02, 5e-4), (3e-4, 3e-4, 2e-4))

# Ratios motor to joint (of the slide rad/m: a ball screw of 20 mm lead behind a belt 1:1), rotor inertias and
# largest torques of the motors; viscous and Coulomb friction at the motor.
_DRIVES = (
    (80.0, 1.3e-4, 2.3, 6e-4, 0.02),
    (50.0, 8e-5, 1.8, 4e-4, 0.014),
    (2.0 * pi / 0.02, 3e-5, 1.3, 1e-4, 0.008),
    (20.0, 4e-5, 0.4, 5e-5, 0.002),
)

_ORIGINS = (
    ParameterOrigin(
        "link lengths and stroke",
        OriginKind.PUBLISHED,
        "Adept Cobra 600 as in petercorke/robotics-toolbox-python, models/DH/Cobra600.py (MIT)",
    ),
    ParameterOrigin(
        "joint limits",
        OriginKind.ESTIMATED,
        "the usual range, speeds and accelerations of SCARA arms of this size",
    ),
    ParameterOrigin(
        "masses, centres of mass, moments of inertia",
        OriginKind.ESTIMATED,
        "about 41 kg in all with the base, spread over the arm as slender castings",
    ),
    ParameterOrigin(
        "motors, gears, friction",
        OriginKind.ESTIMATED,
        "servo motors with current loops faster than the control period, harmonic drives and a ball screw, "
        "chosen so that the acceleration limits take half of their torque",
    ),
    ParameterOrigin(
        "home position and drawn shapes", OriginKind.ESTIMATED, "bent to the right, quill halfway; by eye"
    ),
)


@lru_cache(maxsize=1)
def model() -> RobotModel:
    """Return the arm: two rotations about the vertical, a slide downwards, a rotation of the tool.

    Base frame at the foot, z up. The quill slides down for positive coordinates; its flange looks down.
    """
    return RobotModel(
        name="scara",
        title="SCARA arm, 600 mm",
        joints=joints_from_dh(_DH, _LIMITS),
        links=_links(),
        drives=tuple(
            Drive(EffortAmplifier(most), IdealMotor(rotor), Gear(ratio), Friction(viscous, dry, -dry, 0.02))
            for ratio, rotor, most, viscous, dry in _DRIVES
        ),
        X_nM=interface_from_dh(_DH),
        home=frozen([radians(-30), radians(75), 0.08, 0.0]),
        dh=_DH,
        origins=_ORIGINS,
        base_shapes=scara_shapes.base(),
    )


def _links() -> tuple[Link, ...]:
    bodies = zip(links_from_dh(_DH, _MASSES, _COMS, _INERTIAS), scara_shapes.links(), strict=True)
    return tuple(replace(link, shapes=shapes) for link, shapes in bodies)
