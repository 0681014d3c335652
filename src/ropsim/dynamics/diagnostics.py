"""Errors in calls of the dynamics."""

from ropsim.core import RopsimError, Severity, define

WRONG_SHAPE = define(
    "M570",
    "state-shape-mismatch",
    Severity.ERROR,
    "an array does not have one number per joint",
    """
The functions of `ropsim.dynamics` take float arrays of fixed shapes: `q`, `qd`, `qdd` and `tau` have one
number per joint, in the order of the joints; `wrench` has six (force, then moment). There is no broadcast.

Call the function once per state, or reshape the array:

```python
robot = ropsim.robots.load("puma560")
ropsim.dynamics.gravity(robot, [0.0, 0.8, 3.1, 0.0, 0.8, 0.0])  # six joints, six numbers
```
""",
)

WRONG_COUNT = define(
    "M573",
    "arm-count-mismatch",
    Severity.ERROR,
    "an arm has no joints, or not one link and one drive for each joint",
    """
An arm needs at least one joint. Every joint moves one link, and where drive data exist every joint has its
own drive, so the lists of a robot model have the same length; drives may be left out altogether.
""",
)

IMPOSSIBLE_DRIVE = define(
    "M572",
    "drive-impossible",
    Severity.ERROR,
    "a constant of a drive is not positive, or its blocks do not go together",
    """
The constants of a drive become numbers in the code that is generated for the arm. A stiffness, resistance or
torque constant of 0 would divide by zero there; a motor that takes a voltage does nothing behind an amplifier
that gives a current.

Look at the drive with `ropsim robot show NAME` and correct the constant; where nothing is published, give an
estimate and mark it `estimated`.
""",
)


WITHOUT_MASSES = define(
    "M590",
    "arm-without-masses",
    Severity.ERROR,
    "the dynamics of an arm whose links have no masses",
    """
Many models of arms hold lengths and limits only: makers publish no masses. Torques of such an arm are not
zero, they are unknown, so the functions of `ropsim.dynamics` refuse it. Kinematics, planning and kinematic
runs need no masses.

Give the robot file `links` with masses, centres of mass and inertias, or `mass`, that of all moving links,
from which the others are estimated. `ropsim robots` tells which built-in arms have masses.
""",
)

AXIS_WITHOUT_INERTIA = define(
    "M591",
    "axis-without-inertia",
    Severity.ERROR,
    "an axis moves nothing that has an inertia, so a torque gives it no finite acceleration",
    """
Forward dynamics solves M(q)·q̈ = τ - h for the accelerations. Where everything behind an axis has neither mass
nor inertia, and its drive no rotor, the mass matrix M is singular, and any torque would accelerate the axis
without bound. A mass that lies exactly on the axis of a turning joint does not help: it needs an inertia.

Give the last links an inertia, or their drives the inertia of their rotors. Links of MJCF whose masses were
to follow from meshes have none: `ropsim robot estimate FILE robots/NEW.stp --payload KG` adds them by stated
rules, and `ropsim run --kinematic` needs none.
""",
)


LOOP_OUT_OF_REACH = define(
    "M592",
    "closed-chain-out-of-reach",
    Severity.ERROR,
    "closed chains of an arm cannot be closed with its axes where they are to be",
    """
The coordinates that closed chains determine follow from those of the axes. Some coordinates of the axes are
beyond what the links reach: a rod is too short, or a chain is in a dead centre on the way. There is no torque
for such a position, as there is no such position.

Take coordinates that the chains can follow on the straight way of the axes from the home position, or limit
the axes to these.
""",
)


class LoopError(RopsimError):
    """Closed chains do not close."""


class MissingMassError(RopsimError):
    """An arm lacks the masses that its equations of motion need."""


class StateShapeError(RopsimError):
    """An array has the wrong shape."""


class JointCountError(RopsimError):
    """The lists of the robot model do not have exactly one entry per joint."""


class ModelNumberError(RopsimError):
    """A drive of the robot model cannot exist, or an inertia is none that a body has."""
