"""Kinds of traps (I460 to I469): how the machine ends a program that cannot go on."""

from ropsim.core import Category, Severity, define

_ERROR = Severity.ERROR

DIV0 = define(
    "I460",
    "division-by-zero",
    _ERROR,
    "trap DIV0: a divisor is 0",
    """
The program divided by 0 (`DIV`, `MOD`). Test the divisor before the division; note that `and` and `or` always
evaluate both sides.
""",
    Category.UNFINISHED,
)
RANGE = define(
    "I461",
    "trap-range",
    _ERROR,
    "trap RANGE: an instruction was given a value outside its domain",
    """
A computed value has no meaning for the instruction: the root of a negative number, an angle of a sine above
1, an integer beyond 64 bits, a number that is no longer finite, a speed of 0, a repeat count of 2.5. The
message says what was found and what is allowed.
""",
    Category.UNFINISHED,
)
IO_TIMEOUT = define(
    "I462",
    "wait-timed-out",
    _ERROR,
    "trap IO_TIMEOUT: what the program waits for did not come",
    """
A wait ended without its condition, and the program does not say what to do then. Give the wait another way
out (`else`), a longer timeout, or set the input in the scenario of the simulation.
""",
    Category.UNFINISHED,
)
BUDGET = define(
    "I463",
    "instruction-budget-spent",
    _ERROR,
    "trap BUDGET: the program ran longer than allowed",
    """
The machine ends a program after a given number of instructions, so that an endless loop does not hang the
simulation. If the program is meant to run for ever, limit the run by time, or raise the budget.
""",
    Category.UNFINISHED,
)
USER = define(
    "I464",
    "program-trap",
    _ERROR,
    "trap USER: the program ended itself by TRAP n",
    """
The program reached a `TRAP` instruction with a number of its own. What it means is said by whoever wrote it.
Numbers below 100 are reserved for front ends.
""",
    Category.UNFINISHED,
)
POSE_UNKNOWN = define(
    "I465",
    "command-pose-unknown",
    _ERROR,
    "trap: the pose of the arm is not known",
    """
`here` (`CURPOSE`) and `store` (`ATTAINED`) need a robot where the last target does not tell the pose: at the
start, after a move to joint coordinates or home, after an arc of an angle, and when a tool comes into force
whose pose only the cell knows. A run without a robot, such as that of `ropsim icr run`, ends there; run the
program in its cell. In a cell this is told for a tool or a frame that neither cell nor program gives, for
a task frame that another station moves, and for the distance of locations in frames that move against each
other.
""",
    Category.UNFINISHED,
)
BOUNDS = define(
    "I466",
    "trap-bounds",
    _ERROR,
    "trap BOUNDS: a list has no element of that number",
    """
A program takes an element of a list by a number that it computes, and the list has none of that number.
Elements are counted from 1. The message has the number and how many there are.
""",
    Category.UNFINISHED,
)

TRAP_TIMED_OUT = 1
TRAP_NOT_WHOLE = 2
