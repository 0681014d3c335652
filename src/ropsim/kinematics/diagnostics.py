"""What can go wrong in the kinematics (codes M550 to M569)."""

from ropsim.core import RopsimError, Severity, define

NO_CLOSED_FORM = define(
    "M550",
    "no-closed-form",
    Severity.ERROR,
    "the arm is outside the class with closed-form inverse kinematics",
    """
Inverse kinematics is computed in closed form for arms with six revolute joints whose axes 2 and 3 are
parallel and at right angles to axis 1 and whose axes 4, 5 and 6 meet in one point at right angles (a
spherical wrist). Most six-axis industrial arms are built so. The message says which of these conditions
the arm misses.

Joint targets and everything that needs forward kinematics only still work for such an arm.
""",
)

WRONG_SHAPE = define(
    "M551",
    "array-shape-mismatch",
    Severity.ERROR,
    "an array has the wrong shape",
    """
Joint coordinates have one entry per joint, shape (n,); many of them form the rows of a matrix, shape (k,
n). Homogeneous matrices have the shape (4, 4), many of them (k, 4, 4).

```python
ropsim.kinematics.forward(robot, [0.0] * robot.n)
ropsim.kinematics.forward_batch(robot, np.zeros((100, robot.n)))
```
""",
)

NOT_FINITE = define(
    "M552",
    "kinematic-value-not-finite",
    Severity.ERROR,
    "a joint coordinate or a pose is not a finite number",
    """
NaN or infinity among the joint coordinates or in a pose has no place in space. Look at the computation
that made the value: often a division by zero or the inverse cosine of a number beyond 1.
""",
)


class NoClosedFormError(RopsimError):
    """The arm is outside the class with closed-form inverse kinematics (M550)."""

    def __init__(self, robot: str, reason: str) -> None:
        super().__init__(
            NO_CLOSED_FORM.at(
                None,
                f"no closed form for `{robot}`: {reason}",
                hint="use joint targets, or an arm with parallel axes 2 and 3 and a spherical wrist",
                data={"robot": robot, "reason": reason},
            )
        )


class ArrayShapeError(RopsimError):
    """An array has the wrong shape (M551)."""

    def __init__(self, array: str, found: tuple[int, ...], allowed: str) -> None:
        super().__init__(
            WRONG_SHAPE.at(
                None,
                f"`{array}` has the shape {found}, allowed is {allowed}",
                hint="give one coordinate per joint, one row per configuration",
                data={"array": array, "found": found, "allowed": allowed},
            )
        )


class NotFiniteError(RopsimError):
    """An array holds NaN, infinity or no numbers (M552)."""

    def __init__(self, array: str, found: str = "NaN or infinity") -> None:
        super().__init__(
            NOT_FINITE.at(
                None,
                f"`{array}` holds {found}, allowed are finite numbers",
                hint="check the computation before this call",
                data={"array": array},
            )
        )
