"""Findings in block diagrams of controllers (codes C619 to C627)."""

from ropsim.core import RopsimError, Severity, define

NOT_PUBLISHED = define(
    "C619",
    "no-published-controller",
    Severity.ERROR,
    "a published controller that does not come with ropsim",
    """
`ropsim.blockdiagram.published_controllers()` names the controllers that come with ropsim as files, each for
the robot model of its name.
""",
)

NOT_A_DIAGRAM = define(
    "C620",
    "diagram-wrong-schema",
    Severity.ERROR,
    "an exchange file is not of the schema ROPSIM_CONTROL_V1",
    """
The header of the file of a controller names its schema: `FILE_SCHEMA(('ROPSIM_CONTROL_V1'));`. A robot
(`ROPSIM_NIROX_V1`) or shapes (AP242) are no controller.
""",
)

WRONG_SIZE = define(
    "C621",
    "diagram-sizes",
    Severity.ERROR,
    "sizes of signals and blocks of a controller do not go together",
    """
Signals are vectors. Most blocks work element by element: their inputs have the size of their output, and
lists of numbers one number for all elements or one for each. Matrices have a row for each element of the
output and a column for each element of all inputs, one behind the other.
""",
)

WRONG_WIRING = define(
    "C622",
    "diagram-wiring",
    Severity.ERROR,
    "an element of a signal of a controller is set by nothing, or twice, or a name is not there",
    """
Each element of an inner signal and of the output is set exactly once: by the block whose output the signal
is, or by a link. Signals from outside are set by nobody. Names of signals are unique, and so are those of
blocks. One signal has the role `output`.
""",
)

WRONG_UNIT = define(
    "C623",
    "diagram-units",
    Severity.ERROR,
    "units of signals of a controller do not go together",
    """
What a sum adds has one unit, and it is that of the sum; limiters, delays and filters keep the unit of their
input; links connect equal units. Gains, matrices and PID blocks change the unit. An element with the unit
`other` is not compared.
""",
)

ALGEBRAIC_LOOP = define(
    "C624",
    "algebraic-loop",
    Severity.ERROR,
    "blocks of a controller need each other's output within one control tick",
    """
The blocks of a controller are computed one after the other at each control tick, so a block cannot wait for
a block that waits for it. Put a block between that answers a tick later: a delay, an integrator, or a
transfer function whose numerator is shorter than its denominator.
""",
)

WRONG_NUMBER = define(
    "C625",
    "diagram-numbers",
    Severity.ERROR,
    "a number in a block diagram of a controller cannot be",
    """
A lower limit above the upper one, points of a table that do not rise, a sample time other than the period of
the controller, a delay that is no whole number of ticks, a number beyond 1e12, or a diagram that is too large
to be compiled.
""",
)

DOES_NOT_FIT = define(
    "C626",
    "diagram-does-not-fit",
    Severity.ERROR,
    "a block diagram of a controller does not fit the arm or its rates",
    """
The output has an element for each axis, and so have references and measurements. Coordinates of axes that
turn are in `radian`, of those that slide in `metre`. The period is that of the controller of the cell
(`control_hz`), and an arm that the file names is the one of the station.
""",
)

NOT_WRITTEN = define(
    "C627",
    "diagram-not-written",
    Severity.ERROR,
    "a block diagram of a controller breaks a rule of the schema, and no file is written",
    """
What is written keeps to the schema ROPSIM_CONTROL_V1, and a diagram with findings does not.
""",
)


class DiagramError(RopsimError):
    """A block diagram is wrong, or does not fit an arm."""
