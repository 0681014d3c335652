"""Result of checking a call of a task."""

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.prolog import Term
from ropsim.tasks.terms.task_call import TaskCall
from ropsim.tasks.world.world_state import WorldState


@frozen_dataclass
class CallReport:
    """Whether a call is possible, and why not.

    Attributes:
        call: with the parts, tools and devices taken from the state; as given if it is not possible.
        findings: why it is not possible; empty where it is.
        fails: the same as terms: `fails(pre, Condition)`, `fails(geo, Condition)`, `fails(task, Name)`,
            `fails(call, Words)`.
        providers: tasks that could make the missing facts true, in the order of the base.
        state: facts after the call; if the call is not possible, before it.
        unchecked: conditions that nothing has checked, such as `collisions`.
        warnings: doubts about a call that is possible.
    """

    call: TaskCall
    findings: tuple[Diagnostic, ...]
    fails: tuple[Term, ...]
    providers: tuple[str, ...]
    state: WorldState
    unchecked: tuple[str, ...] = ()
    warnings: tuple[Diagnostic, ...] = ()

    @property
    def ok(self) -> bool:
        """Return whether the call is possible."""
        return not self.findings

    @property
    def message(self) -> str:
        """Return the text for an operator: `accepted`, or the reason against it."""
        return "; ".join(one.message for one in self.findings) or "accepted"
