"""Findings about moves: targets that cannot be reached and values that no motion can have."""

from ropsim.core import Severity, define

OUT_OF_REACH = define(
    "M501",
    "out-of-reach",
    Severity.ERROR,
    "the arm is too short or too long for the command pose",
    """
No set of joint coordinates, whatever its limits, brings the tool to the command pose: the point lies outside
the reach of the arm, or too near to its base.

Where an arm has a *wrist*, its position decides, not that of the tool: a long tool pointing towards the base
brings the wrist closer, one pointing away moves it out.

Of a target with [free](../language.md#free-orientation) orientation the message says how far the arm stays
away from it, where it has fewer than six axes; others keep the orientation of the start of the move.

**How to mend it.** Move the target or its task frame, turn the tool, or move the base of the robot. Look at
the units first: `0.7` under `units mm` is less than a millimetre, `700` under `units m` seven hundred metres.

```task
mov (2000, 0, 500)      # M501 for an arm that reaches 0.9 m
```
""",
)

OUT_OF_TASK_SPACE = define(
    "M530",
    "out-of-task-space",
    Severity.ERROR,
    "an arm with few joints cannot take the command pose, however near it is",
    """
A pose has six coordinates, three for the position and three for the orientation. An arm with fewer than six
joints can choose fewer: a SCARA arm places its tool anywhere in its reach and turns it about the vertical,
but cannot tilt it; a planar arm of two links moves in one plane, and its orientation there follows from the
position. The message says how far the pose is from what the arm can take.

Where the orientation is [free](../language.md#free-orientation) the position counts, and the message says how
far the target is beside the plane in which two links move, or beside another surface or line of places of the
TCP. Nothing is projected: what is farther away than rounding, 0.01 mm, is refused.

**How to mend it.** Where only the position counts, write `free` behind the target. Else give the pose the
orientation that the arm has (`ropsim robot fk` prints it), turn the tool or the task frame, or give the
target in joint coordinates.

```task
lin (850, 0, 700)        # M530 for two links whose flange turns unevenly on the way
lin (850, 0, 700) free   # reached
lin (850, 5, 700) free   # M530: 5 mm beside the plane of the arm
```
""",
)

POSE_NOT_FOUND = define(
    "M581",
    "pose-not-found",
    Severity.ERROR,
    "no joint coordinates were found for the command pose, though there may be some",
    """
The arm belongs to no class whose inverse kinematics has all branches (M550): its joint coordinates are
searched numerically from many starting points. No search ended at the command pose. Unlike M501 that does not
prove that the pose is out of reach; the message says how far the nearest pose is that was found.

**How to mend it.** Where the pose is reached, give the target in joint coordinates, or move to a
configuration next to it first: the search also starts where the arm stands. Else move the target or its task
frame.
""",
)

JOINT_OUT_OF_RANGE = define(
    "M502",
    "joint-out-of-range",
    Severity.ERROR,
    'the command pose needs a joint angle beyond the joint\'s limits ("out of range angle value")',
    """
The position is within the reach of the arm, but every posture (shoulder, elbow, wrist) that reaches it
turns at least one joint beyond its limits. The message names the joint, the angle it would need and the
limit of the posture that comes nearest; the note counts the postures.

For a target in joint coordinates it names the first joint whose coordinate is out of range.

**How to mend it.** Move or turn the target or its task frame, choose a tool that is mounted differently, or
give the target in another orientation. From the second pass of a loop on, the message says in which pass it
happened: the earlier passes are fine.
""",
)

UNKNOWN_TOOL = define(
    "M506",
    "unknown-tool",
    Severity.ERROR,
    "the tool in force is neither in the cell nor defined by the program",
    """
A move was commanded with a tool for which neither `cell.toml` has a table `[tools.NAME]` nor the program
gives a pose. Without the pose of the tool at the mechanical interface nobody knows where its TCP is.

**How to mend it.** Correct the name or add the tool to `cell.toml`.
""",
)


WRONG_NUMBER_OF_JOINTS = define(
    "M508",
    "wrong-number-of-joints",
    Severity.ERROR,
    "a target in joint coordinates has another number of values than the arm and its external axes have",
    """
Joint coordinates are given for all joints of the arm, from the base to the tip, then for its external axes.

**How to mend it.** Give one value per joint. A program written for another arm must be taught again: joint
coordinates do not carry over from arm to arm, poses do.
""",
)

WRONG_NUMBER_OF_EXTERNAL = define(
    "M520",
    "wrong-number-of-external-values",
    Severity.ERROR,
    "a location has another number of values of external axes than the robot has such axes",
    """
A location may say where the external axes stand when the tool is there: `external (800)` for a track. It
gives a value for each external axis of the robot that runs the program, E1 first. The message says how many
the robot has.

**How to mend it.** Give one value for each external axis, or leave `external` out: then the axes stay where
they are. A robot gets external axes by `track` and `positioner` in the cell file.
""",
)

BAD_MOTION_VALUE = define(
    "M509",
    "bad-motion-value",
    Severity.ERROR,
    "a coordinate, speed or share of a move is not a number that a motion can have",
    """
Coordinates must be finite and below 1000 m, speeds and accelerations above 0, shares of the limits above 0
and at most 1, a zone 0 or more.

**How to mend it.** Look where the value is computed: a division by zero gives `NaN` or infinity, a
forgotten unit gives a number a thousand times too large.
""",
)

POSTURE_CHANGE = define(
    "M511",
    "posture-change",
    Severity.HINT,
    "a PTP move changes the posture of the arm",
    """
Within its limits the arm cannot reach the target in the posture (shoulder, elbow, wrist) it has at the
start of the move, so another one is taken: the one that needs the shortest time. The arm may sweep through
unexpected space, and later LIN moves start in the new posture.

**How to mend it.** If it is not wanted, move the target, or add a PTP move to joint coordinates where the
posture may change safely.
""",
)

UNKNOWN_FRAME = define(
    "M512",
    "unknown-frame",
    Severity.WARNING,
    "the task frame in force is not in the cell and has no pose of its own",
    """
The program works in a named task frame that `cell.toml` does not define, and the program gives it the pose
of the base frame. The move is made in base coordinates, which is seldom what was meant.

**How to mend it.** Correct the name or add `[frames.NAME]` to `cell.toml`.
""",
)

NO_ARM = define(
    "M518",
    "no-arm",
    Severity.ERROR,
    "a pose or a line is asked of a station that has no arm",
    """
A station with `mechanism` in place of `robot` has one axis, which slides or turns. It has no tool centre
point that could be brought to a pose or along a line; its axis is moved by its coordinate. The move is
skipped.

**How to mend it.** Write `mov joints(500)`: a length for a slide, an angle for a turntable, in the units of
the program. Such targets can have names: `loc loaded = joints(500)`.
""",
)

FRAME_OF_OTHERS = define(
    "M519",
    "frame-of-others",
    Severity.ERROR,
    "a move in a task frame that another station moves",
    """
The task frame lies on the positioner, or on the carriage of the track, of another station. Where it is when a
move ends is known to the controller of that station only, so this one cannot plan a move in it. The move is
skipped.

**How to mend it.** A station can work in frames that stand still and in those on its own external axes. Let
the other station turn its positioner to a known place and tell so by a signal, and give this one a frame in
the world that describes the fixture there.
""",
)

MOVE_TOO_LONG = define(
    "M513",
    "move-too-long",
    Severity.ERROR,
    "a single move would take longer than ten minutes",
    """
The speed is so low, or the way so long, that this one move would last more than 600 s. A mistaken unit is
more likely than such a move.

**How to mend it.** Raise the speed, or cut the way into several moves.
""",
)

WRONG_PROFILE_REQUEST = define(
    "M540",
    "wrong-profile-request",
    Severity.ERROR,
    "a profile was asked for with values that no motion can have",
    """
The Python functions of `ropsim.motion` need finite distances of 0 or more, and finite limits above 0; the
pieces of a way need such lengths and bounds, too. Programs never lead here: their values are checked first
(M509).
""",
)
