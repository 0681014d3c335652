"""Findings on the speed of moves in a run that has ended."""

from ropsim.core import Severity, define

SLOWER_THAN_PROGRAMMED = define(
    "S727",
    "slower-than-programmed",
    Severity.HINT,
    "a line is flown slower than its program says, and that costs time",
    """
The tool does not come to the programmed speed of a line, or is slower on a good part of it. The message says
how much of the speed is reached, and which limit counts there:

* **path acceleration, path jerk**: the move is too short to speed up and slow down between its corners;
* **rotation speed, rotation acceleration**: the tool turns far on a short way;
* **zone**: the corner is sharp for its zone, so that the tool has to slow down for it;
* **bend**: an arc or a curve is tight; turning off takes acceleration and jerk across the path;
* **a joint**: it is at its speed, acceleration, jerk or torque; if a singularity is near, it is named;
* **external axis**: an axis that goes along does not move faster;
* **look-ahead**: the controller knows too little of the path ahead, and has to be able to stop there.

Speeding up from a stop and slowing down to one counts as meant, so a short approach to a fine stop is not
reported. Neither is a line that loses less than 0.1 s or 2 % of the time in motion; the report shows the
speed that each line reaches, and what limits it. A chain of many such lines is reported once, at its first
line.

**How to mend it.** The hint says what helps. Where the speed does not matter, program the one that is
reached: the line takes no longer then, and often less.
""",
)
