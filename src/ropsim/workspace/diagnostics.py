"""Errors in requests of a workspace (codes W101 to W129)."""

from ropsim.core import Diagnostic, RopsimError, Severity, define

NO_WRIST_CENTRE = define(
    "W101",
    "no-wrist-centre",
    Severity.ERROR,
    "the last three axes of the arm do not meet in a point",
    """
The wrist centre is the point in which the last three axes meet; it stands still while they turn. SCARA arms,
palletizers and arms whose wrist is offset, such as those of Universal Robots, have none. Ask for the
workspace of the flange, or of the TCP of a tool.
""",
)

UNLIMITED_SLIDE = define(
    "W102",
    "workspace-without-bounds",
    Severity.ERROR,
    "an axis that slides has no limits, so that the workspace has none",
    """
A workspace is computed within the limits of the joints. For a turning axis without limits one turn is taken,
as more of it changes nothing; a slide without limits reaches to any distance. Give it `limits` in the robot
file.
""",
)

FIRST_AXIS = define(
    "W103",
    "first-axis-does-not-carry",
    Severity.ERROR,
    "the first axis neither turns nor shifts all of the arm",
    """
The reachable volume is computed as what the first axis sweeps: it must turn the whole arm about a fixed line
or shift it along one. In this mechanism it does neither, as couplings or a screw mix it with others. Single
points can be asked for all the same: `ropsim robot workspace NAME --points FILE`.
""",
)

ASSUMED_TURN = define(
    "W104",
    "one-turn-assumed",
    Severity.HINT,
    "an axis has no limits, and one whole turn was taken for its range",
    """
More than a turn of an axis changes no pose, so the workspace is that of the axis without limits. If its real
range is smaller, such as for cables, give it `limits` in the robot file: the workspace is then smaller, too.
""",
)


NO_DEXTERITY = define(
    "W105",
    "dexterity-not-computed",
    Severity.HINT,
    "the dexterous workspace of this arm is not computed",
    """
In which directions a tool can point is found by inverse kinematics with all branches, and turned about the
first axis. Arms that are solved numerically, arms with external axes and arms whose first axis slides are
left out; their reachable workspace is computed all the same.
""",
)

NO_SURFACE = define(
    "W106",
    "workspace-without-surface",
    Severity.ERROR,
    "the point moves in a plane, or nowhere: its workspace has no surface",
    """
A surface is written of workspaces that have a volume. A planar arm reaches an area; its border is in the
report (`--report FILE.html`), and in Python `ropsim.workspace.volume.outline` returns it.
""",
)

BAD_POINT = define(
    "W110",
    "bad-task-point",
    Severity.ERROR,
    "a line of a table of points cannot be read",
    """
A table of task points is a text with a line for each point, cells separated by commas, semicolons or tabs:

```
name, x, y, z, roll, pitch, yaw
pick, 500, 200, 50, 180, 0, 0
place, 450, -300, 120
```

Lengths are in millimetres and angles in degrees, unless titles tell another unit, as `x [m]`, or the second
line does. The tool is turned by roll about the fixed x axis, by pitch about y and by yaw about z; where these
cells are empty any orientation will do. With `pitch` before `roll` the table is a
[list of points](P148.md) of a project, and its angles are those of the approach direction: pitch 90 is down.
Each number must be finite, and behind the last
column there must be nothing: the first line tells whether there are orientations. Wrong lines are left out,
and the command ends with 1.
""",
)

NO_POINTS = define(
    "W111",
    "no-task-points",
    Severity.ERROR,
    "there are no points to look at",
    """
The table has no line with a point, or the program no location that is known without running it on the robot.
See [W110](W110.md) for the form of a table.
""",
)


POINTS_LEFT_OUT = define(
    "W112",
    "points-left-out",
    Severity.HINT,
    "moves of a program are no points of the task",
    """
`--points` with a project takes the points to which its program moves, from a dry run. Joint coordinates
belong to the arm that they were written for; where external axes stand, or a frame moves with one, a point
says nothing of another place of the base.
""",
)


class WorkspaceError(RopsimError):
    """A workspace that cannot be computed."""


def no_wrist_centre(name: str) -> Diagnostic:
    """Return the finding that an arm has no wrist centre."""
    return NO_WRIST_CENTRE.at(
        None,
        f"the last three axes of `{name}` do not meet in a point",
        hint="ask for the workspace of the flange",
    )


def unlimited_slide(name: str, joint: str) -> Diagnostic:
    """Return the finding that a slide has no limits."""
    return UNLIMITED_SLIDE.at(
        None,
        f"axis `{joint}` of `{name}` slides and has no limits, allowed is a finite range",
        hint="give it limits in the robot file",
    )


def first_axis(name: str, joint: str) -> Diagnostic:
    """Return the finding that the first axis sweeps nothing."""
    return FIRST_AXIS.at(
        None,
        f"axis `{joint}` of `{name}` neither turns the whole arm about a line nor shifts it along one",
        hint="ask for single points with --points",
    )


def assumed_turns(name: str, joints: tuple[str, ...]) -> Diagnostic:
    """Return the hint that one turn was taken for axes without limits."""
    words = ", ".join(f"`{joint}`" for joint in joints)
    return ASSUMED_TURN.at(
        None, f"no limits: axis {words} of `{name}`; one turn, -180° to 180°, was taken for its range"
    )


def no_dexterity(name: str) -> Diagnostic:
    """Return the hint that the dexterous workspace is not computed."""
    return NO_DEXTERITY.at(
        None,
        f"the dexterous workspace of `{name}` is not computed: it needs all branches of inverse kinematics "
        "in closed or algebraic form, and a first axis that turns the arm",
    )
