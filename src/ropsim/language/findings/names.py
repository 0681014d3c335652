"""Diagnostics of names, N2xx."""

from ropsim.core import Severity, define

UNKNOWN_TASK = define(
    "N201",
    "unknown-task",
    Severity.ERROR,
    "a call of a task that is not defined",
    """
The line starts with a name that is neither a statement word nor a task of this text or of the library.
Either the name is misspelt, or the task is missing. Upper and lower case count in the names of tasks,
but not in statement words.

A first word near to `repeat`, `endr`, `loc` and the like keeps the part of that word in the text, where
blocks or a `=` behind a name show what was meant: nothing else is found wrong because of it.

```
task release(at_: loc)
  …
endp
call relase bin        <- did you mean `release`?
```
""",
)
UNKNOWN_NAME = define(
    "N202",
    "unknown-name",
    Severity.ERROR,
    "a name that has no meaning here",
    """
The name is no variable, constant, location or signal that can be seen from this line. Variables come to
be by their first assignment, by `load`, as parameters, or by `var`; only those declared by `var` and
`const` outside all tasks are seen inside tasks. The variable of `for` and `for each` is known in its loop
only; one that has a value before a counting loop keeps the value of the last pass behind it. Locations and
signals come from the cell file or from `loc` and `signal`.

A name is told once, with the further places where it stands: mostly its declaration is wrong or missing.
""",
)
UNKNOWN_FRAME = define(
    "N203",
    "undefined-frame",
    Severity.ERROR,
    "a frame that is not defined",
    """
After `in`, `with frame` and `set frame` stands the name of a frame of the cell file, of a `frame`
declaration, or `base` for the base frame of the robot.
""",
)
UNKNOWN_TOOL = define(
    "N204",
    "undefined-tool",
    Severity.ERROR,
    "a tool that is not defined",
    """
After `tool`, `open` and `close` stands the name of a tool of the cell file or of a `tool` declaration. A
station of `[stations]` has the tools of its key `tools`, or else the one it begins with.
Without a name, `open` and `close` work the tool in force.
""",
)
UNKNOWN_SIGNAL = define(
    "N205",
    "unknown-signal",
    Severity.ERROR,
    "a signal that is not defined",
    """
`set name on`, `off` or `= value` sets an output of the cell file or of a `signal` declaration. To give
a variable a value, write `name = value` without `set`.
""",
)
DUPLICATE = define(
    "N206",
    "duplicate-name",
    Severity.ERROR,
    "a name is declared twice",
    """
Every task, frame, tool, location, signal, constant, variable, pattern and parameter has one declaration, and
a name of its own: a frame and a location cannot share one. The first declaration counts; rename or remove the
other. `load` gives each of its names one number.
""",
)
NOT_ASSIGNABLE = define(
    "N207",
    "not-assignable",
    Severity.ERROR,
    "something that cannot be given a value",
    """
Constants, locations, patterns and the counters `.row .col .layer` of a pattern keep their value. Inputs are
set by the cell, outputs by `set name on`, `off` or `= value`. Frames, tools and tasks are no variables: no
assignment, `load`, `store`, result of a call or loop takes the name of one. To change a location, copy it
first: `q = infeed`, then `q.y = q.y + 5 mm`.
""",
)
UNKNOWN_MEMBER = define(
    "N208",
    "unknown-component",
    Severity.ERROR,
    "a component that the value does not have",
    """
A location has the components `.x .y .z` (lengths) and `.rx .ry .rz` (angles about the fixed X, Y and Z
axes: R = Rz·Ry·Rx). The variable of a `for each` has `.row .col .layer` as well, counted from 1. Other
values have no components.
""",
)
UNKNOWN_FUNCTION = define(
    "N209",
    "unknown-function",
    Severity.ERROR,
    "a function that the language does not have",
    """
Functions are `dist sqrt sin cos tan asin acos atan2 abs min max round trunc`. A task can be called in an
assignment if its header tells what it returns: `task Height(part: loc) -> length`.
""",
)
CALL_INSIDE = define(
    "N225",
    "call-inside-expression",
    Severity.ERROR,
    "a task that is called inside an expression",
    """
A task that returns a value is called as the whole right-hand side of an assignment only, so that each line
carries out one thing. Give the value a variable first:

```
h = Height(part) + 10 mm     <- inside an expression
h = Height(part)
h = h + 10 mm
```
""",
)
UNKNOWN_TYPE = define(
    "N210",
    "unknown-type",
    Severity.ERROR,
    "a type that the language does not have",
    """
Types are `num int bool str length angle time speed accel force loc joints`.

```
task Pick(part: loc, clear: length = 60 mm)
```
""",
)
UNKNOWN_UNIT = define(
    "N211",
    "unknown-unit",
    Severity.ERROR,
    "a unit that the language does not have",
    """
Units are `mm cm m inch`, `deg rad`, `s ms min`, `mm/s cm/s m/s deg/s rad/s`, `mm/s2 cm/s2 m/s2 deg/s2
rad/s2`, `kg g N Nm V mA` and `%`. They are written in this case, straight after the number.
""",
)
NO_REFERENCE = define(
    "N212",
    "no-reference-location",
    Severity.ERROR,
    "a reference location that the caller does not have",
    """
In a classic task a bare whole number in the place of a location means the caller's reference location
of that number: `call release 2` passes on the second one. Control statements have no reference
locations, and a task has no more than its callers pass to it.
""",
)
UNKNOWN_LIST = define(
    "N226",
    "unknown-list",
    Severity.ERROR,
    "a list of points that the project does not have",
    """
`lin along seam`, `spline along seam` and `mov along seam` lead through the points of the file
`points/seam.csv` of the project. A list has the name of its file: letters, digits and `_`. A list with an
error in it cannot be used either; `ropsim check` shows where that is.
""",
)
UNKNOWN_POINT = define(
    "N227",
    "unknown-point",
    Severity.ERROR,
    "a name that no point of a list has",
    """
`rack["p7"]` is the point that has the name `p7` in the first column of `points/rack.csv`. Upper and lower
case count. A point is also taken by its number, from 1: `rack[7]`.
""",
)
UNKNOWN_PATTERN = define(
    "N213",
    "unknown-pattern",
    Severity.ERROR,
    "a pattern or list that is not defined",
    """
`for each name in pattern` runs over a list of points of the project, `points/NAME.csv`, or over a `pattern`
declaration:

```
pattern slots = grid 6 x 6 from (0, 0, 40) step (70, 0, 0), (0, 70, 0)
```
""",
)
GIVEN_BY_CELL = define(
    "N214",
    "given-by-cell",
    Severity.WARNING,
    "a frame, tool or location of the program that the cell defines too",
    """
The cell file says where a frame, tool or location really is: it is calibrated there. Where a program declares
one of the same name, the pose of the cell is used everywhere, and the declaration changes nothing.

Remove the declaration, or give it a name of its own.
""",
)

FRAME_MOVES = define(
    "N215",
    "frame-moves",
    Severity.ERROR,
    "a frame of the program that would have to move",
    """
Frames that a program declares stand still. One that turns with a positioner, or goes with the carriage of a
track, is described in the cell file. Locations can be given in it in the program.

```toml
[frames.fixture]
parent = "positioner"
position = [100, 0, 0]
```

```text
frame corner = (50, 0, 0) in fixture     # wrong
loc corner = (50, 0, 0) in fixture       # right
```
""",
)
UNKNOWN_POSTURE = define(
    "N216",
    "unknown-posture",
    Severity.ERROR,
    "a word that is none of the postures of the arm",
    """
`config (…)` takes words of the arm's postures, for any of its parts: an arm with a spherical wrist is `left`
or `right`, `up` or `down`, `noflip` or `flip`. `ropsim robot ik` shows the names of the postures of a robot.
A part of which nothing is said is left to the planner.
""",
)
NEW_BESIDE = define(
    "N237",
    "new-variable-near-another",
    Severity.WARNING,
    "an assignment makes a new variable whose name is near to that of another one",
    """
The first assignment of a name makes a variable. This one is read nowhere, and there is one of nearly the same
name: most often that was meant. Under `strict` each variable is declared, and a misspelt one is an error.

```
count = 0
cuont = count + 1        # count stays 0
```
""",
)
UNUSED_TASK = define(
    "N238",
    "task-never-called",
    Severity.HINT,
    "a task that nothing calls",
    """
Neither the control statements nor a task that they reach calls this task, so it is never carried out. Call
it, or leave it out. A text without control statements, which only holds tasks, is told so by L111.
""",
)
UNUSED_VARIABLE = define(
    "N239",
    "variable-never-read",
    Severity.HINT,
    "a variable that nothing reads",
    """
The task, or the control statements, give the variable a value and never read it: neither in an expression nor
as a target, an argument or in `print`. Leave the assignment out, or use what it keeps.
""",
)
REFUSED_TASK = define(
    "N240",
    "task-cannot-be-called",
    Severity.ERROR,
    "a call of a task of a knowledge base whose body does not compile",
    """
There is a task of this name in the knowledge base of the project, of the user or of ropsim, and its body has
an error in this cell: a signal that the cell has not, a term that is no statement. The message says where the
task is and what is wrong; `ropsim check` tells the same at the text of the task.

Put the task right there, or write a task of this name into the program, which is then the one that is called.
""",
)
