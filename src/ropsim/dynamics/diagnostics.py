"""What can be wrong with calls of the dynamics."""

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

TOO_MANY_JOINTS = define(
    "M571",
    "chain-too-long",
    Severity.ERROR,
    "the arm has more joints than straight-line code is generated for",
    """
The dynamics of an arm are written as one straight piece of code for that arm. Its length grows with the
square of the number of joints, so arms beyond the limit are refused instead of compiled for minutes.

Split the chain, or leave out joints that do not move.
""",
)

ENTRY_NOT_FINITE = define(
    "M572",
    "model-number-not-finite",
    Severity.ERROR,
    "a mass, length or constant of the robot model is NaN or infinite",
    """
Masses, centres of mass, inertias, placements and drive constants become numbers in the code that is
generated for the arm. One that is not finite would make every result NaN.

Look at the model with `ropsim robot show NAME` and give the missing number; where nothing is published, give
an estimate and mark it `estimated`.
""",
)


class StateShapeError(RopsimError):
    """An array has the wrong shape."""


class ChainTooLongError(RopsimError):
    """The arm has too many joints for generated code."""


class ModelNumberError(RopsimError):
    """The robot model holds a number that is not finite."""
