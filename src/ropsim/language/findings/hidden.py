"""Diagnostics of names that stand for two things."""

from ropsim.core import Severity, define

FUNCTION_NAME = define(
    "N222",
    "name-of-a-function",
    Severity.ERROR,
    "a task that has the name of a function of the language",
    """
`dist sqrt sin cos tan asin acos atan2 abs min max round trunc` are functions, in upper and lower case. A task
of such a name would be meant by `x = sqrt(9)`, the function by `print sqrt(9)`. Give the task another name.
""",
)
HIDDEN = define(
    "N223",
    "hides-another-name",
    Severity.ERROR,
    "a name that hides something of the cell or another declaration",
    """
Cell and text have one space of names: frames, tools, locations, signals, constants, patterns, tasks and
variables of all tasks. A parameter, a declaration or a task with the name of one of them would hide it: in a
task with a parameter `part_ok`, `wait until part_ok` would not look at the input, and `in shelf` would still
mean the frame where `loc shelf` declares a location.

Choose another name; where the thing of the cell is meant, leave the parameter or declaration out. A `loc`,
`frame` or `tool` that the cell has as the same sort of thing is told by N214, a `signal` by N224.
""",
)
OTHER_CASE = define(
    "N217",
    "names-differ-by-case",
    Severity.WARNING,
    "a call of a task where another one has the same name but for upper and lower case",
    """
Upper and lower case count in the names of tasks. Where a text has a task `Pick`, the call `pick infeed`
carries out the task `pick` of the library, which is another one. Two tasks of one text, or two of
the library, whose names differ by case only are as easily taken for each other.

Write the name of the task that is meant, or give the task of the text a name of its own.
""",
)
OTHER_SIGNAL = define(
    "N224",
    "signal-other-than-in-cell",
    Severity.ERROR,
    "a signal that the cell has as another kind",
    """
A `signal` line of a program tells readers what the cell file says, and is checked: the direction, `input` or
`output`, and whether it is `analog`. The number of the channel is documentation only.

Write the line as the cell has the signal, or leave it out.
""",
)
