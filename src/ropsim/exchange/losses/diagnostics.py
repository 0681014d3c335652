"""Findings on a robot in URDF, xacro or MJCF (codes X979 to X992, X998, X999)."""

from ropsim.core import Severity, define

NOT_XML = define(
    "X980",
    "robot-file-not-xml",
    Severity.ERROR,
    "a robot file is not well-formed XML",
    """
URDF, xacro and MJCF are XML: every element that is opened is closed, attributes stand in quotation
marks, and there is one outermost element. The place is where the reader could not go on; the mistake is
there or before it.
""",
)

XML_REFUSED = define(
    "X981",
    "robot-file-refused",
    Severity.ERROR,
    "a robot file is larger than is read, or defines entities",
    """
Files of robots come from elsewhere, so what they can cost is bounded: their size, how deep elements
stand in each other, how many there are, how many attributes one has and how long these are, and how much
macros and included files may bring. A document type (`<!DOCTYPE`) and entities of its own are refused:
nobody needs them in a robot file, and a few lines of them can grow to gigabytes or name other files of
the computer.

Take the document type out. A robot that is really larger than the bounds carries more than an arm; cut
it.
""",
)

ELEMENT_MISSING = define(
    "X982",
    "robot-element-missing",
    Severity.ERROR,
    "an element or attribute that a robot needs is not there",
    """
A joint needs a name, a type, and the two links that it joins; one that slides needs its `limit`. A geometry
needs its measures. Nothing is guessed in their place, since a guessed
frame or limit moves a real robot to the wrong place. Numbers that a file may leave out have the values
that its format states.
""",
)

BAD_NUMBER = define(
    "X983",
    "robot-number-unusable",
    Severity.ERROR,
    "a number in a robot file is none, or one that cannot be",
    """
Numbers are decimal and finite, as many as the attribute has: three of a position, four of a quaternion.
An axis and a quaternion have a direction, so they are not zero; masses are not negative; a lower limit
is not above its upper limit; measures of solids are positive. `nan` and `inf` are refused wherever they
stand.

Angles are radians in URDF, and degrees or radians in MJCF, as its `compiler` says: degrees if it says
nothing.
""",
)

SAME_ENTITY = define(
    "X984",
    "robot-name-twice",
    Severity.ERROR,
    "two links or two joints of a robot file have one name",
    """
Links and joints are referred to by their names, so each link has a name of its own among the links, and
each joint among the joints. A name comes twice most often where a macro is called a second time with the
same prefix.
""",
)

UNKNOWN_ENTITY = define(
    "X985",
    "robot-name-unknown",
    Severity.ERROR,
    "a robot file, or a question about it, names what it does not hold",
    """
A joint names its parent and its child link, a mimic joint the joint that it follows, a body its class of
defaults, a mesh its asset: all of these are in the same file. The tip that is asked for is a link of it.
""",
)

BROKEN_TREE = define(
    "X986",
    "robot-tree-broken",
    Severity.ERROR,
    "the links of a robot file are not one tree",
    """
Every link but one is the child of exactly one joint. The one that is not is the root, the base of the
robot. Two roots are two robots, or a joint is missing between them; a link with two parents, or a circle
of joints, is a closed chain, which URDF cannot hold: describe the driven tree, and let the joints of the
chain follow by `mimic`. Joints that follow each other in a circle move nothing.
""",
)

JOINT_IMPOSSIBLE = define(
    "X987",
    "robot-joint-impossible",
    Severity.ERROR,
    "a joint is of a type that no axis of an arm can be, or there are too many",
    """
The axes of an arm turn or slide: `revolute`, `continuous` and `prismatic` in URDF, `hinge` and `slide`
in MJCF. A `floating` or `planar` joint lets a body move about freely, a `ball` joint has three freedoms
that no single drive moves, and the arm stands on its base: where that base moves, it is a track or a
carriage with joints of its own. A robot has at least one joint that moves on the way to its tip, and at
most as many as the message says.
""",
)

TIP_UNCLEAR = define(
    "X988",
    "robot-tip-unclear",
    Severity.ERROR,
    "a robot file has several ends, and nobody says which one carries the tool",
    """
An arm is the chain from the base to its tip, the link with the mechanical interface. Where a file
branches, as at a gripper or in a robot with two arms, the tip is the link that is named `tool0`,
`flange` or so; else the end behind the most joints. Of several links that are fixed behind the last joint
it is the one that is called `ee`, `hand`, `link8` or so, else an empty frame at a distance; cameras, sensors
and collision geometry are none. Where two are alike in that, name the tip.
""",
)

DOUBTFUL_BODY = define(
    "X989",
    "robot-body-doubtful",
    Severity.WARNING,
    "the mass or inertia of a link is not that of a real body",
    """
Masses in robot files are often placeholders: the same for all links, zero, or larger than the whole
robot is by its data sheet. Moments of inertia of a body obey A + B >= C and fit its size: the radius of
gyration that they give is no larger than the reach of the robot. Files are read with the numbers that
they have; simulated torques are as good as these are.

Look the masses up in the data sheet. Without a mass behind an axis there is no dynamics: the robot moves
as it is commanded.
""",
)

LIMIT_UNKNOWN = define(
    "X990",
    "robot-limit-unknown",
    Severity.HINT,
    "a robot file does not say a limit of a joint, and an estimate stands in its place",
    """
Planning needs the greatest speed, acceleration and jerk of each axis. URDF has the speed, and since
version 1.2 acceleration and jerk; MJCF has none of them. A speed or an effort of 0 stands for unknown in
many files. What is not known is estimated: speed half a turn in a second (0.5 m/s for slides), full speed
after 0.25 s, full acceleration after 0.1 s; an unknown effort is no limit. Each note names the joints that
lack a limit and what is used instead; the model marks these numbers as `estimated`.

Write the numbers of the data sheet into the file: cycle times follow from them.
""",
)

MESH_MISSING = define(
    "X991",
    "robot-mesh-missing",
    Severity.WARNING,
    "a file that a robot file names is not there, or not inside of the given folders",
    """
Meshes and included files are named as `package://name/path`, `$(find name)/path` or by a path beside the
robot file. A package is a folder with a `package.xml`; it is looked for in the folders above the robot file
and below these, inside of the project. One that stands elsewhere is given: `--package NAME=DIR`, in a cell
file `package`. Nothing else is looked at. A shape whose mesh is not there is left out; an included file that
is not there is an error.
""",
)


XACRO = define(
    "X992",
    "xacro-not-expanded",
    Severity.ERROR,
    "a macro, property, argument or expression of a xacro file cannot be expanded",
    """
Xacro files are expanded before they are read: arguments, properties, macros with parameters and blocks,
`if` and `unless`, included files, and expressions in `${...}` and `$(...)`. Expressions know numbers,
texts, lists and dictionaries, the operators of Python, indices, slices and comprehensions, the methods of
texts and of dictionaries that change nothing, and the functions of mathematics; nothing else can be called,
and no file is read but those inside of the given folders. The message names what is not carried out, such
as `lambda`, `$(env ...)` or a pattern of several files. How deep macros call each other and how much they
make is bounded (X981).
""",
)

DOUBTFUL_RANGE = define(
    "X999",
    "robot-range-doubtful",
    Severity.WARNING,
    "the range of a joint is not known, is in another unit, or cannot be used up",
    """
A joint that turns has a lower and an upper limit, unless it is `continuous`. Exporters of CAD programs write
0 for both where nobody has entered them, and some files leave the `limit` out. Such a joint is read as one
that turns without end: postures are allowed that the real joint does not reach.

Write the limits of the data sheet into the file. A joint that slides without limits, or with two that are
the same, is an error (X982, X983).

Limits such as -170 and 170 are degrees that were not converted: URDF has radians. They are read as the format
says. And where a joint follows another one (`mimic`), its own limits can leave less of the range of that one
than the file says; the message has the range that is left.
""",
)

WEAK_EFFORT = define(
    "X979",
    "robot-effort-too-small",
    Severity.WARNING,
    "the greatest effort of a joint cannot carry the weight of the arm",
    """
In some posture within the limits of the joints, gravity alone asks more of a joint than the greatest effort
that the file says. Such numbers are placeholders, such as 1 or 10 for each joint, or the masses are. With
them no motion can be planned, so the joint is read without such a limit; the model marks that as `estimated`.

Look the torques of the axes up, or the masses. An arm whose weight is balanced by springs or by a
counterweight has a small effort for a reason; robot files have no place for the balance.
""",
)

XACRO_MESSAGE = define(
    "X998",
    "xacro-message",
    Severity.WARNING,
    "a xacro file reports something about itself while it is expanded",
    """
Xacro files can report what they miss: `${xacro.warning('...')}` and `${xacro.error('...')}`. The text is
that of the file; each one is reported once. The robot is read. With `xacro.fatal` a file refuses itself,
which is an error (X992).
""",
)
