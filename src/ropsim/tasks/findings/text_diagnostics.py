"""Findings about the texts of a knowledge base: its tasks, their bodies and effects."""

from ropsim.core import Category, Severity, define
from ropsim.tasks.terms.conditions import forms

TASK_FORM = define(
    "P130",
    "task-form",
    Severity.ERROR,
    "a task of a knowledge base does not have the form of one",
    """
A task is a fact `task(Head, [Properties])`. Its head is a name with variables that differ; its properties
are `doc("…")` and the lists `params`, `words`, `range`, `pre`, `eff`, `geo` and `body`, each once at most.
Such a task is left out, all others of the text stay.

```prolog
task(grip(P, L), [
  doc("takes the part that lies at a location"),
  params([P-part, L-location]),
  words([word(L, "place", "where the part lies")]),
  pre([gripper(open), at(P, L)]),
  eff([-gripper(open), +gripper(closed), -at(P, L), +held(P), +free(L)]),
  geo([reachable(arm, L)]),
  body([mov(L), close])]).
```

`words` has `word(L, "place")` or `word(L, "place", "a sentence on it")` for parameters, `range` bounds of
parameters that are numbers, such as `N >= 1` or `D =< 2*m`.
""",
)

UNTYPED = define(
    "P131",
    "untyped-parameter",
    Severity.ERROR,
    "a parameter of a task has no kind",
    """
Each variable of the head of a task stands in `params` as `Variable-kind`, or as `Variable-kind = value`
where a call may leave it out; and nothing else stands there.
""",
)

UNKNOWN_KIND = define(
    "P132",
    "unknown-kind",
    Severity.ERROR,
    "a parameter has a kind that there is not",
    """
What the state of the cell tells is a `part`, a `tool`, a `device` or a `thing`; what task text passes is
a `location`, `num`, `int`, `bool`, `str`, `length`, `angle`, `time`, `speed`, `accel`, `force` or
`joints`.
""",
)

UNKNOWN_TASK = define(
    "P133",
    "unknown-task-in-body",
    Severity.ERROR,
    "the body of a task calls a task that nobody defines",
    """
`call(grip(L))` calls a task of the same knowledge base or of the library that comes with ropsim. Tasks do
not call themselves.
""",
)

WRONG_ARITY = define(
    "P134",
    "arguments-in-body",
    Severity.ERROR,
    "the body of a task calls another one with too many or too few arguments",
    """
A call in a body has the arguments that task text has: all parameters but those of the kinds `part`,
`tool`, `device` and `thing`, which the state of the cell tells. `grip(P, L)` with a part P is called
`call(grip(L))`.
""",
)

NAME_CLASH = define(
    "P135",
    "task-name-clash",
    Severity.ERROR,
    "a name stands for two tasks, or for a task and a statement",
    """
Task text calls a task by its name alone, so a knowledge base has one task of a name, and none has the
name of a statement such as `mov`. The first one stays. A task may have the name of one of the library: it
takes its place.
""",
)

EFFECT_NEVER_READ = define(
    "P136",
    "effect-never-read",
    Severity.WARNING,
    "a task makes a fact that no condition looks at",
    """
Nothing depends on the fact, neither a precondition nor a rule. Mostly it is a slip of the pen: `hold(P)`
for `held(P)`, or an argument too many.
""",
)

NOBODY_MAKES = define(
    "P137",
    "condition-nobody-makes",
    Severity.WARNING,
    "a precondition looks at a fact that nobody makes",
    """
No task has such an effect, no text states such a fact, no rule tells it, and it is none that cells have:
`at/2`, `free/1`, `held/1`, `gripper/1`, `tool/1`, `part/1`, `location/1`, `device/1`. Where the state of
the cell has it all the same, a fact or a rule in the knowledge base says so.
""",
)

UNKNOWN_STATEMENT = define(
    "P138",
    "unknown-statement-in-body",
    Severity.ERROR,
    "the body of a task holds what is no statement",
    """
Statements are `mov(L)`, `lin(L)`, `mov(L, [speed(20*'%'), blend(5*mm)])`, `circ(Via, L)`,
`spline([A, B], L)`, `open`, `close`, `wait(T)`, `wait_until(C)`, `wait_until(C, T)`, `set(Signal, on)`,
`set(speed(V))`, `load([x, y, z], L)`, `x := x + A`, `call(task(…))`, `repeat(N, […])`,
`repeat_until(C, […])`, `if(C, […], […])`, `while(C, […])`, `for(I, A, B, […])`, `for_each(Q, Pattern, […])`,
`with([tool(T)], […])`, `print([…])`, `stop`, `break`, `continue`. Goals of Prolog are none: a body is
never run as Prolog.
""",
)

NOT_USED = define(
    "P139",
    "clause-not-used",
    Severity.WARNING,
    "a clause of a knowledge base has no effect",
    """
A knowledge base is read as data: tasks, facts without variables and rules. Directives other than `:-
module(Name, [])` are not run, grammar rules and facts with variables are not taken.
""",
)

UNBOUND = define(
    "P140",
    "unbound-variable",
    Severity.ERROR,
    "an effect, a condition of geometry or a body has a variable that is no parameter",
    """
Nobody knows what the variable stands for when the task is called. A precondition can tell a parameter of
the kind `part`, `tool`, `device` or `thing`; own variables of a body are names with small letters.
""",
)

UNKNOWN_GEOMETRY = define(
    "P141",
    "unknown-geometry",
    Severity.ERROR,
    "a condition of geometry is none that can be asked",
    f"""
Conditions of geometry are {forms()}.
Robot is a name, such as `arm`. The last one asks a condition at every place of a pattern that begins at its
location; Columns, Rows and Distance are parameters.
""",
)

TOO_DEEP = define(
    "P142",
    "clause-too-deep",
    Severity.ERROR,
    "a clause of a knowledge base is nested too deep",
    "The terms of a clause are nested 60 deep at most.",
)

MANIFEST = define(
    "P143",
    "knowledge-base-manifest",
    Severity.ERROR,
    "the manifest of a knowledge base is wrong",
    """
`kb/manifest.toml` tells in which order the texts are read: `order = ["grip.pl", "release.pl"]`. Each is a
file of the folder; those that are not named come behind, by their names.
""",
)

UNREADABLE_BASE = define(
    "P144",
    "knowledge-base-unreadable",
    Severity.ERROR,
    "a knowledge base cannot be read",
    """
The path is a project with a folder `kb`, such a folder, or one `.pl` file. At most 5000 files with 8 MB
in all are read; they are UTF-8.
""",
    Category.USAGE,
)

NO_TERM = define(
    "P145",
    "task-without-term",
    Severity.ERROR,
    "a task text cannot be kept in a knowledge base, or a task not be written as text",
    """
Terms have forms for all statements but `return`, declarations, `wait until` with `else` and motions with
`track`, and for all expressions but locations with a posture, a free orientation or values of external axes.
What else a task does is kept in a program.
""",
)

HIDES = define(
    "P146",
    "hides-library-task",
    Severity.HINT,
    "a task takes the place of one of the library, or of the user",
    """
It has the name of a task that comes with ropsim, or of one of the user. Calls mean the task of the project,
then that of the user, then that of the library.
""",
)

NO_COMPILING = define(
    "P147",
    "body-does-not-compile",
    Severity.ERROR,
    "the body of a task does not compile in the cell",
    """
The terms of the body are statements, but what they say is wrong: a name that neither task nor cell has, a
length for a time. The message is that of the compiler of the task language, the note its line.
""",
)

POINT_LIST = define(
    "P148",
    "point-list",
    Severity.ERROR,
    "a list of points cannot be read",
    """
A file `points/NAME.csv` has the names of its columns, their units, and a point on each further line. Names
may be empty or left out; pitch and roll, too. These have the meaning of `(x, y, z, pitch, roll)` in the
task language: the approach direction of the tool is level at pitch 0 and down at pitch 90. A last column
`yaw` may follow: the azimuth of the approach direction, 0 along +x. Where it is empty it is the azimuth of
the point. Lengths are in mm, cm, m or inch, angles in deg or rad. Titles may have the units themselves, as in
`x [mm]`; the line of units may be left out then. A list has at most 100 000 points.

Cells are separated by commas, by semicolons or by tabs, as the first line shows. Where these are no commas,
numbers may have decimal commas, as in `12,5;3,0`. The message is about the marked cell; while a line of a
list is wrong, no program can use the list.

```text
name,x,y,z,pitch,roll
,cm,cm,cm,deg,deg
feeder,3.1,4.2,8.6,0,0
seat,7.6,13,5
```
""",
)

DIFFERS = define(
    "P149",
    "task-of-program-differs",
    Severity.WARNING,
    "a program has a task of its own that is another one in the knowledge base",
    """
A task of the program counts before one of that name in the knowledge base of the project or of the user. Here
the two are not the same: the copy in a generated program has grown old, or both have one name by chance.

Leave the task out of the program to call the one of the knowledge base, or give one of them another name.
""",
)

EFFECT_UNMADE = define(
    "P159",
    "effect-without-step",
    Severity.WARNING,
    "no step of the body of a task brings about one of its effects",
    """
The body of a task is walked from what its preconditions say: `open` and `close` change the gripper and the
part at the place where the arm is, and a call has the effects of the task that it calls. What `eff` says of
the gripper and of the part in it has to come of that; what it says of places must not contradict it. A plan
that leans on an effect that never comes about fails in the cell.

```prolog
task(fetch(P, L), [
  params([P-part, L-location]), pre([gripper(open), at(P, L)]),
  eff([-gripper(open), +gripper(closed), -at(P, L), +held(P), +free(L)]),
  body([mov(L)])]).         % no `close`
```

Other facts, such as `inspected(P)`, are what the task says of itself. A body that sets an output may grasp
or leave a part by it, and nothing is said of that; nor of a task without a body. Of ways that differ, by `if`
or in a loop, what they have in common counts.
""",
)

EFFECT_UNSAID = define(
    "P160",
    "effect-not-said",
    Severity.WARNING,
    "the body of a task changes what its effects do not say",
    """
A step of the body leaves something else behind than the header says: the gripper is closed, a part is held
or no longer lies where it lay, or a task that the body calls has another effect. What is true after the task
would be wrong for each call that follows, and for plans. The hint names the effects that are missing.

```prolog
task(fetch(P, L), [
  params([P-part, L-location]), pre([gripper(open), at(P, L)]),
  eff([-at(P, L), +held(P), +free(L)]),     % -gripper(open), +gripper(closed) are missing
  body([mov(L), close])]).
```
""",
)

STEP_LACKS = define(
    "P161",
    "step-precondition",
    Severity.WARNING,
    "a step of the body of a task needs what nothing before it gives",
    """
A task that the body calls has preconditions. They must come of the preconditions of the task itself, or of
steps before the call; else the task is accepted where this step is not possible. Of places that are computed,
or that a loop fills and empties, nothing is said.

```prolog
task(fetch(L), [
  params([L-location]), pre([at(_, L)]),    % gripper(open) is missing
  eff([]), body([call(grip(L)), call(release(L))])]).
```
""",
)

POINT_TWICE = define(
    "P162",
    "point-name-twice",
    Severity.WARNING,
    "two points of a list have one name",
    """
In programs `rack["p7"]` is the first point of the list that has this name; the others are reached by their
numbers and by `for each`. Give each point a name of its own, or leave the names of points empty that need
none.
""",
)

POINT_LIST_NAME = define(
    "P163",
    "list-not-for-programs",
    Severity.WARNING,
    "a list of points whose name programs cannot use",
    """
In a program a list of points has the name of its file: letters, digits and `_`, no word of the language,
and no name that something else of the cell has. Rename the file if programs are to use it.
""",
)
