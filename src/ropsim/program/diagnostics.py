"""Kinds of diagnostics about structured programs."""

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


def unsound(message: str, span: Span | None = None) -> LoweringError:
    """Return the exception for a structured program that contradicts itself."""
    diagnostic: Diagnostic = UNSOUND.at(span, message)
    return LoweringError(diagnostic)
