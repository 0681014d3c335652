"""Published mechanisms with closed chains, and linkages of springs and pins, for tests of their dynamics."""

from dataclasses import replace
from math import pi

import numpy as np

from ropsim.dynamics import mass_matrices
from ropsim.kinematics import frames_batch
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


def opened(robot: RobotModel) -> RobotModel:
    """Return the tree of a mechanism whose joints have one freedom each, with all joints as axes."""
    return replace(robot, cuts=(), axes=(), home=np.zeros(len(robot.joints)))


def energies(robot: RobotModel, y: Array, yd: Array) -> Array:
    """Return kinetic and potential energy in the rows of a motion [J], shape (k,).

    Its joints have one freedom each, the first of them is the axis, and its springs are between bodies.
    """
    tree = opened(robot)
    frames, M = frames_batch(tree, y), mass_matrices(tree, y)
    total = 0.5 * np.einsum("ki,kij,kj->k", yd, M, yd)
    for number, link in enumerate(robot.links):
        total -= link.mass * (frames[:, number, :3] @ np.array([*link.com, 1.0])) @ robot.gravity
    for spring in robot.springs:
        ends = [
            np.broadcast_to(point, (len(y), 3))
            if link == BASE_LINK
            else frames[:, link, :3] @ np.array([*point, 1.0])
            for link, point in ((spring.link_1, spring.point_1), (spring.link_2, spring.point_2))
        ]
        length = np.linalg.norm(ends[1] - ends[0], axis=1)
        total += 0.5 * spring.stiffness * (length - spring.free_length) ** 2
    return np.asarray(total)


_CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1), (0, 1, 1), (0, 0, 1))
_AXES = ((0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0))


def bricard() -> RobotModel:
    """Return Bricard's mechanism: five rods of 1 m and 1 kg along edges of a cube, six turning joints.

    R. Bricard, Leçons de cinématique II, 1927; problem A04 of the library of the IFToMM. Counting freedoms
    says that it is rigid; it moves, as one row of its cut depends on the others.
    """
    frames = []
    for corner, axis, beyond in zip(_CORNERS, _AXES, (*_CORNERS[1:], _CORNERS[0]), strict=True):
        along = np.subtract(beyond, corner)
        frame = np.eye(4)
        frame[:3, 0], frame[:3, 2] = along, axis
        frame[:3, 1], frame[:3, 3] = np.cross(axis, along), corner
        frames.append(Pose.from_matrix(frame))
    joints = tuple(
        joint(f"{k + 1}", frames[k] if k == 0 else frames[k - 1].inverse() @ frames[k], k - 1)
        for k in range(5)
    )
    body = Link(1.0, np.array([0.5, 0.0, 0.0]), np.diag([0.0, 1.0, 1.0]) / 12.0)
    cut = LoopCut(4, frames[4].inverse() @ frames[5], BASE_LINK, frames[5], PIN)
    return mechanism(joints, (body,) * 5, (cut,), 0.0, DOWN)
