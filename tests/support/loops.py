"""Published mechanisms with closed chains, and linkages of springs and pins, for tests of their dynamics."""

from math import pi

import numpy as np

from ropsim.model import (
    BASE_LINK,
    Direction,
    Joint,
    JointType,
    Link,
    LoopCut,
    RobotModel,
    Spring,
)
from ropsim.spatial import Array, Pose

IN_PLANE = (Direction.X, Direction.Y)
PIN = tuple(one for one in Direction if one is not Direction.ABOUT_Z)
DOWN = np.array([0.0, -9.81, 0.0])


def at(x: float, y: float = 0.0, z: float = 0.0) -> Pose:
    return Pose(np.array([x, y, z]))


def joint(
    name: str, placement: Pose, parent: int = BASE_LINK, type_: JointType = JointType.REVOLUTE
) -> Joint:
    return Joint(name, type_, placement, 0.0, -400.0, 400.0, 1.0, 1.0, 1.0, parent=parent)


def plane_body(mass: float, x: float, y: float, inertia: float) -> Link:
    """Return a body that moves in a plane, with the moment of inertia about its centre of mass (x, y)."""
    return Link(mass, np.array([x, y, 0.0]), np.diag([0.0, 0.0, inertia]))


def rod(mass: float, length: float) -> Link:
    return plane_body(mass, length / 2.0, 0.0, mass * length**2 / 12.0)


def four_bars(count: int, held: tuple[Direction, ...] = IN_PLANE) -> RobotModel:
    """Return the N-four-bar mechanism: cranks and couplers, all of 1 m and 1 kg, side by side.

    M. González, D. Dopico, U. Lugrís, J. Cuadrado: A benchmarking system for MBS simulation software,
    Multibody System Dynamics 16 (2006), 179-190; problem A02 of the library of the IFToMM.
    """
    cranks = [joint(f"crank {k}", at(float(k))) for k in range(count + 1)]
    couplers = [joint(f"coupler {k}", at(1.0), k) for k in range(count)]
    cuts = tuple(LoopCut(count + 1 + k, at(1.0), k + 1, at(1.0), held) for k in range(count))
    return mechanism((*cranks, *couplers), (rod(1.0, 1.0),) * (2 * count + 1), cuts, pi / 2, DOWN)


def mechanism(
    joints: tuple[Joint, ...],
    links: tuple[Link, ...],
    cuts: tuple[LoopCut, ...],
    home: float,
    gravity: Array,
    springs: tuple[Spring, ...] = (),
) -> RobotModel:
    return RobotModel(
        "loop",
        "loop",
        joints,
        links,
        (),
        np.array([home]),
        axes=(0,),
        cuts=cuts,
        gravity=gravity,
        springs=springs,
    )


ANDREWS_START = (
    -0.0617138900142764,
    0.0,
    0.455279819163070,
    0.487364979543842,
    0.222668390165886,
    1.230547444549821,
    -0.222668390165886,
)
"""β, Θ, γ, δ, Φ, ε, Ω [rad]."""

ANDREWS_END = (
    15.81077119629904,
    -15.75637105984298,
    0.04082224013073101,
    0.5244099658805304,
    -0.5347301163226948,
    1.048080741042263,
    0.5347301163226948,
)
"""The same after 0.03 s."""

ANDREWS_TORQUE = 0.033
"""On the crank [N·m]."""


def andrews() -> RobotModel:
    """Return Andrews' squeezing mechanism: seven bodies, three loops, a spring, no gravity.

    W. Schiehlen (ed.): Multibody Systems Handbook, Springer 1990; E. Hairer, G. Wanner: Solving Ordinary
    Differential Equations II, 2nd ed., Springer 1996, section VII.7. Numbers, start and values at 0.03 s of
    the test set for IVP solvers (F. Mazzia, C. Magherini, University of Bari 2008, problem `andrews`).
    """
    m = (0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498)
    inertia = (2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5)
    A, B, C = (-0.06934, -0.00227), (-0.03635, 0.03273), (0.014, 0.072)
    d, da, e, ea, rr, ra, ss = 0.028, 0.0115, 0.02, 0.01421, 0.007, 0.00092, 0.035
    sa, sb, sc, sd, ta, tb = 0.01874, 0.01043, 0.018, 0.02, 0.02308, 0.00916
    u, ua, ub, zf, zt, fa = 0.04, 0.01228, 0.00449, 0.02, 0.04, 0.01421
    joints = (
        joint("beta", at(0.0)),
        joint("theta", at(rr), 0),
        joint("gamma", at(*B)),
        joint("delta", at(*A)),
        joint("phi", at(zt), 3),
        joint("epsilon", at(*A)),
        joint("omega", at(0.0, -u), 5),
    )
    links = (
        plane_body(m[0], ra, 0.0, inertia[0]),
        plane_body(m[1], -da, 0.0, inertia[1]),
        plane_body(m[2], sb, -sa, inertia[2]),
        plane_body(m[4], ta, tb, inertia[4]),
        plane_body(m[3], 0.0, ea - e, inertia[3]),
        plane_body(m[6], ua, ub, inertia[6]),
        plane_body(m[5], zf - fa, 0.0, inertia[5]),
    )
    ends = ((2, at(0.0, -ss)), (4, at(0.0, -e)), (6, at(zf)))
    cuts = tuple(LoopCut(1, at(-d), link, X, IN_PLANE) for link, X in ends)
    spring = Spring("spring", BASE_LINK, np.array([*C, 0.0]), 2, np.array([sd, -sc, 0.0]), 4530.0, 0.07785)
    return mechanism(joints, links, cuts, ANDREWS_START[0], np.zeros(3), (spring,))
