"""Diagnostics of types, units and arguments, T3xx."""

from ropsim.core import Severity, define

WRONG_TYPE = define(
    "T301",
    "wrong-type",
    Severity.ERROR,
    "a value of one type where another is needed",
    """
Values are numbers (whole or with a dimension), truth values, texts, locations and joint targets. A
location is moved with `above`, `offset`, `rel` and `in`, not with `+`; conditions are truth values such
as `n > 3` or a digital signal.
""",
)
WRONG_DIMENSION = define(
    "T302",
    "wrong-dimension",
    Severity.ERROR,
    "a quantity of one dimension where another is needed",
    """
Lengths, angles, times, speeds and so on are told apart: `5 s + x` with a length `x` has no meaning, and
neither has a wait of 5 mm. Multiplication and division combine dimensions: a length divided by a time
is a speed. A number without unit takes the unit of `units` for the dimension that is needed.
""",
)
ARGUMENTS = define(
    "T303",
    "wrong-arguments",
    Severity.ERROR,
    "a call whose arguments do not fit the task",
    """
Every parameter without a default needs an argument, by place or by name (`clear = 60 mm`), and no
parameter takes two. A task without parameter list takes its reference locations first, then its scalars
in alphabetical order.
""",
)
NOT_WHOLE = define(
    "T304",
    "not-a-whole-number",
    Severity.ERROR,
    "a number with a fraction or a dimension where a count is needed",
    """
Counts of `repeat`, of a grid and parameters of type `int` are whole numbers; `6.0` is allowed, `6.5` is
not. In a modern text a variable has its type from its first value: after `m = 7`, or `var m = 7`, it
keeps whole numbers, after `m = 7.0` any number, after `m = 7 mm` lengths.

**How to mend it.** Let the first value have a fraction or the unit, or use `round(x)` or `trunc(x)` to make a
whole number.
""",
)
NOT_CONSTANT = define(
    "T305",
    "not-constant",
    Severity.ERROR,
    "a value that is not known before the program runs",
    """
Frames, tools, locations, constants, patterns, defaults of parameters, the step of `for` and the turns
of an orientation other than by `rpy`, `rx`, `ry`, `rz`, `pitch`, `roll` and `yaw` must be known when
the program is compiled: numbers, constants and functions of them.
""",
)
OUT_OF_RANGE = define(
    "T306",
    "impossible-value",
    Severity.ERROR,
    "a value outside of what is possible",
    """
Speeds and accelerations are greater than zero and shares at most 100 %; times and blend distances are
not negative; the step of `for` is not zero; roots and arc functions need operands in their domain; a
quaternion and a rotation need a direction.
""",
)
BARE = define(
    "T307",
    "bare-number",
    Severity.WARNING,
    "a quantity without unit in a strict text",
    """
`strict` asks for a unit at every length, angle, time and speed other than 0, so that no number changes
its meaning when the `units` line does.
""",
)
CONTRACT_COUNTS = define(
    "T308",
    "contract-counts-differ",
    Severity.WARNING,
    "the needs of a task name other counts than its body uses",
    """
The words after `needs` say how many reference locations and parameters the task takes. The body uses
another number: locations are `l`, `l1`, `l2` … and numbers passed on in their place, parameters are
names that are read before they are written. One of the two is wrong; the body counts.
""",
)
NO_EFFECT = define(
    "T309",
    "setting-without-effect",
    Severity.WARNING,
    "a setting that this motion does not use",
    """
`mov` goes from pose to pose with all joints together: its speed and acceleration are shares of the
joint limits (`speed 30 %`). `lin` keeps a path: its speed is that of the TCP (`speed 150 mm/s`). A bare
number is a speed of the TCP; `mov p speed 0.5` has the fix `speed 50 %`.
""",
)
NO_RETURN = define(
    "T310",
    "missing-return",
    Severity.ERROR,
    "a task with a result may end without one",
    """
The header promises a value (`-> type`), but the body can reach its end without `return value`.
""",
)
UNDECLARED = define(
    "T311",
    "undeclared-variable",
    Severity.ERROR,
    "a strict text assigns a variable that is not declared",
    """
Under `strict` every variable is declared by `var name: type`, so that a misspelt name cannot make a new
one.
""",
)
READING = define(
    "T313",
    "reading-in-other-unit",
    Severity.WARNING,
    "a reading of a sensor is compared with a number that counts in another unit than it seems to",
    """
A sensor of the cell file measures a length in m or a force in N. A number without a unit next to it counts
in these SI units, whatever `units` says: under `units mm`, `until gap < 12` ends the motion at once, as every
gap in the cell is below 12 m. Write the unit, `until gap < 12 mm`.

The number is followed through constants, variables, arithmetic, parameters and results of tasks: `h = 150`
and `until gap < h` is the same mistake. It is not followed from one task into another one through a `var` of
all tasks. Mend it where the number gets its value, `h = 150 mm`; a parameter is
declared as `h: length`. What is worked out of readings is in SI units, too. A value of another dimension, as
a time, never means what it seems to.
""",
)
TWO_COUNTS = define(
    "T316",
    "number-counts-in-two-units",
    Severity.WARNING,
    "a number without a unit that counts in two units",
    """
A number without a unit takes the unit of the place where it stands: behind `above` it counts in the unit of
`units`, next to a reading of a sensor in m or N. A variable or parameter that stands at both places means two
quantities, of which one is wrong:

```text
task Seek(h: int)
  lin infeed above h                # h mm
  lin infeed until gap < h          # h m
endp
```

Give the parameter the type `length`, or the variable a value with a unit.
""",
)
FRAME_WITHOUT_LINES = define(
    "T314",
    "frame-without-lines",
    Severity.WARNING,
    "a frame is set where no line is read in it",
    """
Frames are resolved when a program is compiled, not when it runs. `set frame F` says in which frame the lines
below it are read, up to the end of the block or task in which it stands. Behind `then` or `else` on a line it
therefore ends with the line, and a condition cannot choose the frame of the lines below:

```text
if part_ok then set frame left       # acts on nothing
lin (0, 0, 50)                       # read in the frame that was in force before
```

Write the moves into the branches, each with its frame, or keep the location in a variable:

```text
q = (0, 0, 50) in right
if part_ok then q = (0, 0, 50) in left
lin q
```
""",
)
FRAME_ENDED = define(
    "T315",
    "frame-ended-with-block",
    Severity.WARNING,
    "a location below a block in which another frame was set",
    """
A `set frame` in a block ends with the block: what stands below is read in the frame that was in force above
it. Speeds, zones and tools that are set in a block stay set, so the frame may have been expected to stay set.
The first location below the block is marked, unless a `loc` or `pattern` declares it.

Write `with frame F` … `endwith` inside the block, where the frame shall end there. Write `set frame F` before
the block, or once more behind it, where it shall go on.
""",
)
IN_CELL = define(
    "T312",
    "tool-data-not-used",
    Severity.WARNING,
    "mass or gripper of a tool in a program",
    """
A program knows the pose of a tool only. Mass, centre of mass and gripper belong to the cell file, where
the simulator finds them; here they have no effect.
""",
)
NO_VALUE_HERE = define(
    "T334",
    "home-has-no-value",
    Severity.ERROR,
    "the home position where a value is needed",
    """
Where the axes stand at home is a matter of the controller: the cell file says it, and a program runs at any
robot. So `home` is where a motion may go, and nothing that a variable keeps or a task is given.

```
mov home
j = joints(0 deg, 45 deg, 0 deg, 0 deg, 45 deg, 0 deg)     # coordinates of this program
mov j
```
""",
)
JOINT_COUNT = define(
    "T335",
    "wrong-number-of-joint-coordinates",
    Severity.ERROR,
    "joint coordinates of another number than the station has axes",
    """
`joints(…)` takes one coordinate for each axis of the station: those of the arm, then those of its external
axes. Where a text is compiled without a cell, the first `joints(…)` says how many there are, and all others
have as many; 32 at most.

```
mov joints(0, 75, -180, 0, -75, 0)              # six axes
mov joints(0, 75, -180, 0, -75, 0, 400 mm)      # six axes and a track
```
""",
)
NOTHING_CHANGES = define(
    "T336",
    "condition-without-signal",
    Severity.WARNING,
    "a wait for a condition that nothing changes meanwhile",
    """
A program that waits does nothing else, so its variables stay as they are. Only signals change meanwhile: a
condition that reads none is true at once or never. Let it read a signal, or ask once with `if`.

```
wait until n > 3                # nobody counts meanwhile
wait until n > 3 or part_ok     # part_ok may come
```
""",
)
NEVER_REACHED = define(
    "T337",
    "statement-never-reached",
    Severity.WARNING,
    "a statement that no way through the program leads to",
    """
The statement before it never goes on: `return`, `stop`, `break` and `continue` lead elsewhere, a `repeat`
without count, `until` and `break` has no end, and of an `if` all branches, `else` among them, may lead
elsewhere. Move the statement before it, or leave it out.
""",
)
OTHER_UNIT = define(
    "T338",
    "number-looks-like-another-unit",
    Severity.WARNING,
    "a number that seems to be meant in another unit",
    """
A number without unit counts in the unit of `units` for its dimension, times in seconds. `wait 500` then takes
more than eight minutes, where other controllers wait 500 ms; `speed 0.2` under `units mm` is 0.2 mm/s, where
0.2 m/s or a fifth of what the joints can do was meant. Write the unit behind the number, and nothing is said.

What is doubted:

- times of 100 s and more behind `wait` and `timeout`, where `units` names no other unit of time;
- speeds below 5 mm/s and accelerations below 50 mm/s2 under `units mm`, and both above 50 in SI units; a
  speed of more than 50 m/s is doubted with its unit, too, since no arm makes it;
- angles in degrees with four or more digits of a multiple of 45° in radians, as `rz 1.5708`, or with three
  where all numbers beside it are as small, as `rpy 0 0 3.14`;
- under `units mm`, places, frames and tools whose numbers are all below 2 and not all whole, and distances
  below 0.1 behind `above` and `blend`: these are mostly in metres. Small steps of patterns and shifts by
  `offset` and `rel` are usual, and so are frames that turn as little as they shift, places on the z of their
  frame, and small numbers beside a length of 2 mm or more.

```
lin (0.5, -0.25, 0.3) blend 0.05 acc 1.2                   # half a millimetre?
lin (0.5 m, -0.25 m, 0.3 m) blend 0.05 m acc 1.2 m/s2
```
""",
)
NO_TYPE = define(
    "T339",
    "parameter-without-type",
    Severity.ERROR,
    "nothing tells the type of a parameter",
    """
In a modern text a task tells by itself how it is called: a parameter has the type that its header gives, or
the one that its use in the task tells. What callers pass tells nothing, so that a task means the same whoever
calls it. A parameter that is only handed on or printed has no such use: write its type into the header.

```
task note(what)            # error: a number, a length, a location?
  print what
endp
task note(what: length)    # right
```

In classic texts, as in the papers, callers may tell.
""",
)
TWO_UNITS = define(
    "T340",
    "two-units-of-one-dimension",
    Severity.ERROR,
    "`units` names two units of one dimension",
    """
`units` says in which unit a bare number of each dimension is, for the whole text, wherever it stands. Two
lengths, or two angles, contradict each other: `units cm, mm`. Name one of them, and write the other one
behind the numbers that have it: `lin (300, 20, 2.5 cm)`.
""",
)
NEVER_RUN = define(
    "T341",
    "lines-never-run",
    Severity.WARNING,
    "a loop or a branch that never runs",
    """
The numbers that stand there tell it before the program runs: a `repeat` whose count is less than 1, a `for`
whose last value lies behind the first one, a condition that is always false. To count down,
a `for` needs a `step`.

```
for i = 10 to 1            # never runs
endf
for i = 10 to 1 step -1    # ten times
endf
```

A branch behind a condition that is always true is told as well. A condition with the name of a constant is
taken for a switch, `if dry_run then …` with `const dry_run = false`, and so is a count, `repeat passes` with
`const passes = 0`: nothing is said then.
""",
)
POINTS_UP = define(
    "T342",
    "tool-points-up",
    Severity.WARNING,
    "a location whose turn about z stands alone",
    """
`(x, y, z)` points the tool down. With orientation terms it points where they say, and a turn about z alone
leaves it up, along the z of the frame. Who wants the tool down and turned writes `down` first:

```
lin (450, 0, 300; down, rz 30)
lin (450, 0, 300; rpy 0 0 30)       # up and turned, if that is meant
```

Steps of `rel` and frames are turned by `rz` as they stand, and nothing is said of them, nor of locations in
frames whose z does not point up in the world, as that of the base of an arm on the ceiling.
""",
)
NOT_OF_UNIT_LENGTH = define(
    "T343",
    "quaternion-not-of-unit-length",
    Severity.WARNING,
    "a quaternion whose length is not 1",
    """
`quat w x y z` takes four numbers whose squares add up to 1. Others are brought to that length; often a number
is missing a digit then, or stands in another place than it was meant for.

```
lin (450, 0, 300; quat 0 1 1 0)                  # of length 1.41421
lin (450, 0, 300; quat 0 0.7071068 0.7071068 0)
```
""",
)
