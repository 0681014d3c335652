"""Diagnostics of calibration (X800, X888, X889, X894, X898, X899)."""

from ropsim.core import RopsimError, Severity, define

BAD_TRACE = define(
    "X888",
    "bad-trace",
    Severity.ERROR,
    "a logged trace that cannot be read",
    """
`ropsim calibrate` reads a table as text: a line for each sample, first the time, then the coordinate of every
axis, in the order of the robot or under its name. Comma, semicolon or tab stand between the columns; with
semicolon and tab, numbers may have a decimal comma. Units stand in the header, such as `time [s];j1
[deg];j2 [deg]`; without one times are seconds, turning axes degrees and sliding ones millimetres.

    time [s],j1 [deg],j2 [deg],j3 [deg]
    0.000,0.000,75.000,-180.000
    0.008,0.002,75.001,-179.998

The time must rise from line to line, at 20 to 2000 samples per second. Lines with an empty or undefined
value are left out, as long as they are less than a tenth of all.
""",
)

OTHER_TRACE = define(
    "X889",
    "trace-does-not-match",
    Severity.ERROR,
    "a trace that is not of this program on this robot",
    """
The places where the program stands were looked for among the places where the trace stands, in order. Too
few of them are there to compare times: the trace is of another program, of another robot, of one move
only, or its units are not those of its header. A trace of a part of the program will do where two motions in
it are of the program, and half of all that it has.

Log the whole program, from its start position to its end, and give the very text that ran on the robot. A
robot whose joints count the other way round, or from zeros that are more than 20° or 200 mm away, has to be
converted first. Smaller shifts are found where at least four different places, and most of those of the
program, are there with the same shift (X800).
""",
)

NOT_IN_TRACE = define(
    "X894",
    "sequence-not-compared",
    Severity.ERROR,
    "moves of the program that are not compared with the trace, so no limits are written",
    """
Limits hold for the whole program. Where one of its motions cannot be compared, the trace does not tell
whether they are right there: the motion that is left out may be the very one that matters, such as a chain
of moves with zones. The finding names each of them with its reason. `ropsim calibrate` shows what the other
motions tell and writes nothing; the errors that it states are those over all time that the robot moved in
the trace, these motions included.

A motion that *goes another way in the trace than it is planned* was programmed with other points, zones or
orientations on the robot. One that *stands on its way* was held, or slowed down to a stop. One that *hangs
on a sensor* (`until`, `track`) ends elsewhere each time: log a program without it. One that *is not in the
trace* or *lies behind its end* was not logged.

**How to mend it.** Log the whole program once more, at full override and without holds, and give the very
text that ran on the robot. Limits may be put into the cell file by hand all the same.
""",
)

ZERO_BESIDE = define(
    "X800",
    "joint-zero-beside",
    Severity.WARNING,
    "a joint of the trace stands beside the program by the same amount everywhere",
    """
At its stops the robot stands where the program does, but for one joint, which is off by the same amount at
most of them. Times are compared all the same: what lies between two stops is shifted to where the program has
it. Yet the robot that was logged does not stand where it is simulated: a degree of a shoulder is a
centimetre or more at the tool.

Either the joint counts from another zero than the model, and robot or model is to be adjusted, or the points
were corrected on the robot and not in the program.
""",
)

MISFIT = define(
    "X899",
    "trace-not-reached",
    Severity.WARNING,
    "a motion lasts longer or shorter than in the trace, even with the best limits",
    """
No limits of joints and paths make this motion last as long as in the trace, to two per cent. Robots slow
down for reasons that are not limits: heat, near singularities, a maker's motion law with other ramps, or a
speed that the program gives and the robot does not keep.

The other limits are still the best ones; the finding names the line and how much is left.
""",
)

GAPS = define(
    "X898",
    "trace-with-gaps",
    Severity.HINT,
    "lines of a trace were left out",
    """
Lines with an empty or undefined value, or with too few columns, were left out; the motion between their
neighbours is taken as straight. A few do no harm. Many make speeds and accelerations less certain: look at
the logger.
""",
)


class CalibrationError(RopsimError):
    """A trace that cannot be used; carries the finding."""
