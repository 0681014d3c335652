"""A palletizer with four axes whose rods keep the flange level: parallelograms as exact couplings.

In the plane of the arm: the lower arm leans at the angle q2 over the horizontal. A crank next to it, driven
from the same place, stands at q3; with the lower arm, the rear end of the forearm and a rod it forms a
parallelogram, so that the forearm has the angle q3 too, for any q2. Two more parallelograms, over a triangle
at the elbow, keep the wrist as level as the column. So all angles between bodies are sums of q2 and q3.
"""

from functools import lru_cache
from math import pi, radians, sqrt

import numpy as np

from ropsim.model import (
    BASE_LINK,
    Coupling,
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    IdealMotor,
    Joint,
    JointLimits,
    JointType,
    Link,
    OriginKind,
    ParameterOrigin,
    RobotModel,
    limited,
)
from ropsim.robots import palletizer_shapes as shapes
from ropsim.robots.palletizer_shapes import (
    CRANK,
    FLANGE,
    FOREARM,
    HEIGHT,
    LOWER_ARM,
    PIN,
    REACH,
    WRIST,
)
from ropsim.spatial import Array, Pose, frozen

_UPRIGHT = np.array([1.0, 1.0, 0.0, 0.0]) / sqrt(2.0)  # Rx(90°): x stays, y points up, z to the right side
_PASSIVE = JointLimits(-2.0 * pi, 2.0 * pi, 10.0, 100.0, 1000.0)  # of joints that follow: none of their own
_FOLDED, _DRAWN_OUT = radians(-155.0), radians(-25.0)  # forearm against the lower arm drawn on
_TURN, _ARM, _CRANK, _ELBOW, _ROD, _WRIST, _TRIANGLE, _LOW_LINK, _HIGH_LINK, _FLANGE = range(10)

_COUPLINGS = (
    Coupling(_ELBOW, ((_CRANK, 1.0), (_ARM, -1.0))),  # forearm parallel to the crank
    Coupling(_ROD, ((_ARM, 1.0), (_CRANK, -1.0))),  # rod parallel to the lower arm
    Coupling(_WRIST, ((_CRANK, -1.0),)),  # level
    Coupling(_TRIANGLE, ((_ARM, -1.0),)),  # level
    Coupling(_LOW_LINK, ((_ARM, 1.0),)),  # parallel to the lower arm
    Coupling(_HIGH_LINK, ((_CRANK, 1.0),)),  # parallel to the forearm
)

_ORIGINS = (
    ParameterOrigin(
        "link lengths, limits, masses, moments of inertia",
        OriginKind.ESTIMATED,
        "round numbers between those of palletizers for 100 to 200 kg with about 3 m reach",
    ),
    ParameterOrigin(
        "limits of the elbow",
        OriginKind.ESTIMATED,
        "the forearm stays 25° from the lower arm drawn on and 25° from lying back on it, where the "
        "parallelogram of crank and rod folds flat; catalogues limit axes 2 and 3 together in this way",
    ),
    ParameterOrigin(
        "motors, gears, friction",
        OriginKind.ESTIMATED,
        "servo motors with current loops faster than the control period; torques that carry 120 kg",
    ),
    ParameterOrigin("home position and drawn shapes", OriginKind.ESTIMATED, "forearm level; by eye"),
)


@lru_cache(maxsize=1)
def model() -> RobotModel:
    """Return the palletizer: base frame at the foot, z up; the flange looks down, for all axis values.

    Axis 1 turns the column, axis 2 is the angle of the lower arm and axis 3 that of the forearm over the
    horizontal, both raising it for positive turns; axis 4 turns the flange about the line that points down.
    """
    return RobotModel(
        name="palletizer",
        title="Palletizer with four axes and level flange",
        joints=_joints(),
        links=_links(),
        drives=(
            _drive(210.0, 3.5e-3, 30.0, 2e-3, 0.6),
            _drive(250.0, 4e-3, 38.0, 2e-3, 0.6),
            _drive(250.0, 4e-3, 38.0, 2e-3, 0.6),
            _drive(100.0, 8e-4, 8.0, 5e-4, 0.1),
        ),
        home=frozen([0.0, radians(95), radians(-10), 0.0]),
        axes=(_TURN, _ARM, _CRANK, _FLANGE),
        couplings=_COUPLINGS,
        X_nM=Pose(frozen([0.0, 0.0, FLANGE])),
        tip=_FLANGE,
        origins=_ORIGINS,
        base_shapes=shapes.base(),
    )


def _drive(ratio: float, rotor: float, most: float, viscous: float, dry: float) -> Drive:
    return Drive(EffortAmplifier(most), IdealMotor(rotor), Gear(ratio), Friction(viscous, dry, -dry, 0.005))


def _joints() -> tuple[Joint, ...]:
    at_shoulder = Pose(np.array([REACH, 0.0, HEIGHT]), _UPRIGHT)
    pin = Pose(np.array([REACH + PIN[0], 0.0, HEIGHT + PIN[1]]), _UPRIGHT)
    axes = {
        _TURN: JointLimits(radians(-180), radians(180), radians(140), 4.0, 40.0, 6000.0),
        _ARM: JointLimits(radians(40), radians(145), radians(110), 3.0, 30.0, 9000.0),
        _CRANK: JointLimits(radians(-80), radians(25), radians(110), 3.0, 30.0, 9000.0),
        _FLANGE: JointLimits(radians(-350), radians(350), radians(350), 15.0, 150.0, 800.0),
    }
    axes[_ELBOW] = JointLimits(_FOLDED, _DRAWN_OUT, 10.0, 100.0, 1000.0)  # follows axes 2 and 3
    places = (
        ("1", BASE_LINK, Pose()),
        ("2", _TURN, at_shoulder),
        ("3", _TURN, at_shoulder),
        ("elbow", _ARM, _ahead(LOWER_ARM)),
        ("rod", _CRANK, _ahead(-CRANK)),
        ("wrist", _ELBOW, _ahead(FOREARM)),
        ("triangle", _ARM, _ahead(LOWER_ARM)),
        ("lower link", _TURN, pin),
        ("upper link", _TRIANGLE, Pose(np.array([*PIN, 0.0]))),
        ("4", _WRIST, Pose(np.array([WRIST, 0.0, 0.0]), _UPRIGHT)),
    )
    return tuple(
        limited(name, JointType.REVOLUTE, placement, axes.get(number, _PASSIVE), parent)
        for number, (name, parent, placement) in enumerate(places)
    )


def _ahead(x: float) -> Pose:
    return Pose(np.array([x, 0.0, 0.0]))


def _links() -> tuple[Link, ...]:
    """Return the bodies: mass, centre of mass, and moments about it in axes of the joint frames."""
    bodies: tuple[tuple[float, tuple[float, float, float], Array], ...] = (
        (420.0, (0.05, 0.0, 0.45), np.diag([45.0, 50.0, 35.0])),
        (150.0, (0.5, 0.0, 0.0), _slat(150.0, LOWER_ARM)),
        (45.0, (-0.2, 0.0, 0.0), _slat(45.0, CRANK)),
        (110.0, (0.35, 0.0, 0.0), _slat(110.0, FOREARM + CRANK)),
        (14.0, (LOWER_ARM / 2.0, 0.0, 0.0), _slat(14.0, LOWER_ARM)),
        (40.0, (0.1, 0.05, 0.0), np.diag([0.8, 0.9, 0.9])),
        (12.0, (0.0, 0.1, 0.0), np.diag([0.15, 0.1, 0.15])),
        (10.0, (LOWER_ARM / 2.0, 0.0, 0.0), _slat(10.0, LOWER_ARM)),
        (9.0, (FOREARM / 2.0, 0.0, 0.0), _slat(9.0, FOREARM)),
        (12.0, (0.0, 0.0, 0.1), np.diag([0.1, 0.1, 0.08])),
    )
    return tuple(
        Link(mass, np.array(com), inertia, looks)
        for (mass, com, inertia), looks in zip(bodies, shapes.links(), strict=True)
    )


def _slat(mass: float, length: float) -> Array:
    """Return the moments of a slat along x with a width of an eighth of its length."""
    across = length / 8.0
    long_, short = mass / 12.0 * (length**2 + across**2), mass / 6.0 * across**2
    return np.diag([short, long_, long_])
