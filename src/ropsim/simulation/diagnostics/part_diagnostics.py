"""Diagnostics of parts, grips and devices in simulated runs."""

from ropsim.core import Category, Severity, define

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

WIDER_THAN_FINGERS = define(
    "S726",
    "part-wider-than-fingers",
    Severity.WARNING,
    "a gripper took a part that does not fit between its fingers",
    """
The fingers of a gripper stand apart along y of the tool frame, by their `open` distance, or the `stroke` of a
gripper of the library. The part that they closed on is wider there: its edge counts that is nearest to that
direction. Real fingers would come down on the part. The run goes on as if they held it.

**How to mend it.** Grip the part across a narrower edge: turn the tool about its axis, by `rz` in the program
or the orientation of the location. Or take a gripper with a greater stroke, or a vacuum gripper. A gripper
whose fingers take hold of a rim or a handle, of which the box of the part knows nothing, is one without
`fingers`.
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
    Category.UNFINISHED,
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
