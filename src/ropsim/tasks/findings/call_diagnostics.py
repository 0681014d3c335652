"""Findings about calls of tasks, states of a cell and plans."""

from ropsim.core import Category, Severity, define

NOT_DEFINED = define(
    "P150",
    "task-not-defined",
    Severity.ERROR,
    "a call names a task that the knowledge base does not have",
    "`ropsim task list` shows the tasks that there are.",
)

WRONG_CALL = define(
    "P151",
    "task-call",
    Severity.ERROR,
    "a task is called with too many or too few points or parameters, or with one of another kind",
    """
`ropsim task show` says what a task takes. Points go to its locations, parameters to all else that task
text passes, each in the order of the head. A parameter with a dimension has a number with a unit of it,
or a bare number in the units of the program. A location, or the frame of one, that the cell does not have is
named with a near one.
""",
)

PRECONDITION = define(
    "P152",
    "task-precondition",
    Severity.ERROR,
    "a task is called where its preconditions do not hold",
    """
The state that the calls before have made lacks a fact that the task needs. Where a task could make it,
the hint names it.
""",
)

GEOMETRY_REFUSES = define(
    "P153",
    "task-geometry",
    Severity.ERROR,
    "the robot cannot do a task where it is called",
    """
A location is out of reach, or the robot, its tool or the part that it holds would be in something there, in
each posture that it could take. The message names both and how deep they are in each other; the ways between
places are not looked at.
""",
)

NO_PLAN = define(
    "P154",
    "no-plan",
    Severity.ERROR,
    "no sequence of tasks reaches a goal",
    """
Either a fact of the goal, or one that it takes to make it, is made by no task; or geometry refuses what
would make it; or each fact can be made, but not all of them together. The message says which. Where the goal
names a location, a frame or a part that is not there, the message says that, and the hint names a near one.
""",
)

PLAN_STOPPED = define(
    "P155",
    "plan-stopped",
    Severity.ERROR,
    "planning was stopped before it had a plan",
    "Its time was over, somebody cancelled it, or a function that it asks failed.",
)

WRONG_FACT = define(
    "P156",
    "no-fact-or-call",
    Severity.ERROR,
    "what should be a fact or a call is none",
    "Facts are terms without variables: `at(bolt, s1)`. Calls are task text: `Palletize s1, s2, 0.1, 6`.",
    Category.USAGE,
)

CHECK_STOPPED = define(
    "P157",
    "check-stopped",
    Severity.ERROR,
    "a call of a task could not be checked in its time",
    """
Checking a call takes some milliseconds. It was stopped because the machine was very busy, or because a rule
of the knowledge base that its preconditions need leads to itself. `ropsim task check` and `ropsim generate`
have `--seconds` for the time that each call may take, 2 s where nothing is said.
""",
)

IN_THE_AIR = define(
    "P158",
    "left-in-the-air",
    Severity.WARNING,
    "a task leaves a part where nothing carries it",
    """
Below the part, as it hangs in the gripper, nothing is within `gap` of `[supports]` in the cell file, 5 mm
where nothing is said: no object, no device, no floor, no other part of which it is known where it lies. The
message says what is next below and how far. The task is accepted; a run says the same of where the part is
released (S736).

Nothing is said in a cell without fixed objects, or with one that is drawn by a mesh, of locations in a frame
that moves, and of the location at which the part lies at the start.
""",
)
