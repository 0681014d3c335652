"""What can be wrong with what a motion clock is asked for."""

from ropsim.core import RopsimError, Severity, define

WRONG_CLOCK_REQUEST = define(
    "C610",
    "wrong-clock-request",
    Severity.ERROR,
    "a motion clock was given an override or limits that it cannot follow",
    """
The motion clock walks through a planned motion at a rate between 0, where the arm stands, and 1, the speed
that was planned. A rate outside of that, a limit of its change that is not above 0, or a number that is not
finite has no meaning for it.

Ask for an override from 0 to 1, and give `ClockLimits` numbers above 0.
""",
)


class ClockError(RopsimError):
    """A motion clock was asked for what it cannot do."""
