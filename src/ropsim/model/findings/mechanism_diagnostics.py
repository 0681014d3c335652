"""Errors of the joints, axes, couplings and loops of a mechanism (codes X828 to X839, X977)."""

from ropsim.core import Severity, define

SAME_NAME = define(
    "X830",
    "joint-name-twice",
    Severity.ERROR,
    "two joints of a mechanism have one name",
    """
Limits, findings and channels name a joint, so each joint of a mechanism has a name of its own. Mechanisms
that are joined to one (an arm on a track, an arm beside a turntable) name their external axes `E1`, `E2` and
so on.
""",
)

BAD_PARENT = define(
    "X831",
    "joint-on-impossible-link",
    Severity.ERROR,
    "a joint is carried by a link that does not exist, that comes later, or that hangs on it",
    """
The bodies of a mechanism form a tree: each joint is carried by the base (`BASE_LINK`, -1) or by the link of a
joint before it in the list. So the joints are listed from the base outwards, and no chain of parents comes
back to where it began. A closed chain is cut open: one of its joints is described by a `LoopCut` instead.

Links are numbered from 0 in the model; messages count them from 1, as joints are named.
""",
)

NO_AXES = define(
    "X832",
    "mechanism-without-axes",
    Severity.ERROR,
    "a mechanism has no driven joint",
    """
The axes of a mechanism are what programs and controllers command. A thing without any is no mechanism but a
fixed object of the cell.
""",
)

BAD_AXIS = define(
    "X833",
    "impossible-axis",
    Severity.ERROR,
    "an axis drives a joint that cannot be driven",
    """
An axis drives one joint with one freedom (revolute, prismatic or screw). A coordinate that follows others by
a coupling has no drive of its own, and no joint is driven twice. A joint with more freedoms is driven through
joints of one freedom each, one behind the other.
""",
)

BAD_COUPLING = define(
    "X834",
    "impossible-coupling",
    Severity.ERROR,
    "a coupling names a coordinate that does not exist, or one that is coupled already",
    """
A coupling determines one coordinate as a linear function of others, with finite factors, and each coordinate
is determined once. Coordinates are counted from 0, joint by joint: a revolute joint has one, a spherical one
three, a fixed one none.
""",
)

COUPLING_CIRCLE = define(
    "X835",
    "couplings-in-a-circle",
    Severity.ERROR,
    "coordinates are coupled to each other in a circle",
    """
A coordinate that follows another one which in turn follows the first, or that follows itself, is not
determined by the axes: the couplings are singular. Write each dependent coordinate as a function of the axes.
""",
)

FREE_COORDINATE = define(
    "X836",
    "coordinate-nobody-moves",
    Severity.ERROR,
    "a coordinate is neither an axis nor coupled, and no loop determines it",
    """
Passive joints are those whose coordinates follow from others: by a coupling, or by a closed chain
(`LoopCut`). In a mechanism without closed chains every coordinate has to be an axis or to have a coupling,
also each of those of a joint with more freedoms.
""",
)

BAD_CUT = define(
    "X837",
    "impossible-loop-cut",
    Severity.ERROR,
    "a loop cut is not between two links of its mechanism",
    """
A `LoopCut` names two different bodies of the mechanism, the base or links, and a frame on each; the two
frames coincide in the directions that the cut joint holds.
""",
)

LOOP_TWICE = define(
    "X838",
    "loop-described-twice",
    Severity.ERROR,
    "a closed chain is described twice",
    """
A loop is described either exactly by couplings (a parallelogram, whose angles are linear functions of each
other) or by one cut. Two cuts of the same place, or a cut of a loop whose coordinates are all axes or
coupled, would constrain it twice.
""",
)

BAD_SPRING = define(
    "X977",
    "impossible-spring",
    Severity.ERROR,
    "a spring has a number that no spring can have, or is fastened to nothing",
    """
A `Spring` is fastened to points of two different bodies of its mechanism, the base or links; a `JointSpring`
acts on one coordinate of a joint, counted from 0 joint by joint. Stiffness, damping and free length are 0 or
more: a negative stiffness would push away from rest, a negative damping would drive the motion.

Look for a sign, or for the number of the link: links are numbered from 0 in the model; messages count them
from 1, and 0 is the base.
""",
)

MIXED_AXES = define(
    "X829",
    "external-axis-coupled-to-arm",
    Severity.ERROR,
    "a joint follows external axes and axes of the arm together",
    """
Inverse kinematics leaves external axes where they are and solves the arm. A joint that follows both by a
coupling belongs to neither of the two.
""",
)

BAD_EXTERNAL = define(
    "X828",
    "impossible-external-axis",
    Severity.ERROR,
    "a robot names an external axis that it does not have, or has no arm where one is needed",
    """
`external` holds numbers of axes, counted from 0, each once. The others are those of the arm, which inverse
kinematics moves. A robot with external axes only has no arm: a station of one axis is moved by its
coordinate, and has no inverse kinematics.
""",
)

LOOP_NOT_SIMULATED = define(
    "X839",
    "loop-not-simulated",
    Severity.ERROR,
    "something is asked for that goes along one open chain, and this mechanism has closed chains",
    """
Mechanisms with `LoopCut`s have poses, Jacobian, inverse kinematics and dynamics, and run under controllers.
Some special algorithms work on the chain from the base to the interface as if each joint were a linear
function of the axes; in a closed chain it is not. A chain whose coordinates are linear functions of the axes,
such as a parallelogram, can be described by couplings, for which all of them work.
""",
)
