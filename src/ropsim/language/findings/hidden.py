"""Diagnostics of names that stand for two things, N222 to N224."""

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
    Severity.WARNING,
    "a name that hides a signal, a location or another declaration",
    """
A parameter means its argument in the whole task, and a declaration its value in the whole text, also where
the cell has a signal or a location of that name, or, for a parameter, where the text declares one. So
`wait until part_ok` in a task with a parameter `part_ok` does not look at the input.

Choose another name; where the signal or location is meant, leave the parameter or declaration out.
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
