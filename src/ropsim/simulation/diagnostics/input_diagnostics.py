"""Diagnostics of runs that take inputs from outside (S760 to S769)."""

from ropsim.core import Category, Severity, define

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
    Category.STOPPED,
)

HELD_FOR_EVER = define(
    "S762",
    "held-for-ever",
    Severity.ERROR,
    "a run is held, and nothing lets it go on",
    """
The inputs that the run was given end with a hold: the override is 0, and no later change raises it. An
override below 0.1 % counts as 0: no program would come to its end with it. Every program that still ran
stood held, or waited for a signal that nothing can change any more. Nothing could happen, so the run was
ended there, and the cycle time is not that of the program.

A live run that was closed while it was held leaves such inputs. Add a change of the override after the hold,
or leave the hold out:

```
[{"override": 0, "time": 1.2}, {"override": 1, "time": 4}]
```

A live run goes on waiting, as the hold can be ended there.
""",
    Category.UNFINISHED,
)
