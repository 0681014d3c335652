"""Findings about straight lines: where the joints cannot follow the tool."""

from ropsim.core import Severity, define

JOINT_LIMIT_ON_LINE = define(
    "M503",
    "joint-limit-on-line",
    Severity.ERROR,
    "on the way of a LIN move a joint would pass its limit",
    """
Start and end of the line are within reach, but in the posture that the arm has at the start a joint would
turn beyond its limit on the way. A LIN move cannot change the posture: it would have to leave the line.

The message says which joint, and at which share of the way the limit is met.

**How to mend it.** Start the line in another posture or with other turns of the wrist (a PTP move to joint
coordinates before it), make the line shorter, or use `mov` where the path does not matter.
""",
)


JUMP_ON_LINE = define(
    "M505",
    "singularity-on-line",
    Severity.ERROR,
    "on the way of a LIN move the joints would have to jump",
    """
The line runs through a singularity of the arm, where the joints cannot follow the tool at any speed:

* **wrist**: joint 5 is stretched, the axes of joints 4 and 6 are in line;
* **elbow**: upper arm and forearm are stretched;
* **shoulder**: the wrist centre lies above or below the axis of joint 1.

An arm with fewer than six axes is stretched or folded there, or has its TCP on an axis: beyond that place it
could go on only in another branch.

**How to mend it.** Turn the tool a little, shift the line, or use `mov` for this part. A controller
with `orientation = "wrist angles"` passes the singularity of the wrist; the tool then turns between both ends
as the wrist leads it.
""",
)


OTHER_JOINTS_AT_LINE_END = define(
    "M514",
    "other-joints-at-line-end",
    Severity.HINT,
    "a LIN move to joint coordinates ends at the pose but with other joint coordinates",
    """
A LIN move keeps its posture. The target was given in joint coordinates of another posture (or with other
turns), so the arm reaches the pose that belongs to them, but with different joint coordinates.

**How to mend it.** Use `mov` to reach exactly these joint coordinates.
""",
)

NO_ARC = define(
    "M566",
    "no-arc",
    Severity.ERROR,
    "start, via point and end of a CIRC move do not make an arc",
    """
Three different points that do not lie on one line have one circle through them. Here two of them are the same
point, or all three lie on a line (nearly: the circle would be larger than any cell). The move is skipped.

**How to mend it.** Give a via point well between start and end, beside the line through them. A full circle
has an angle: `circ via b to c angle 360 deg`. Where the way is straight, use `lin`.
""",
)

NO_SPLINE = define(
    "M567",
    "no-spline",
    Severity.ERROR,
    "the points of a SPLINE move do not make a curve",
    """
A curve needs at least two different points with finite coordinates, and neighbours that differ. Where the
tool turns far between two points that are near to each other, it would have to turn so quickly there that it
turned on for more than a full turn before and behind them. The move is skipped.

**How to mend it.** Leave out points that are the same as the one before them. Where the tool turns far within
a short way, put the two points further apart, spread the turn over more points, or turn the tool with a PTP
move.
""",
)

POSTURE_OUT_OF_REACH = define(
    "M568",
    "posture-out-of-reach",
    Severity.ERROR,
    "the target is not reached in the posture and with the turns that the program asks for",
    """
`config (…)` asks for a posture and `turns (…)` for whole turns of the axes. The arm reaches the target, but
not in that way within its joint limits. The move is skipped.

**How to mend it.** The hint names the postures in which the target is reached, the nearest to that asked for
first: write one of them, or leave out the word or the turn that matters least. `ropsim robot ik` lists all
postures of a pose with what exceeds which limit.
""",
)

OTHER_POSTURE = define(
    "M569",
    "path-ends-in-other-posture",
    Severity.WARNING,
    "a path of the tool ends in another posture, or with other turns, than the program asks for",
    """
On a line, an arc or a curve the arm keeps its posture, and its axes turn as the path wants it. The location
at its end asks for another posture or other turns: the pose is reached, but not in that way.

**How to mend it.** Take up the posture with `mov` before the path begins.
""",
)

POSTURE_FOR_LATER = define(
    "M585",
    "posture-for-later-move",
    Severity.HINT,
    "a PTP move takes another posture than the nearest one, so that a later path can be followed",
    """
On a line, an arc or a curve the arm keeps the posture in which it begins. In the posture that is nearest to
the start of this PTP move, a joint would meet its limit on a later path, would have to jump, or would slow a
part of the path down to less than a quarter. So the move takes another one, or other turns of a joint: that
in which most moves can be made, then that which changes least of the posture, then that with room to the
joint limits and the least time. Looked at are the moves that are flown without a stop, and the paths behind
that stop up to the next PTP move, or to where the program needs the arm to stand: for a gripper, an output,
an input that is read, a wait.

**How to mend it.** Nothing has to be mended. Where the arm must not come in this posture, name one with
`config` at the location, or shift the later move.
""",
)

POSTURE_IN_THE_WAY = define(
    "M589",
    "posture-in-the-way",
    Severity.WARNING,
    "a PTP move asks for a posture in which a later path cannot be followed",
    """
On a line, an arc or a curve the arm keeps the posture in which it begins. This PTP move takes the posture, or
the turns, for which the program asks with `config` or `turns`. On a later path a joint then meets its limit
or would have to jump, and that path is refused; without the wish the arm would take another posture, in which
it can be followed. The message marks the path, and says what is wrong there.

**How to mend it.** Leave the wish out, ask for the posture that the hint names, or shift the later path.
""",
)

NO_WRIST_ANGLES = define(
    "M586",
    "no-wrist-angles",
    Severity.ERROR,
    "the angles of the wrist cannot lead the tool along a line, an arc or a curve",
    """
A controller with `orientation = "wrist angles"` turns the last three joints from their angles at the start
to those at the end, on a curve from point to point, while the first three keep the TCP on its way. That needs
six turning joints of which the last three meet in one point; shoulder and elbow must be at every point and at
the end as they are at the start, within the limits of the joints, and the first three joints must reach every
place between with the angles that the wrist has there. The message names the point, or the place beyond which
that is not so. External axes may move on the way. The move is skipped.

**How to mend it.** Shift the point or turn the tool there where a joint is named that would be beyond its
limit. Use `mov` where the path does not matter, or give the controller `orientation = "fixed axis"`.
""",
)

PATH_NOT_CORRECTED = define(
    "M587",
    "path-not-corrected",
    Severity.ERROR,
    "a sensor is to correct a path of which the arm cannot shift the tool alone",
    """
`track` shifts a path along an axis of the tool while it is made. The arm does that, with external axes that
stand. Here they move along with the path, as the target gives other values for them or lies in a frame that
they carry; or a planner of your own has made a path of the joints; or the orientation of the target is free
and the arm has fewer than six axes. The move is skipped.

**How to mend it.** Bring the external axes where they are needed with a move before, and let the move that
follows the sensor leave them there.
""",
)
