"""Diagnostics of simulated runs: moves, waits, corrections, collisions."""

from ropsim.core import Category, Severity, define

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
    Category.UNFINISHED,
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

LONG_SETTLING = define(
    "S725",
    "long-settling",
    Severity.HINT,
    "settling after moves takes a good part of the cycle",
    """
A move ends when every joint is within `in_position` of its target. Here the arm waits for that after its
moves for more than 2 % of the cycle time in all, and after some of them for more than 20 ms. With better
gains the same program would be faster. The line named is that of the longest wait.

**How to mend it.** Gains in `[controller]` of the cell file replace the law of a built-in arm, which knows
its load, by loops of fixed gains: leave them out and look again. Otherwise raise `kp` and `kv`, or `ki` where
dry friction keeps the arm from its target, feed the reference forward (`kf`, `ke`, `ka`), or widen
`in_position` as far as the task allows. With such gains a payload much heavier than the arm is tuned for
settles slowly, too: slow the move down.
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

**What is checked.** Everything that moves, with what it carries, against everything else, at all times: a
bound of the motion between two recorded times proves that two bodies do not meet there. Where that proves
nothing, they are an error of their own (S771). Tools without shapes are checked as they are drawn. A mesh
counts as its convex hull, and a ring or cup made by turning a profile counts as full: a hollow of them is no
room here, and a note says so. Draw a bin of boxes or as a prism where the arm works in it.

**What is allowed.** Bodies that are up to 0.1 mm in each other touch.
Parts may be as deep in other things as `depth` of `[supports]` says, 2 mm where nothing is said.

**What is not checked.** What nothing moves against each other; links with a joint between them; what is drawn
into each other, at rest or all the time; parts against what they are in at the start; bodies without a known
shape. From the beginning of the last move before a part is gripped or released until the end of the first
one after it, the part may be in the hand. A part that leaves by a sink may be in anything.

**How to mend it.** Lead the arm around it by a point on the way, lift the part higher before it goes across,
take another posture, or move what is in the way.
""",
    Category.COLLISION,
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

NOT_SEPARATED = define(
    "S771",
    "not-separated",
    Severity.ERROR,
    "two bodies may collide between two recorded times",
    """
Two bodies are so near to each other that the recorded times do not tell whether they penetrate. Between two
of these a body may leave the straight line by the square of the interval times its acceleration, divided by
eight: 0.02 mm for 10 m/s² at 250 Hz, 0.5 mm at 50 Hz. The message names both bodies, the depth that cannot be
excluded, and the line.

**How to mend it.** Lead the arm farther from it, or slower. In Python, a run with a greater `record_hz` knows
the motion better.
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
