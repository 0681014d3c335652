"""Diagnostics of simulated runs (S720 to S749, S751 to S754, S770); others have servo and inputs."""

from ropsim.core import Severity, define

NOT_IN_POSITION = define(
    "S720",
    "not-in-position",
    Severity.WARNING,
    "an arm did not come to rest at its target in time",
    """
A move ends when every joint is within `in_position` of its target. Here that did not happen within
`settle_timeout`; the program went on from where the arm was.

Usual reasons are dry friction that a low integral gain overcomes slowly, a payload that is heavy for the
drive, and a speed loop that oscillates. Look at the plot of following errors in the report.
""",
)

FAR_FROM_TARGET = define(
    "S724",
    "far-from-target",
    Severity.ERROR,
    "an arm came to rest far from its target, or did not come to rest at all",
    """
When `settle_timeout` was over, a joint was more than fifty times `in_position` away from its target, or the
tool more than 10 mm and a joint more than twice `in_position`: the drives do not carry the arm there. What
the program does after that is not what it says.

Usual reasons are gains that are far too low, a speed loop that oscillates, and a payload that is too heavy.
""",
)

GUARD_NOT_MET = define(
    "S746",
    "guard-not-met",
    Severity.HINT,
    "a motion came to its target without the condition that was to end it",
    """
`until` ends a motion where its condition comes true. Here the arm came to the end of the way and the
condition never did, and the motion has no `timeout` that would say that this may be. The program goes on at
the target as if it had found what it looked for.

Where contact or a part is looked for, let the target lie beyond the place where it is expected, and look at
the plot of the signal. A signal of the cell file needs `changes`, a device, a sensor or a key that makes it
true. Where the condition need not come true, write `timeout` with a time after which the motion ends all the
same.
""",
)

GUARD_HELD_BEFORE = define(
    "S754",
    "guard-held-before",
    Severity.WARNING,
    "the condition that ends a motion was true before the motion began",
    """
`until` ends a motion where its condition comes true. Here it was true already when the motion began, so the
arm did not go, or, where it came through a zone, braked at once. `store` holds the place where the motion
began. What a program looks for is not found in this way.

Let the signal become false before: wait for that (`wait until not part_ok`), go back from what is touched, or
give the motion another condition. Where it may be true at once, ask before: `if not part_ok then ...`.
""",
)

CORRECTION_AT_LIMIT = define(
    "S747",
    "correction-at-limit",
    Severity.WARNING,
    "the correction of a path by a sensor has reached its largest size",
    """
`track` shifts a path so that a sensor reads a value. The controller lets it shift the path by
`correction_size` at the most, 20 mm where the cell file says nothing else, and the sensor asks for more: from
there on the path goes beside the work by what is missing.

**How to mend it.** Look at the plot of the signal. Either the work lies elsewhere than the program says, so
correct the locations; or the sensor sees nothing, as beside an edge, and reads the end of its range; or the
sign is wrong: where the signal grows as the tool goes forward, write `along -z`. Where the shift is meant,
allow more in the cell file.
""",
)

NO_NUMBER_MEASURED = define(
    "S753",
    "no-number-measured",
    Severity.WARNING,
    "a sensor that corrects a path reads no finite number",
    """
The sensor of a move with `track` said that its reading is valid, and gave NaN or an infinite number. What is
no number is no measurement: as long as it lasts the path is not corrected any further, and keeps the shift
that it has. It is told once for a move, with the time at which it was seen first.

**How to mend it.** Let the sensor say that a reading is not valid where it has none (`Sample(valid=False)`),
and look at why it has none on this path.
""",
)

CORRECTION_STOPPED_BY_ARM = define(
    "S748",
    "correction-stopped-by-arm",
    Severity.WARNING,
    "the arm cannot follow the correction of a path by a sensor any further",
    """
A correction may take a tenth of the speed and of the acceleration of the joints, and none may come nearer
than 0.001 rad or 1 mm to a limit of its range. Here a joint was there, or the arm is near a singular posture
in which a small shift of the tool turns a joint a lot, or the arm has too few joints to shift the tool in
this direction without turning it. The correction grows no further; the path goes on. Where the joints cannot
even keep what the path is shifted by, within the fifth of their speed and three tenths of their acceleration
that the move leaves, the motion is braked and ends there, and the program goes on with the next one.

**How to mend it.** Take up another posture before the path, shift the work, or let the tool be corrected
along another of its axes.
""",
)

NOTHING_GRASPED = define(
    "S721",
    "nothing-grasped",
    Severity.WARNING,
    "a gripper closed where no part was",
    """
When a gripper closes, the part whose grasp point (the centre of its top) lies nearest to the TCP is taken,
if it is within the `capture` distance of the tool. Here no part was.

Compare the location in the program with the place of the part in `cell.toml`; a supply is empty after its
`count` parts.
""",
)

TOOL_CANNOT_GRASP = define(
    "S722",
    "tool-without-gripper",
    Severity.ERROR,
    "`open` or `close` without a gripper",
    """
`open` and `close` act on the gripper of the tool in force. Give the tool a line
`gripper = { open_time = 0.2, close_time = 0.2, capture = 5 }` in `cell.toml`, or put a tool with a gripper in
force with `set tool NAME`.
""",
)

RUN_TOO_LONG = define(
    "S723",
    "run-too-long",
    Severity.ERROR,
    "a program that does not end in reasonable time",
    """
A run is stopped after an hour of simulated time; the recording holds what happened until then. Cell programs
that run for ever, such as `while true`, are simulated pass by pass: give the loop a count.

The program of a station that has `serves = true` in the cell file may run for ever: it ends where it waits
for a signal when the programs of the others have ended. One that never looks at a signal
is stopped here, too.
""",
)

LONG_SETTLING = define(
    "S725",
    "long-settling",
    Severity.HINT,
    "settling after moves takes a good part of the cycle",
    """
A move ends when every joint is within `in_position` of its target. Here the arm waits for that after its
moves for more than 2 % of the cycle time in all, and after some of them for more than 20 ms. With better
gains the same program would be faster. The line named is that of the longest wait.

**How to mend it.** Gains in `[controller]` of the cell file replace the standard ones of a built-in arm:
leave them out and look again. Otherwise raise `kp` and `kv`, or `ki` where dry friction keeps the arm from
its target, feed the reference forward (`kf`, `ke`, `ka`), or widen `in_position` as far as the task allows.
A payload much heavier than the arm is tuned for settles slowly, too: slow the move down.
""",
)

PENETRATION = define(
    "S751",
    "penetration",
    Severity.ERROR,
    "two bodies collide in the run",
    """
An arm, its tool, the part in it or a device penetrated something else. The message names both bodies, the
greatest depth of all passes, the line on which the contact began, and in how many passes. Depth is the length
of the shortest shift that parts the two convex bodies that are the deepest in each other. A real arm would
have hit it, so the run has failed.

**What is checked.** Everything that moves, with what it carries, against everything else, at all recorded
times at which two may meet; the bodies of one robot against each other, and a part against what it is taken
from or put on, every 20 ms. Tools without shapes are checked as they are drawn. A mesh counts as its convex
hull, and a ring or cup made by turning a profile counts as full: a hollow of them is no room here, and a note
says so. Draw a bin of boxes or as a prism where the arm works in it.

**What is allowed.** Bodies that are up to 0.5 mm in each other touch: an arm keeps to its path no better.
Parts may be as deep in other things as `depth` of `[supports]` says, 2 mm where nothing is said.

**What is not checked.** What nothing moves against each other; links with a joint between them; what is drawn
into each other, at rest or all the time; parts against what they are in at the start; bodies without a known
shape. From the beginning of the last move before a part is gripped or released until the end of the first
one after it, the part may be in the hand. A part that leaves by a sink may be in anything.

**How to mend it.** Lead the arm around it by a point on the way, lift the part higher before it goes across,
take another posture, or move what is in the way.
""",
)

TOO_NEAR = define(
    "S770",
    "too-near",
    Severity.WARNING,
    "two bodies come nearer to each other than the cell requires",
    """
`clearance` in `[cell]` of the cell file requires a distance between what moves and all else. Here it was
less. The message names both bodies, the least distance of all passes, the line on which they came too near,
and in how many passes. Bodies that penetrate each other are a collision (S751).

Bodies of one robot, with its tool and what that holds, are not meant, nor is a part against what it is taken
from or put on, from the beginning of the last move before until the end of the first one after it.

**How to mend it.** Lead the arm farther from it, move what is too near, or require less. Without `clearance`,
or with 0, no distance is required.
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

RELEASED_IN_THE_AIR = define(
    "S736",
    "released-in-the-air",
    Severity.WARNING,
    "a part was released where nothing carries it",
    """
When the gripper opened, no fixed object, no other part and no floor (z = 0 of the world) was below the part
within `gap` of `[supports]` in the cell file, 5 mm where nothing is said. A real part would fall. Here it
stays where it was released, so what the program does with it later may not hold. A part that is in something
is found as such instead (S737).

Set the part down lower, at the height of what carries it plus its own; or describe what carries it under
`[[objects]]`. Nothing is said in a cell without fixed objects, or with one that is drawn by a mesh.
""",
)

RELEASED_INSIDE = define(
    "S737",
    "released-inside",
    Severity.WARNING,
    "a part was released in something else",
    """
When the gripper opened, the part reached deeper into a fixed object or another part than `depth` of
`[supports]` in the cell file allows, 2 mm where nothing is said. A real part would have been pressed against
it. The message says how deep it is in one solid of that body: so
much higher it would be above this solid, where another one may stand.

Boxes and upright cylinders are looked at as they are, all other shapes as the box around them: a part in the
hollow of such a shape is found, too. Build the hollow of boxes then.
""",
)

NOT_AT_DESTINATION = define(
    "S738",
    "not-at-destination",
    Severity.ERROR,
    "a part is not where it was to be when the run ended",
    """
The cell file gives the part a `destination`. When the program had come to its end, the part was farther from
there than `tolerance`, turned by more than `turn`, still in the gripper, still in its supply, gone by a
sink, or run off the end of a conveyor (S741). The message says where it is and how much is missing.

Often a grip that took nothing (S721) or a skipped move comes before; mend that first. Else compare the place
in the program with the destination, which is that of the grasp point: the centre of the top of the part.

A run that was ended by hand, by its longest time, or because programs wait in vain (S742) or are held for
ever (S762) says nothing of destinations. Nor does one whose programs have neither `open` nor `close`, in a
cell without devices, where all parts are as they were: it has nothing to do with parts.
""",
)

WAITS_IN_VAIN = define(
    "S742",
    "waits-in-vain",
    Severity.ERROR,
    "a program waits for a signal that nothing can change any more",
    """
Every program that still ran waited for a signal, no device was moving or had anything left to do, and no
change of an input that somebody waits for lay ahead. Nothing could happen any more, so the run was ended
there. Each program that waits has a finding at its line; it says who sets the signal, and where that
program stands, or what keeps a device from setting it.

Two programs that wait for each other are the usual case: the left one sets `offered` after `wait until
ready`, the right one sets `ready` after `wait until offered`. Let one of them speak first. Where a program
sets a signal on and off again while the other one looks elsewhere, the other one misses it: set it off only
when the other one has answered.

A program that goes round in a loop and does nothing but look at signals and stand, such as a wait for two
signals at once, waits too; so does one that looks at nothing at all. One that counts its passes or looks at
the time does not.

A station that opens a gate or feeds a machine for others does so in a loop, and waits when they are done.
Write `serves = true` in its table `[stations.NAME]`: its program then ends with theirs, and waits in vain
only together with them.

An input that nobody changes needs `changes` in the cell file, recorded inputs, or a key in a live run,
which goes on waiting. A wait with a `timeout` is never in vain.
""",
)

PULLED_APART = define(
    "S743",
    "pulled-apart",
    Severity.ERROR,
    "two grippers were closed on one part and moved apart",
    """
A part was handed over: a second gripper closed on it, and it hangs on that one from then on. The first one
was still closed on it when one of the two moved away, by more than the `capture` of the first one. The real
part would have been pulled out of one of the grippers, or bent.

Let the first gripper open before anything moves, and let each program wait for the other:

| gives | takes |
|---|---|
| `set offered on` | `wait until offered` |
| `wait until gripped` | `close`, `set gripped on` |
| `open`, then move away, `set offered off` | `wait until not offered`, then move away |

Two arms that carry a part together, both closed on it, may move as long as they keep their distance.
""",
)

RUN_OFF = define(
    "S741",
    "run-off",
    Severity.WARNING,
    "a part has run off the end of a conveyor",
    """
The centre of the part came to the end of the belt, where nothing carries it on, and the part has left the
cell. A real part would have fallen.

Stop the belt before, by the signal that lets it `run`, or give the conveyor a `stop` with a light barrier.
Where parts are meant to leave the cell there, put one of the `[[sinks]]` at the end of the belt; then nothing
is said.
""",
)
