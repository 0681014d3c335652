"""The kinds of mistakes in cell files, X801 to X819, X825 and X826."""

from ropsim.core import Severity, define

CELL_FILE_SYNTAX = define(
    "X801",
    "cell-file-syntax",
    Severity.ERROR,
    "the cell file is not valid TOML",
    """
The file cannot be cut into keys and values, so nothing in it is read. The place is where the reader stopped;
the mistake often stands just before it: a missing quotation mark, a missing bracket, a word without quotes, a
key or section that occurs twice, a number with a comma.

```toml
[robot]
model = puma560        # wrong: text needs quotation marks
model = "puma560"      # right
```
""",
)

UNKNOWN_CELL_KEY = define(
    "X802",
    "unknown-cell-key",
    Severity.ERROR,
    "a key or section of the cell file has no meaning",
    """
A key that nobody reads would silently leave a default in force, so it is an error. The message names the
nearest key that this section knows; `docs/reference/cell-file.md` lists them all.

```toml
[robot]
modell = "puma560"     # wrong
model = "puma560"      # right
```
""",
)

MISSING_CELL_KEY = define(
    "X803",
    "missing-cell-key",
    Severity.ERROR,
    "a section of the cell file lacks a key that it needs",
    """
Some keys have no sensible default: a robot needs its model, a part its size, mass and position. Add the key
to the section that the message names.

```toml
[[parts]]
name = "box"
size = [60, 60, 40]
mass = 0.5
position = [500, 0, 40]
```
""",
)

WRONG_VALUE_TYPE = define(
    "X804",
    "wrong-value-type",
    Severity.ERROR,
    "a value of the cell file is of the wrong sort",
    """
The key exists, but its value is text where a number is needed, one number where a list is needed, a section
where a value is needed, and so on. Numbers stand without quotation marks and without units; the units of the
whole file stand in `[units]`.

```toml
mass = "0.5 kg"        # wrong
mass = 0.5             # right: masses are in kg
```
""",
)

WRONG_VALUE_COUNT = define(
    "X805",
    "wrong-value-count",
    Severity.ERROR,
    "a list of the cell file is too short or too long",
    """
Positions have three numbers (x, y, z), `rpy` has three angles, a quaternion four numbers (w, x, y, z), an
inertia six (ixx, iyy, izz, ixy, ixz, iyz). Lists per joint have as many numbers as the
arm has joints, then one for each external axis.
""",
)

VALUE_OUT_OF_RANGE = define(
    "X806",
    "value-out-of-range",
    Severity.ERROR,
    "a number of the cell file is beyond what is allowed",
    """
Every number has a range that is wide for real cells and narrow enough to catch slips: lengths up to 100 m,
masses up to 10 t, factors on speeds up to 1. Most often the unit is wrong: lengths are in millimetres and
angles in degrees unless `[units]` says otherwise, masses always in kilograms, times in seconds.
""",
)

VALUE_NOT_FINITE = define(
    "X807",
    "value-not-finite",
    Severity.ERROR,
    "a number of the cell file is `nan` or infinite",
    """
TOML can write `nan` and `inf`; no quantity of a cell can have such a value. Write a number.
""",
)

UNKNOWN_CHOICE = define(
    "X808",
    "unknown-choice",
    Severity.ERROR,
    "a text of the cell file is none of the allowed words",
    """
Some keys take one word out of a few, for example `length = "mm"`, `"cm"`, `"m"` or `"inch"`. The message
lists the words that are allowed.
""",
)

UNKNOWN_CELL_NAME = define(
    "X809",
    "unknown-cell-name",
    Severity.ERROR,
    "the cell file speaks of a tool, frame or object that it does not define",
    """
A tool in `[robot]`, a frame in a location or in `[classic]`, or the `parent` of an object is not defined in
the same file. Define it, or mend the name; names are case-sensitive.

```toml
[robot]
model = "puma560"
tool = "jaws"

[tools.jaws]
position = [0, 0, 120]
```
""",
)

DUPLICATE_CELL_NAME = define(
    "X810",
    "duplicate-cell-name",
    Severity.ERROR,
    "two things in the cell share a name or a channel",
    """
Parts and fixed objects need names of their own, because reports and recordings speak of them by name; so do
sinks. A grid and a supply make the names `name_1`, `name_2` and so on, which may meet the name of another
part. `base`, `link1` to `linkN` and `tool:NAME` are the bodies of the robot. Two signals of one direction and
sort cannot share a channel number.
""",
)

UNFIT_QUATERNION = define(
    "X811",
    "unfit-quaternion",
    Severity.ERROR,
    "four numbers are not a rotation",
    """
A quaternion (w, x, y, z) describes a rotation when its length is 1. The four numbers of this one are too
far from that (more than 1 %), so they are probably in the wrong order, cut off, or not a quaternion. Use
`rpy` where angles are at hand.

```toml
quaternion = [0.7071, 0, 0, 0.7071]     # a quarter turn about z
```
""",
)

CONFLICTING_CELL_KEYS = define(
    "X812",
    "conflicting-cell-keys",
    Severity.ERROR,
    "two keys of one section say the same thing",
    """
An orientation is given by `rpy`, by `quaternion` or, for a location, by `down`, and by one of them only. A
signal is an `input` or an `output`. Remove one of the two.
""",
)

IMPOSSIBLE_INERTIA = define(
    "X813",
    "impossible-inertia",
    Severity.ERROR,
    "no rigid body has this inertia",
    """
The principal moments of inertia of a rigid body about its centre of mass are not negative, and none of them
exceeds the sum of the other two; a body without mass has none. Check the sign of the products of inertia (the
tensor's own entries, `ixy = -∫ x·y dm`), the unit (kg·m², whatever `[units]` says) and the order
ixx, iyy, izz, ixy, ixz, iyz.
""",
)

UNORDERED_CHANGES = define(
    "X814",
    "unordered-signal-changes",
    Severity.ERROR,
    "the changes of a signal are not in order of time",
    """
`changes` lists when an input takes which value, as `[time, value]` pairs with times that grow.

```toml
[signals.part_ready]
input = 1
changes = [[1.5, 1], [4.0, 0]]
```
""",
)

START_OUTSIDE_LIMITS = define(
    "X815",
    "start-outside-limits",
    Severity.ERROR,
    "the robot would start outside its joint limits",
    """
`start` in `[robot]` gives the joint coordinates at time 0, one per joint. Each must lie within the limits
of its joint; `ropsim robot show NAME` prints them. Without `start` the arm starts at its home position.
""",
)

UNSPEAKABLE_NAME = define(
    "X816",
    "unspeakable-name",
    Severity.ERROR,
    "programs cannot speak of a thing with this name",
    """
Programs call tools, frames, locations and signals by name. Such a name begins with a letter or `_` and goes
on with letters, digits and `_`; blanks, dots and hyphens would be read as something else.

```toml
[tools."vacuum cup"]   # wrong
[tools.vacuum_cup]     # right
```
""",
)

CHANGES_OF_OUTPUT = define(
    "X817",
    "changes-of-output",
    Severity.ERROR,
    "an output is told to change by itself",
    """
`changes` describes what the world does to an input. Outputs change when the program sets them; remove
`changes`, or make the signal an `input`.
""",
)

OBJECTS_IN_A_RING = define(
    "X818",
    "objects-in-a-ring",
    Severity.ERROR,
    "fixed objects hang on each other in a ring",
    """
The key `parent` of an object names the object in whose frame its pose is given. Going from parent to parent
must come to an object without one, whose pose is in the world; here it comes back to where it began, so no
object of the ring has a place.

```toml
[[objects]]
name = "table"
position = [500, 0, 700]
size = [800, 600, 30]

[[objects]]
name = "fixture"
parent = "table"               # the table must not hang on the fixture in turn
position = [100, 0, 0]
size = [80, 80, 40]
```
""",
)

PART_IN_THE_AIR = define(
    "X819",
    "part-in-the-air",
    Severity.WARNING,
    "a part lies on nothing when a run starts",
    """
No fixed object, no other part and no floor (z = 0 of the world) is below the part within `gap` of
`[supports]`, 5 mm where nothing is said. A real part would not stay there. Most often its position is that of
its centre instead of the centre of its top face, or what it lies on is missing under `[[objects]]`.

```toml
[[parts]]
name = "box"
size = [60, 60, 40]
mass = 0.5
position = [500, 0, 740]       # its top: 40 mm above a table of 700 mm
```

Nothing is said in a cell without fixed objects, devices and positioners, or with one that is drawn by a mesh.
""",
)

PART_INSIDE = define(
    "X825",
    "part-inside",
    Severity.WARNING,
    "a part is in a device or an external axis when a run starts",
    """
The part and what carries parts, such as the plate of a positioner, the carriage of a track or a device, are
in the same place, deeper than `depth` of `[supports]`, 2 mm where nothing is said. Most often its position is
that of its underside or its centre instead of the centre of its top face. Parts may stand in fixed objects
and in each other: a pin in its magazine is well.

```toml
[robot]
positioner = { radius = 400, height = 700, base = { position = [0, 1200, 0] } }

[[parts]]
name = "box"
size = [60, 60, 40]
mass = 0.5
position = [0, 1200, 700]      # wrong: its top is at the height of the plate; right is 740
```

Nothing is said in a cell without fixed objects, devices and positioners, or with one that is drawn by a mesh.
""",
)

NOBODY_TO_SERVE = define(
    "X827",
    "nobody-to-serve",
    Severity.ERROR,
    "every program of the cell serves, and none is served",
    """
A station with `serves = true` works for the programs of the other stations, and its own is over when these
have ended. So at least one station must run a program of its own account, whose end is the end of the run.

```toml
[stations.arm]
robot = "puma560"              # its program says when the work is done

[stations.gate]
serves = true                  # opens and closes as long as that of `arm` runs
```
""",
)

UNFIT_FRAME = define(
    "X826",
    "unfit-frame",
    Severity.ERROR,
    "a task frame that moves, or lies, where it cannot",
    """
A task frame stands in the world, or lies on what an external axis of a robot moves: `parent = "positioner"`
or `"track"`, of a station with a name `"left/positioner"`. Only the controller of that robot knows where such
a frame is when a move ends, so only its program can work in it.

A frame cannot lie on a device or an object: no controller moves these. Classic files and destinations of
parts need a place that stands still, so neither `frame` of `[classic]` nor `location` of a `destination` can
be one that moves.

```toml
[frames.fixture]
parent = "table"              # wrong where `table` is a device or an object
parent = "positioner"         # right
position = [100, 0, 0]
```
""",
)
