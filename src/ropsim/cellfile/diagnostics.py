"""The kinds of mistakes in cell files, X810, X814 to X819, X825 to X827, X928, X929."""

from ropsim.core import Severity, define

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

TINY_PART = define(
    "X824",
    "tiny-part",
    Severity.WARNING,
    "a part of which no edge has a millimetre",
    """
Lengths of a cell file are in millimetres unless it says otherwise. A part that is smaller than a millimetre
in every direction is most often given in metres.

```toml
[[parts]]
name = "box"
size = [0.06, 0.06, 0.04]      # 60 µm: wrong where a box of 60 mm is meant
size = [60, 60, 40]            # right
```

A file that is written in metres throughout says so: `length = "m"` under `[units]`.
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

LAW_FILE = define(
    "X930",
    "no-law-file",
    Severity.ERROR,
    "the file of a joint controller is of another kind, or the robot has no drives",
    """
`file` in `[controller]` names the file of a joint controller in the project: a block diagram as an exchange
file (`.p21`, `.stp`, `.step`), or a module in Python (`.py`). A robot without drives follows its reference
exactly and takes none.

```toml
[controller]
file = "controllers/pi.p21"
```
""",
)

CONTACT_CANNOT_ACT = define(
    "X928",
    "contact-cannot-act",
    Severity.ERROR,
    "a meant contact has bodies between which no force can act",
    """
`[contacts.NAME]` names a tool or part (`of`) and what it is pressed on (`with`). Forces are computed from the
shapes of both. A body cannot be pressed on itself; a body without shapes, or drawn by a mesh, has no inside
that is known, so nothing could push back. Draw it by `shapes`: boxes, cylinders, spheres, prisms and
bodies of revolution; a hole is the gap between several of them.

```toml
[contacts.insertion]
of = "peg"
with = ["block"]
stiffness = 200   # N/mm
```
""",
)

FORCE_WITHOUT_CONTACT = define(
    "X929",
    "force-without-contact",
    Severity.WARNING,
    "a sensor measures the forces of contacts, and the cell declares none",
    """
A sensor of the kind `force torque` with compensated load reads what tool and held part exert on what they are
pressed on. Bodies push each other back only where a section `[contacts.NAME]` says that they are meant to;
without one they pass through each other in the run, and the sensor reads 0.

```toml
[contacts.insertion]
of = "peg"
with = ["block"]
stiffness = 200   # N/mm
```
""",
)

ROUNDED_RATE = define(
    "X933",
    "rate-rounded",
    Severity.WARNING,
    "the control rate is no whole multiple of the rate of a sensor",
    """
A sensor takes its samples a whole number of control ticks apart: at 1 kHz with 1000, 500, 333.3 or 250 Hz.
The run has the rate of the nearest whole number, which the finding names; sensors at tools and those of
`[controller.sensors]` alike.

```toml
[signals.force_z]
input = 13
analog = true
sensor = { kind = "force torque", axis = "z", rate = 400 }   # X933: 500 Hz at control_hz = 1000
```
""",
)
