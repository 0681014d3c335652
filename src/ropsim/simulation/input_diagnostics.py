"""Diagnostics of runs that take inputs from outside (S760 to S769)."""

from ropsim.core import Severity, define

INPUT_NOT_USABLE = define(
    "S760",
    "input-not-usable",
    Severity.WARNING,
    "a recorded input does not fit the cell",
    """
A run was given recorded inputs (keys that were pressed in a live run) to take again. One of them is for a
signal that the cell does not have or that is an output, or its time or value is impossible; the changes of
that signal that do not fit are left out.

The usual reason is that a signal was renamed in `cell.toml` after the inputs were recorded. Name it as
before, or record the inputs again.
""",
)

STOPPED = define(
    "S761",
    "run-stopped",
    Severity.HINT,
    "a live run was ended by hand",
    """
The user ended a live run before its program did. The recording holds what happened until then; the cycle
time is that of the part that was carried out.
""",
)
