"""Errors in the kinematics (codes M550 to M569)."""

from ropsim.core import RopsimError, Severity, define

NO_CLOSED_FORM = define(
    "M550",
    "no-closed-form",
    Severity.HINT,
    "the arm has no closed-form inverse kinematics, poses are solved numerically",
    """
Inverse kinematics is computed in closed form, with all its branches, for these classes of arms:

* **spherical wrist**: six revolute joints, axes 2 and 3 parallel and at right angles to axis 1, axes 4, 5
  and 6 meeting in one point at right angles; most six-axis industrial arms are built so;
* **three parallel axes**: six revolute joints, axes 2, 3 and 4 parallel and at right angles to axis 1, axes
  4, 5 and 6 at right angles, axes 5 and 6 meeting; most arms made to work beside people are built so;
* **SCARA**: four joints with parallel axes, three that turn and one that slides;
* **planar two-link**: two revolute joints with parallel axes;
* **level wrist**: palletizers with four axes whose rods keep the flange level;
* **S-R-S**: seven revolute joints, axes 1, 2 and 3 meeting in one point at right angles, axes 5, 6 and 7 in
  another one; branches for each swivel angle, the turn of the elbow about the line from shoulder to wrist.

A model may deviate from its class by 0.001 rad and 0.01 mm, as rounded files do; the answers are then
polished on the model itself. `ropsim robot show NAME` says which class an arm is in, or which condition of
each class it misses.

Six revolute joints of any other geometry (**general six-axis**) are solved algebraically: the joint
coordinates are eigenvalues of a matrix, all branches are found, and only names are missing. So are seven
(**general seven-axis**), for each value of one joint that is held, and two to five (**general few-axis**)
in the poses that they can take.

Any other arm is solved numerically from many starting points: each answer is checked like every other one,
but there may be further ones that were not found, and they have no names such as `left-up-flip`. Where
answers are beyond joint limits only, a second search keeps to the limits. A move keeps to the answer nearest
to where the arm stands; a pose without an answer was not found (M581), not proven to be out of reach.
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
ropsim.kinematics.chain.forward(robot, [0.0] * robot.n)
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


LOOP_OPEN = define(
    "M553",
    "closed-chain-open",
    Severity.ERROR,
    "a closed chain cannot be closed in the home position",
    """
The two frames of a cut cannot be brought together while the axes stand at home: a rod is too short or too
long, or a frame of the cut is wrong. The message says how far they stay apart, in metres or radians,
whichever is more.
""",
)

LOOP_STUCK = define(
    "M554",
    "closed-chain-holds-axis",
    Severity.ERROR,
    "a closed chain holds an axis where it is",
    """
The mechanism has fewer freedoms than axes: moved by a thousandth of a radian or a millimetre to either side
of home, the axis opens a closed chain. Often a cut holds directions that the joint there leaves free, such as
all six of a pin that turns; or a joint is missing.
""",
)

LOOP_LOOSE = define(
    "M555",
    "closed-chain-loose",
    Severity.ERROR,
    "closed chains leave a coordinate free that no axis moves",
    """
The mechanism has more freedoms than axes: a joint that is neither an axis nor coupled is not determined by
the closed chains either, such as the turn of a rod about its own length between two ball joints. Counted is
the rank at the home position and beside it.
""",
)


LOOP_LOCKS = define(
    "M556",
    "closed-chain-locks",
    Severity.ERROR,
    "a closed chain locks on the way of a move",
    """
At a dead centre a closed chain cannot go on: two of its bars lie in one line, or a cylinder is drawn out to
the end of its triangle. Between positions that can be reached both, the straight way of the axes may lead
over such a place. The message says how far the move comes. Give a point on the way round, or move along a
line of the tool.
""",
)

LOOP_CHANGES = define(
    "M557",
    "closed-chain-changes-assembly",
    Severity.ERROR,
    "a closed chain would come to another assembly",
    """
A closed chain can often be assembled in several ways, such as a four-bar with its rocker up or down. Poses
are those of the assembly in the home position. Along this move, which goes round a place where two
assemblies meet, the chain would come to the other one, and stand elsewhere than its axes say. Give a point on
the way that stays on this side of the dead centre.
""",
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
