"""Findings in NIROX files (codes X950 to X957)."""

from ropsim.core import Severity, define

NOT_NIROX = define(
    "X950",
    "nirox-wrong-schema",
    Severity.ERROR,
    "an exchange file is not of the schema ROPSIM_NIROX_V1",
    """
The header of a NIROX file names its schema: `FILE_SCHEMA(('ROPSIM_NIROX_V1'));`. Files of AP242 with a
mechanism are read too, as far as their entities are known. A file that holds shapes only is no robot: name it
as the geometry of a link.
""",
)

IMPOSSIBLE = define(
    "X951",
    "nirox-impossible",
    Severity.ERROR,
    "a NIROX file describes a mechanism that cannot be, or one that the model does not hold",
    """
Every moving link is reached from the base by one way of joints, once the pairs of `LOOP_CUT` are taken out.
The two directions of a placement are not parallel. Axes are revolute, prismatic or screw pairs. A file keeps
to the schema and can still break these rules; the message names the instance.
""",
)

UNIT_UNKNOWN = define(
    "X952",
    "nirox-unit-unknown",
    Severity.ERROR,
    "a context declares no unit of length or angle, or one that is not understood",
    """
Lengths and angles of the kinematic part are in the units of the context of their representation: an SI unit
with a prefix, or one by conversion, such as degree or inch. A geometric context names both, as in

    #3=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2))REPRESENTATION_CONTEXT('',''));
""",
)

LOST = define(
    "X953",
    "nirox-loses",
    Severity.WARNING,
    "something of a robot does not go over into a NIROX file, or from the file into the model",
    """
A file can say more of a drive than the model computes with: efficiency, play of rigid gears, friction on both
sides of a gear, a cylinder that is not between the links of a revolute pair. What is not held has no effect
in a simulation. Where the robot is written into the file again it stays there, as long as what it belongs to
is unchanged. A robot can have what the schema has no place for, such as two closed chains between the same
two links.
""",
)

KEPT = define(
    "X954",
    "nirox-keeps",
    Severity.HINT,
    "entities of a NIROX file say nothing to this program and are kept",
    """
A later version of the schema, or another program, may add entities. They are kept beside the robot and
written again with it; what they refer to keeps its meaning.
""",
)

ESTIMATED = define(
    "X955",
    "nirox-limit-estimated",
    Severity.HINT,
    "a NIROX file does not say a limit of an axis, and an estimate stands in its place",
    """
Planning needs the greatest speed, acceleration and jerk of each axis. They stand in its DRIVE_TRAIN, or in
JOINT_LIMITS where it has none; a file of AP242 has none of them. Estimated are 3.14 rad/s or 0.5 m/s, full
speed within 0.25 s, full acceleration within 0.1 s. An axis that turns without end may turn 400 times.
""",
)

REFUSED = define(
    "X956",
    "nirox-not-written",
    Severity.ERROR,
    "a robot breaks a rule of the schema, and no file is written",
    """
What is written keeps to the schema. A negative mass, a limit of 0 or a number that is not finite does not;
`ropsim robot audit` says more of it.
""",
)

NO_MASS = define(
    "X957",
    "ap242-mass-not-given",
    Severity.HINT,
    "a file of AP242 does not give the masses of links, or not all of one",
    """
In AP242 products have masses, not links. Those of a link are read where an association leads from its
representation to the shape of a product (`KINEMATIC_LINK_REPRESENTATION_ASSOCIATION`), and properties of that
product say a mass measure, a representation called `centre of mass` with one point, and a
`MOMENTS_OF_INERTIA_REPRESENTATION` with three rows of three: the tensor about the centre of mass. Without
masses an arm moves as it is commanded; weights and torques need them.
""",
)
