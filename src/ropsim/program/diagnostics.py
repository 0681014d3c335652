"""Kinds of diagnostics about structured programs."""

from ropsim import icr
from ropsim.core import Diagnostic, RopsimError, Severity, Span, define

RECURSION = define(
    "N290",
    "task-calls-itself",
    Severity.ERROR,
    "a task calls itself, directly or through others",
    """
Calls must not form a cycle: a robot program has a bounded depth of calls that is known before it runs, so
that no controller runs out of memory in the middle of a motion. The message shows the chain of calls.

Use `repeat`, `while` or `for` instead:

```
task clear
  repeat 3
    call pick 1
  endr
endp
```
""",
)
GRIPPER_STATE = define(
    "T390",
    "gripper-state-contradicts-contract",
    Severity.WARNING,
    "a task is called while the gripper is in the opposite state",
    """
The called task says which state of the gripper it assumes at its start (`assumes gripper open at start`),
and on every way to this call the gripper is in the opposite state. The task would close a closed gripper,
or lose its part.

Open or close the gripper before the call, or change the contract. The check follows calls, loops and
branches; where the state depends on the way taken, it says nothing.
""",
)
NO_VALUE = define(
    "T391",
    "number-without-value",
    Severity.WARNING,
    "a variable may be read before it has a value",
    """
On at least one way through the program the line reads a variable that nothing has given a value yet. It reads
as 0, false or an empty text then. A loop whose count is not a constant may run no pass at all.

Give the variable a value before the branch or loop: `x = 0`.
""",
)
NO_LOCATION = define(
    "T392",
    "location-without-value",
    Severity.ERROR,
    "a location may be used before it has a value",
    """
On at least one way through the program the line uses a location, or joint coordinates, that nothing has given
a value yet. An arm must not move to a place that nobody chose, so the program is refused. A loop whose count
is not a constant may run no pass at all.

```
if part_ok
  q = (300, 0, 100)
endif
lin q            # error: where to, when part_ok is off?
```

Give the location a value before the branch or loop.
""",
)
IMPOSSIBLE_PATH = define(
    "T393",
    "points-make-no-path",
    Severity.ERROR,
    "points of an arc or a curve that make none",
    """
Three different points that do not lie on one line make a circle: the place where the motion begins, the via
point and the target. A curve needs another place for each of its points. Points count as one within 0.001 mm.

The check knows the place where a motion begins when a motion to a constant location stands before it; for
locations that are computed, and after calls and loops, the points are looked at when the program runs.
A full circle is written with a target on it and an angle: `circ via a to b angle 360 deg`.
""",
)
UNSOUND = define(
    "I450",
    "structured-program-unsound",
    Severity.ERROR,
    "a structured program cannot be lowered to ICR",
    """
A front end made a structured program that contradicts itself: a name that is not declared, an operation
that its operands do not have, a straight line to joint coordinates. Programs written in the task language
never do. If you built the program in Python, mend the statement that the message names.
""",
)


class LoweringError(RopsimError):
    """A structured program contradicts itself and has no ICR."""


def without_value(source: str, line: int, name: str, kind: icr.Type) -> Diagnostic:
    """Return the finding that a line may read a variable without a value.

    Args:
        source: name of the text.
        line: where it is read, 0 where unknown.
        name: the variable.
        kind: its type.
    """
    name = name.split(".", maxsplit=1)[0]  # variables of one name have numbers behind it
    is_place = kind in (icr.Type.POSE, icr.Type.JOINTS)
    return (NO_LOCATION if is_place else NO_VALUE).at(
        Span.whole_line(source, line) if line else None,
        f"`{name}` may have no value here" + ("" if is_place else ", it reads as zero then"),
        hint=f"give `{name}` a value on every way to this line",
        data={"name": name},
    )


def unsound(message: str, span: Span | None = None) -> LoweringError:
    """Return the exception for a structured program that contradicts itself."""
    diagnostic: Diagnostic = UNSOUND.at(span, message)
    return LoweringError(diagnostic)
