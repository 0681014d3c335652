"""The kinds of mistakes in TOML files, X801 to X809, X811 to X813, X816."""

from ropsim.core import Severity, define

TOML_SYNTAX = define(
    "X801",
    "toml-syntax",
    Severity.ERROR,
    "the file is not valid TOML",
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

UNKNOWN_KEY = define(
    "X802",
    "unknown-key",
    Severity.ERROR,
    "a key or section of the file has no meaning",
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

MISSING_KEY = define(
    "X803",
    "missing-key",
    Severity.ERROR,
    "a section of the file lacks a key that it needs",
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
    "a value of the file is of the wrong sort",
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
    "a list of the file is too short or too long",
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
    "a number of the file is beyond what is allowed",
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
    "a number of the file is `nan` or infinite",
    """
TOML can write `nan` and `inf`; no quantity of a cell can have such a value. Write a number.
""",
)

UNKNOWN_CHOICE = define(
    "X808",
    "unknown-choice",
    Severity.ERROR,
    "a text of the file is none of the allowed words",
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

CONFLICTING_KEYS = define(
    "X812",
    "conflicting-keys",
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

LOOKS_LIKE_RADIANS = define(
    "X822",
    "looks-like-radians",
    Severity.WARNING,
    "an angle in degrees has the digits of a right angle in radians",
    """
`1.5708` and `3.1416` are a quarter and half a turn in radians; as degrees they turn next to nothing. Angles
are in degrees unless the file says otherwise: `angle = "rad"` under `[units]`, in a robot file

```toml
units = { angle = "rad" }
```
""",
)

LOOKS_LIKE_METRES = define(
    "X823",
    "looks-like-metres",
    Severity.WARNING,
    "a place in millimetres that is nearly where it is counted from",
    """
Lengths are in millimetres unless the file says otherwise. A position of less than two millimetres that is no
whole number of them is most often written in metres.

```toml
[locations.pick_up]
position = [0.5, 0.3, 0.56]    # half a millimetre: wrong where half a metre is meant
position = [500, 300, 560]     # right
```

A file that is written in metres throughout says so: `length = "m"` under `[units]`. Nothing else hangs on
this warning.
""",
)
