"""The kinds of mistakes in robot files (X900 to X909, X915, X916, X927); all TOML files: `tomltext`."""

from ropsim.core import Severity, define

NO_JOINTS = define(
    "X900",
    "robot-without-joints",
    Severity.ERROR,
    "a robot file has no row of joints, or too many",
    """
A robot file needs `joints`, a list with a row for each joint from the base on:

```toml
joints = [
  { a = 0, alpha = 90, d = 400, limits = [-170, 170], speed = 120 },
  { a = 500, alpha = 0, d = 0, limits = [-90, 110], speed = 120 },
]
```

An arm has at most 32 of them.
""",
)

JOINT_NAME_TWICE = define(
    "X901",
    "joint-name-taken",
    Severity.ERROR,
    "two joints of a robot file have one name",
    """
Messages, plots and recordings speak of joints by their names, so each needs its own. Without `name` the
joints are called `1`, `2` and so on, which may be the name that another one was given.
""",
)

SOME_MASSES = define(
    "X902",
    "mass-of-some-links",
    Severity.ERROR,
    "some links have a mass and others have none",
    """
Dynamics need the masses of all links. Give each row of `links` its `mass` (0 where a paper says so), or
give the mass of all moving links together, of which the links without a mass of their own get shares:

```toml
mass = 28                      # kg, of all that moves
```

Leave out all masses to simulate without dynamics.
""",
)

DRIVES_WITHOUT_MASSES = define(
    "X903",
    "drives-without-masses",
    Severity.ERROR,
    "a robot file has drives and no masses",
    """
What a motor does depends on the masses that it moves, so drives without masses say nothing. Give `links` with
their masses, or `mass`, the mass of all moving links together; or leave `drives` out.
""",
)

WRONG_RATIO = define(
    "X905",
    "ratio-of-nought",
    Severity.ERROR,
    "a gear ratio, or the lead of a screw, is 0 or next to it",
    """
The `ratio` of a drive is the motor's angle over the coordinate of the joint: radians per radian, and
radians per metre for sliding joints. It may be negative, where the motor turns the other way, and cannot be
0, nor smaller than 10⁻⁶; the `lead` of a ball screw is 10⁻⁵ m or more for a turn, to either side.
""",
)

MASS_USED_UP = define(
    "X906",
    "mass-used-up",
    Severity.ERROR,
    "the links have more mass than the whole arm",
    """
`mass` is that of all moving links together, `total_mass` that of the arm with its base. The links that have a
mass of their own have more than that, so nothing is left for the others.
""",
)

ANOTHER_REACH = define(
    "X907",
    "another-reach",
    Severity.WARNING,
    "the arm does not reach as far as its file says",
    """
`reach` is what the data sheet gives: how far the wrist centre or the mechanical interface comes from the
axis of joint 1. With the lengths of the table it comes elsewhere, by more than a tenth. A length is wrong,
`a` and `d` of a row are exchanged, or the table is of the other form: `"modified"` instead of `"standard"`,
or the other way round.
""",
)

BAD_BODY_NAME = define(
    "X927",
    "unknown-body",
    Severity.ERROR,
    "a robot file speaks of a joint or body that is not there, or not of that kind",
    """
Joints hang on bodies, chains are closed between bodies, springs are fastened to bodies: a body is named by
the joint that moves it, and the one that stands still is `"base"`. A joint hangs on the base or on the body
of a row before it. Axes and joints that follow others have one freedom.
""",
)

NOT_IN_ROBOT_FILE = define(
    "X908",
    "not-in-robot-file",
    Severity.WARNING,
    "a robot has something that a robot file cannot say",
    """
A robot file describes a chain of turning and sliding joints by a table, and any other mechanism by the frames
of its joints (`convention = "frames"`). Couplings of joints with several freedoms have no place in it, and
neither have drives of other kinds than those of its rows. Rods and cranks without mass, which follow the axes
of a chain and are only drawn, are left out: the arm moves without them as with them. Numbers beyond those
that a robot file may have, such as links of a kilometre, are not written either. The finding says what is
left out, or why there is no file at all.
""",
)

NO_ESTIMATE = define(
    "X909",
    "no-estimate-of-dynamics",
    Severity.ERROR,
    "masses and drives of a robot cannot be estimated",
    """
Masses follow from the mass of the whole arm, or from its rated payload and its lengths; torque limits from
what gravity asks with the rated payload, rotors and friction from torque limits and speeds. All of it is for
serial arms of turning and sliding joints and for palletizers only. An arm with drives keeps them.

**How to mend it.** Give the mass or the payload that is missing: `--mass` and `--payload` of `ropsim robot
estimate`, or `total_mass` and `payload` in a robot file. The rules are in docs/explanation/estimates.md.
""",
)

BAD_COUPLED_ROW = define(
    "X915",
    "bad-coupled-row",
    Severity.ERROR,
    "a row of joints is coupled with something else than a joint before it",
    """
Some makers count a joint together with another one: joint 3 of a FANUC arm is told from the horizontal, and
where a parallelogram moves the forearm, axis 3 holds it against the column. The row of such a joint says with
which joints, and by which factor their coordinates are added to its own:

```toml
{ name = "J3", a = 600, alpha = 180, limits = [-180, 264], coupled = { J2 = 1 }, joint_limits = [-90, 270] }
```

`coupled` names joints of rows before it that turn if it turns, or slide if it slides. `limits` are those of
the coordinate as the maker tells it, `joint_limits` those of the joint itself; the latter have a meaning only
beside `coupled`.
""",
)

BAD_LINKAGE = define(
    "X916",
    "bad-linkage",
    Severity.ERROR,
    "a cylinder cannot move its joint over the range that the joint has",
    """
A cylinder lies between a pin on the body that carries its joint and a pin on the link. Its length follows
from the coordinate of the joint, and the lever of its force is the distance of the axis from the line
through both pins. Where pins and axis are in line, at a dead centre, it has no lever; beyond that it would
turn the joint the other way. Such a place cannot be within the `limits` of the joint, and over these the
cylinder has to be as long as `retracted_length` at least and `stroke` longer at most. The message says where
the dead centre is, or how long the cylinder would have to be.

**How to mend it.** Look at both pins: `carrier_pin` counts in the frame of the table before the joint (for
the first joint frame 0), `link_pin` in the frame of its own row, both in metres. Then narrow the `limits` of
the joint, or correct `retracted_length` and `stroke`.
""",
)
