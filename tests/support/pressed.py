"""Arms that are pressed on blocks: a gantry of two slides, and a block below it."""

import numpy as np

from ropsim.controller import CompiledLaw, LawTraits
from ropsim.model import (
    Box,
    Cell,
    Cylinder,
    FixedObject,
    Joint,
    JointType,
    Link,
    MeantContact,
    Rates,
    RobotModel,
    Shape,
    Solid,
    Sphere,
    Tool,
    ideal_drive,
)
from ropsim.spatial import Array, Pose
from support.cells import one_station
from support.servo_cases import controller

MASS = 2.0
"""Of what goes down [kg]."""
GRAVITY = 9.81
RADIUS = 0.01
"""Of the ball, whose centre is the tool centre point [m]."""
BALL, PIN = Sphere(RADIUS), Cylinder(RADIUS, 2.0 * RADIUS)
BLOCK = FixedObject("block", Pose(np.array([0.0, 0.0, -0.05])), (Shape(Box((1.0, 0.2, 0.1))),))
"""Its top is at z = 0."""
_ALONG_X = Pose(np.zeros(3), np.array([np.sqrt(0.5), 0.0, np.sqrt(0.5), 0.0]))


def gantry(gravity: float = GRAVITY) -> RobotModel:
    """Return an arm whose first axis goes along x of the world, the second one along z."""
    wide = (-1.0, 1.0, 5.0, 50.0, 500.0)
    joints = (
        Joint("x", JointType.PRISMATIC, _ALONG_X, 0.0, *wide),
        Joint("z", JointType.PRISMATIC, _ALONG_X.inverse(), 0.0, *wide),
    )
    small = np.eye(3) * 1e-3
    links = (Link(1.0, np.zeros(3), small), Link(MASS, np.zeros(3), small))
    falling = np.array([0.0, 0.0, -gravity])
    return RobotModel(
        "gantry", "Gantry", joints, links, (ideal_drive(), ideal_drive()), np.zeros(2), gravity=falling
    )


def pressed_cell(
    *contacts: MeantContact,
    solid: Solid = BALL,
    start: tuple[float, float] = (0.0, 0.02),
    hz: int = 1000,
    robot: RobotModel | None = None,
    objects: tuple[FixedObject, ...] = (BLOCK,),
) -> Cell:
    """Return a cell with a gantry whose tool is a solid about the mechanical interface."""
    return one_station(
        "pressed",
        robot or gantry(),
        controller(2, Rates(hz)),
        tools={"tip": Tool("tip", shapes=(Shape(solid),))},
        default_tool="tip",
        start=np.array(start),
        objects=objects,
        contacts=contacts,
    )


def contact(stiffness: float = 1e5, damping: float = 200.0, friction: float = 0.2) -> MeantContact:
    """Return the contact of the tool with the block."""
    return MeantContact("press", "tip", ("block",), stiffness, damping, friction, 5e-3)


def springs(stiffness: Array, damping: Array, lift: float = 0.0) -> CompiledLaw:
    """Return a law that holds each axis at its reference by spring and damper, the second one lifted [N]."""
    source = (
        "def law(par, state, ref, meas, load, aux, out):\n"
        "    for k in range(2):\n"
        "        out[k] = par[0, k] * (ref[0, k] - meas[0, k]) - par[1, k] * meas[1, k] + par[2, k]\n"
    )
    numbers = np.array([stiffness, damping, [0.0, lift]])
    return CompiledLaw("springs", source, ("k", "c", "lift"), numbers, LawTraits())
