"""Diagnostics of limits of arms and drives in simulated runs."""

from ropsim.core import Severity, define

EFFORT_EXCEEDED = define(
    "S730",
    "effort-exceeded",
    Severity.WARNING,
    "a drive gave more torque than the joint allows",
    """
The simulated drive torque at a joint was higher than the limit in the arm's model. A real arm would trip its
drive, or wear early. Lower the speed or acceleration on the line that is named, or the payload.
""",
)

CURRENT_EXCEEDED = define(
    "S731",
    "current-exceeded",
    Severity.WARNING,
    "a motor drew more current than its amplifier allows",
    """
The simulated motor current was higher than the amplifier's limit in the arm's model. Lower the acceleration
on the line that is named, or the payload. An amplifier that limits the current itself is told by S739.
""",
)

SPEED_EXCEEDED = define(
    "S732",
    "speed-exceeded",
    Severity.WARNING,
    "a joint moved faster than its limit",
    """
The attained speed of a joint was higher than the limit in the arm's model by more than the two per cent that
a servo may overshoot. Lower the speed on the line that is named.
""",
)

LIMIT_OVERRUN = define(
    "S733",
    "limit-overrun",
    Severity.ERROR,
    "a joint overran its limit while it was servoed",
    """
The reference stayed inside the limits of the joint, the attained coordinate did not: the servo overshot. Keep
more distance from the limit, or move more slowly towards it.
""",
)

VOLTAGE_SATURATED = define(
    "S734",
    "voltage-saturated",
    Severity.WARNING,
    "an amplifier was at its voltage limit",
    """
The controller asked for more voltage than the amplifier has, for more than a twentieth of a second in all.
While that lasts the arm does not follow its reference. Lower the speed or acceleration on the line that is
named.
""",
)

FOLLOWING_ERROR = define(
    "S735",
    "following-error",
    Severity.ERROR,
    "a joint fell far behind its reference",
    """
A joint was more than 0.1 rad (5.7°), or 0.1 m, away from its reference. Real controllers stop with a fault
long before that. The drives are too weak for the speed, acceleration or payload on the line that is named,
or the gains of the joint controller are wrong.
""",
)

CURRENT_LIMITED = define(
    "S739",
    "current-limited",
    Severity.WARNING,
    "an amplifier held the current of its motor at its limit",
    """
The amplifier lets no more current through its motor than its `max_current`. The motor took that much, to a
hundredth, for more than a twentieth of a second in all. It then gives the largest torque that it has, and
where that is not enough the arm falls behind its reference. Lower the acceleration on the line that is named,
or the payload.

An amplifier that does not limit the current is told by S731, how far beyond its limit it went.
""",
)

COMMAND_SATURATED = define(
    "S740",
    "command-saturated",
    Severity.WARNING,
    "an ideal drive was at its largest torque or force",
    """
The controller asked for more torque or force than the drive may give, for more than a twentieth of a second
in all. While that lasts the arm does not follow its reference. Lower the speed or acceleration on the line
that is named, or give the drive a larger `max_effort`.
""",
)

DRIVE_EXCEEDED = define(
    "S744",
    "drive-limit-exceeded",
    Severity.WARNING,
    "a quantity of a drive was beyond its limit",
    """
A quantity of a drive that is held to a limit, such as the stroke of a valve, was beyond it. The message names
the quantity, the limit stands in the model of the drive. Lower the speed or acceleration on the line that is
named, or the payload.
""",
)

DRIVE_SATURATED = define(
    "S745",
    "drive-saturated",
    Severity.WARNING,
    "a quantity of a drive stayed at its limit",
    """
A quantity of a drive, which the message names, was at its limit for more than a twentieth of a second in all.
While that lasts the arm may not follow its reference. Lower the speed or acceleration on the line that is
named, or the payload.
""",
)

PAYLOAD_EXCEEDED = define(
    "S749",
    "payload-exceeded",
    Severity.WARNING,
    "an arm carried more than its maker allows",
    """
Tool and parts together were heavier than the rated payload in the arm's model. The drives of a simulation may
move more than bearings and gears bear. Take a lighter tool, fewer parts at a time, or an arm with a greater
payload. Makers allow less where the centre of mass is far from the flange: models have no load diagrams.
""",
)

OIL_TORN = define(
    "S752",
    "oil-torn",
    Severity.WARNING,
    "the oil in a chamber of a hydraulic drive would have been pulled apart",
    """
In a chamber of a hydraulic motor or cylinder the computed pressure fell below that of no pressure at all,
1.01 bar under that of the air. Oil does not bear that: it gives way, fills with vapour and air, and later
the chamber closes with a blow. The simulation goes on as if the oil held, so what it says of this axis from
then on is too good. It comes from a load that runs ahead of its valve, as an arm that is lowered fast, and
from valves that close quickly.

**How to mend it.** Slow the arm down on the line that is named. If the arm has valves that keep its load from
running away, or refill a chamber, the drive of the model has none; a higher return pressure stands for them.
""",
)

SUPPLY_DRAINED = define(
    "S755",
    "supply-drained",
    Severity.WARNING,
    "a supply of oil has less than its accumulator is precharged to, or than its return",
    """
Valves take more oil from a supply than its pump gives, and what its accumulator had stored is used up. Below
the precharge of the gas no oil is left in the accumulator: nothing but the pump and a little oil in the line
holds the pressure, which then falls within milliseconds and comes back as quickly. Below the pressure of the
return the oil runs backwards through open valves, and drives brake or push the wrong way. The simulation goes
on by the same equations; what it says of the axes at this supply from then on is that of a plant that has
too little oil.

**How to mend it.** Move fewer axes at once or more slowly on the line that is named, or give the supply in
the robot file a greater `pump_flow` or `gas_volume`, or a lower `precharge`.
""",
)

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

The message also says how long the line takes, and how long it would take at its speed all the way; where
ramps at stops are a part of that, they are named apart.

Speeding up from a stop and slowing down to one counts as meant, so a short approach to a fine stop is not
reported. Neither is a line that loses less than 0.1 s or 2 % of the time in motion; the report shows the
speed that each line reaches, and what limits it. A chain of many such lines is reported once, at its first
line.

**How to mend it.** The hint says what helps. It names `path_acceleration` or `path_jerk` only where the line
was planned again with more of it and became quicker, within the limits of the joints. A curve through very
many points bends anew at each of them; fewer points, or a chain of lines with a zone, are often quicker.
""",
)
