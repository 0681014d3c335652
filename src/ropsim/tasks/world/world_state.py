"""Facts that hold in a cell."""

from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term, UnreadableError, leaves, read_term, write_term
from ropsim.tasks.findings.call_diagnostics import WRONG_FACT
from ropsim.tasks.kinds import TaskError


@frozen_dataclass
class WorldState:
    """The facts that hold at one time, such as `at(bolt,s1)`; all other facts do not hold.

    Attributes:
        facts: in the order of their text.
    """

    facts: tuple[Term, ...] = ()

    @classmethod
    def of(cls, *facts: "str | Term") -> "WorldState":
        """Return the state in which these facts hold.

        Raises:
            TaskError: one of them is no fact.
        """
        return cls(ordered(map(fact_of, facts)))

    def holds(self, fact: "str | Term") -> bool:
        """Return whether a fact is true.

        Raises:
            TaskError: it is no fact.
        """
        return fact_of(fact) in self.facts

    @property
    def gripperless(self) -> str:
        """Return the name of the tool on the arm where it has no gripper, else nothing."""
        named = {(one.name, one.arguments) for one in self.facts if isinstance(one, Struct)}
        tools = (one[0] for name, one in named if name == "tool" and ("without_gripper", one) in named)
        return min((one.name for one in tools if isinstance(one, Atom)), default="")

    def __str__(self) -> str:
        return ", ".join(map(write_term, self.facts))


def ordered(facts: Iterable[Term]) -> tuple[Term, ...]:
    """Return facts once each, in the order of their text."""
    return tuple(fact for _, fact in sorted({write_term(fact): fact for fact in facts}.items()))


def fact_of(fact: "str | Term") -> Term:
    """Return the fact of a text such as `at(bolt, s1)`, without variables.

    Raises:
        TaskError: it is none.
    """
    if isinstance(fact, str):
        try:
            term = read_term(fact.strip().removesuffix("."))
        except UnreadableError as error:
            raise TaskError(WRONG_FACT.at(None, f"`{fact[:80]}` is no fact: {error}", hint=_HINT)) from error
    else:
        term = fact
    if not isinstance(term, Atom | Struct) or not _is_ground(term):
        words = write_term(term)[:80]
        raise TaskError(WRONG_FACT.at(None, f"`{words}` is no fact without variables", hint=_HINT))
    return term


_HINT = "facts are written such as `at(bolt, s1)` or `gripper(open)`, names with small first letters"


def _is_ground(term: Term) -> bool:
    return all(isinstance(one, Atom | int | float | str) for one in leaves(term))
