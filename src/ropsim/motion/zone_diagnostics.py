"""Findings about zones, and about motions retimed for joint limits."""

from ropsim.core import Severity, define

ZONE_STOPS = define(
    "M560",
    "zone-not-flown",
    Severity.HINT,
    "a zone or a via point is not flown, the arm stops there",
    """
A zone lets the arm leave its path near a point and go on to the next one without a stop; a via point is
passed without one. Both need a next move that is known in time. The arm stops all the same where the program
ends or has to wait for the arm: before a gripper, an output, an input that is read, a wait; where the path
turns back on itself; where the arm is at the target of the move already, or the next move has the same one;
where the controller may not look far enough ahead; and, at corners of more than a right angle and next to
moves in joint space, where the zone is so small that to slow down for its bend, or for what joints can do
there, takes longer than to stop. The message says which of these it is. Each reason is reported once for a
line, with the number of passes, or of the points of a list, at which the arm stops, and where the first of
them is. That a list of points ends with the program, or begins where the arm stands, is no loss and is not
reported.

**How to mend it.** Give the move `fine` if the stop is meant. Otherwise set the output on the path
(`at 5 mm before end do set valve on`), read the input earlier, shift the point, or give a larger zone.
""",
)

ZONE_CLIPPED = define(
    "M562",
    "zone-clipped",
    Severity.HINT,
    "the zone is larger than half of a move that meets there, a smaller one is flown",
    """
Zones may not overlap: each takes at most half of the move before and half of the move behind its point. The
message gives the zone that is flown. Where a move in joint space takes part (`mov` next to `lin`), each of
the two moves has its own half, and these are the most that is flown: the next motion begins while the one
before ends, both parts within the zone last equally long, and the move with the slower part is left nearer to
its point. The report gives that distance. Such a zone is reported where it is larger than both halves.

**How to mend it.** Give the zone that is flown, or put the points further apart.
""",
)

UNKNOWN_PATH = define(
    "M561",
    "unknown-path",
    Severity.ERROR,
    "the controller does not make paths of this kind",
    """
An instruction asks for a kind of path that the path planner of this station does not know. The move is
skipped.

**How to mend it.** Use one of the kinds that the message names.
""",
)

LINES_AS_CURVE = define(
    "M576",
    "lines-as-curve",
    Severity.HINT,
    "short lines one after the other are flown as smooth curves within their zones",
    """
Lines that are shorter than the way of speeding up and slowing down, with zones between them, are flown as one
curve of the tool, as the compressors of controllers do it: were each corner rounded by itself, the tool would
slow down at each. The message gives the number of lines, and how far the tool is from them at most, in
distance and in orientation, on the curves and in the zones of the corners between them; it is never farther
than the zones allow. Sharp corners keep their own zones, and so do points where no curve stays within the
zone. Long lines stay lines. Triggers act where the curve passes
their points.

**How to mend it.** Nothing is wrong. Give smaller zones where the tool has to be nearer to the points, larger
ones where it has to be quicker, and `fine` where it has to stop. Were the points made from a smooth curve, a
`spline` through fewer of them says the same. Where your controller has no compressor, `short_lines = "zones"`
in `[controller]` of the cell file gives each point its own blend, and the time of that.
""",
)

SLOWED = define(
    "M563",
    "slowed-by-joint",
    Severity.HINT,
    "on a part of the path the tool is slower than commanded, because a joint cannot do more",
    """
The commanded speed, acceleration or a corner asks a joint for more speed, acceleration, jerk or torque than
it has. The controller slows down there, on the path. The message gives the joint, the share that is left of
the planned speed, and when: the share of the duration of the move as planned. The planned speed is that of
the tool without regard to joints; it is less than the commanded one where the path is too short to reach it,
or bent. A line that loses next to no time is not reported. Cycle times
are those of the slowed motion. Slowing down there, and speeding up again, keeps the limits of the joints, and
those of the tool that the program gives.

Near a singularity joints turn fast however slowly the tool goes; the message names it: of the wrist (axes 4
and 6 in line), of the elbow (arm stretched or folded), or of the shoulder (wrist above axis 1).

**How to mend it.** On a line, an arc or a curve, the controller of an arm with spherical wrist passes the
singularity of the wrist at full speed with `orientation = "wrist angles"`. Else, where the time matters,
change the posture or the place of the path, or give the joint less to do: a lower path speed over the whole
move is often as quick or quicker, because it need not brake.
""",
)

SINGULARITY_HINTS = {
    "wrist": 'an arm with spherical wrist passes it at full speed with `orientation = "wrist angles"` in '
    "`[controller]`; else turn the tool a little, shift the path, or use `mov` for this part",
    "elbow": "shift the path to where upper arm and forearm are not stretched, or use `mov` for this part",
    "shoulder": "lead the path past the axis of joint 1 at a distance, or use `mov` for this part",
}
"""The next step, by the singularity that slows a path."""

BEYOND_LIMITS = define(
    "M564",
    "beyond-limits",
    Severity.ERROR,
    "the motion asks more of a joint than it can do at any speed",
    """
However slowly the arm moves, the joint would exceed its limit at this place, such as a torque limit that is
too low to carry arm and part there. The move is skipped.

**How to mend it.** Bring the part nearer to the axis of the joint, take a lighter one, or look at the limits
in the model.
""",
)

TRIGGER_OFF_PATH = define(
    "M565",
    "trigger-beside-path",
    Severity.WARNING,
    "an output is to be set at a place that lies before the start or behind the end of its move",
    """
`at … before end do` and `at … after start do` set an output while the arm moves. The way of the move, or its
time, is shorter than what is given: the output is set at the start or at the end instead. A move with a zone
begins and ends in the middle of the rounded corner.

**How to mend it.** Give less, or put the output on the move before or behind.
""",
)

SPEED_BEYOND_ARM = define(
    "M588",
    "speed-beyond-arm",
    Severity.HINT,
    "a commanded path speed is beyond what the arm can do in any posture",
    """
With all axes at their speed limits, and the arm stretched so that their motions add up, the tool would still
be slower than commanded. The move is made as fast as joints and path allow, and its time is true. Often the
unit is another one than meant: 15000 mm/s are 15 m/s.

**How to mend it.** Give the speed that is meant. Where the move is to be as fast as the arm can, any speed a
little below the one in the message does that without this hint.
""",
)
