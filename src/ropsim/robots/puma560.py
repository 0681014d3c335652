"""The Unimation PUMA 560 with the dynamic parameters that Corke & Armstrong-Hélouvry collected."""

from dataclasses import replace
from functools import lru_cache
from math import pi, radians

import numpy as np

from ropsim.model import (
    DcMotor,
    DhRow,
    Drive,
    Friction,
    Gear,
    JointLimits,
    Link,
    OriginKind,
    ParameterOrigin,
    RobotModel,
    VoltageAmplifier,
    interface_from_dh,
    joints_from_dh,
    links_from_dh,
)
from ropsim.robots import puma560_shapes
from ropsim.spatial import frozen

_DH = (
    DhRow(a=0.0, alpha=pi / 2, d=0.67183),
    DhRow(a=0.4318, alpha=0.0, d=0.0),
    DhRow(a=0.0203, alpha=-pi / 2, d=0.15005),
    DhRow(a=0.0, alpha=pi / 2, d=0.4318),
    DhRow(a=0.0, alpha=-pi / 2, d=0.0),
    DhRow(a=0.0, alpha=0.0, d=0.0),
)

_POSITION_LIMITS = (  # degrees; the arm is straight at q3 = -90 and bends 135 either way
    (-160.0, 160.0),
    (-45.0, 225.0),
    (-225.0, 45.0),
    (-110.0, 170.0),
    (-100.0, 100.0),
    (-266.0, 266.0),
)
_SPEEDS = (1.92, 1.51, 2.40, 5.34, 5.09, 5.74)
_ACCELERATIONS = (6.0, 5.0, 9.0, 25.0, 25.0, 25.0)
_JERKS = (60.0, 50.0, 90.0, 250.0, 250.0, 250.0)
_EFFORTS = (97.6, 186.4, 89.4, 24.2, 20.1, 21.3)

# Link 1: only the moment about its vertical axis was published, because no other can act.
_MASSES = (0.0, 17.4, 4.8, 0.82, 0.34, 0.09)
_COMS = (
    (0.0, 0.0, 0.0),
    (-0.3638, 0.006, 0.2275),
    (-0.0203, -0.0141, 0.070),
    (0.0, 0.019, 0.0),
    (0.0, 0.0, 0.0),
    (0.0, 0.0, 0.032),
)
_INERTIAS = (
    (0.0, 0.35, 0.0),
    (0.13, 0.524, 0.539),
    (0.066, 0.086, 0.0125),
    (1.8e-3, 1.3e-3, 1.8e-3),
    (0.3e-3, 0.4e-3, 0.3e-3),
    (0.15e-3, 0.15e-3, 0.04e-3),
)

_RATIOS = (-62.6111, 107.815, -53.7063, 76.0364, 71.923, 76.686)
_ROTOR_INERTIAS = (200e-6, 200e-6, 200e-6, 33e-6, 33e-6, 33e-6)
_VISCOUS = (1.48e-3, 0.817e-3, 1.38e-3, 71.2e-6, 82.6e-6, 36.7e-6)
_COULOMB = (
    (0.395, -0.435),
    (0.126, -0.071),
    (0.132, -0.105),
    (11.2e-3, -16.9e-3),
    (9.26e-3, -14.5e-3),
    (3.96e-3, -10.5e-3),
)
_TORQUE_CONSTANTS = (0.19, 0.19, 0.19, 0.07, 0.07, 0.07)
_RESISTANCES = (2.1, 2.1, 2.1, 6.7, 6.7, 6.7)
_INDUCTANCES = (3.5e-3, 3.5e-3, 3.5e-3, 5e-3, 5e-3, 5e-3)
_MAX_CURRENTS = (8.3, 9.2, 8.8, 4.6, 4.1, 4.0)
_MAX_VOLTAGE = 40.0

_CORKE = "Corke & Armstrong-Hélouvry, IEEE ICRA 1994, pp. 1608-1613 (Corke's set of 8/95)"
_TOOLBOX = "petercorke/robotics-toolbox-python, models/DH/Puma560.py (MIT)"

_ORIGINS = (
    ParameterOrigin(
        "link lengths",
        OriginKind.PUBLISHED,
        f"standard DH as in {_TOOLBOX}; pedestal of 26.45 in: d1 = 0.67183 m",
    ),
    ParameterOrigin(
        "joint position limits",
        OriginKind.PUBLISHED,
        "Fu, Gonzalez & Lee, Robotics, 1987, Table 2.1, brought into this DH form",
    ),
    ParameterOrigin(
        "masses, centres of mass, moments of inertia", OriginKind.PUBLISHED, f"{_CORKE}, as in {_TOOLBOX}"
    ),
    ParameterOrigin(
        "gear ratios, rotor inertias, friction", OriginKind.PUBLISHED, f"{_CORKE}, as in {_TOOLBOX}"
    ),
    ParameterOrigin(
        "joint speed limits",
        OriginKind.DERIVED,
        "Corke, Visual Control of Robots, 1996, Tables 2.9, 2.18 and 2.21: motor speed at voltage saturation "
        "divided by the gear ratio (read at second hand)",
    ),
    ParameterOrigin(
        "joint torque limits",
        OriginKind.PUBLISHED,
        "Armstrong, Khatib & Burdick, IEEE ICRA 1986, Table 7 (read at second hand)",
    ),
    ParameterOrigin(
        "joint acceleration and jerk limits",
        OriginKind.ESTIMATED,
        "a tenth to a third of what the torque limits allow with the largest inertias; jerk ten times that "
        "per second",
    ),
    ParameterOrigin(
        "motor constants",
        OriginKind.ESTIMATED,
        "one motor type for joints 1 to 3 and one for the wrist, chosen so "
        "that back-EMF, friction and gravity at the speed limit stay below the amplifier's voltage",
    ),
    ParameterOrigin(
        "amplifier voltage and current",
        OriginKind.ESTIMATED,
        "40 V; currents that give the joint torque limits with the motor constants",
    ),
    ParameterOrigin(
        "friction smoothing speed",
        OriginKind.ESTIMATED,
        "0.3 degrees per second, far below any programmed speed",
    ),
    ParameterOrigin(
        "home position", OriginKind.ESTIMATED, "elbow up, tool straight down in front, clear of limits"
    ),
    ParameterOrigin(
        "drawn shapes",
        OriginKind.ESTIMATED,
        "drawn by eye around the link lengths; collisions are looked for with these shapes",
    ),
)

_SMOOTHING_SPEED = 5e-3
_HOME = (0.0, 75.0, -180.0, 0.0, -75.0, 0.0)  # degrees


@lru_cache(maxsize=1)
def model() -> RobotModel:
    """Return the PUMA 560: standard DH with pedestal, base frame at the foot, z up.

    Every group of parameters states its source in `origins`; the estimated ones are marked so.
    """
    return RobotModel(
        name="puma560",
        title="Unimation PUMA 560",
        joints=joints_from_dh(_DH, _limits()),
        links=_links(),
        drives=_drives(),
        X_nM=interface_from_dh(_DH),
        home=frozen(np.radians(_HOME)),
        dh=_DH,
        origins=_ORIGINS,
        base_shapes=puma560_shapes.base(),
    )


def _links() -> tuple[Link, ...]:
    bodies = zip(links_from_dh(_DH, _MASSES, _COMS, _INERTIAS), puma560_shapes.links(), strict=True)
    return tuple(replace(link, shapes=shapes) for link, shapes in bodies)


def _limits() -> tuple[JointLimits, ...]:
    columns = zip(_POSITION_LIMITS, _SPEEDS, _ACCELERATIONS, _JERKS, _EFFORTS, strict=True)
    return tuple(
        JointLimits(radians(lower), radians(upper), speed, acceleration, jerk, effort)
        for (lower, upper), speed, acceleration, jerk, effort in columns
    )


def _drives() -> tuple[Drive, ...]:
    columns = zip(
        _RATIOS,
        _TORQUE_CONSTANTS,
        _RESISTANCES,
        _INDUCTANCES,
        _ROTOR_INERTIAS,
        _VISCOUS,
        _COULOMB,
        _MAX_CURRENTS,
        strict=True,
    )
    return tuple(
        Drive(
            VoltageAmplifier(_MAX_VOLTAGE, current),
            DcMotor(constant, constant, resistance, inductance, rotor),
            Gear(ratio),
            Friction(viscous, positive, negative, _SMOOTHING_SPEED),
        )
        for ratio, constant, resistance, inductance, rotor, viscous, (positive, negative), current in columns
    )
