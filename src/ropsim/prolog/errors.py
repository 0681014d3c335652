"""Error of a goal that Prolog could not answer."""

from ropsim.core import Diagnostic, RopsimError
from ropsim.prolog.terms.terms import Term


class GoalError(RopsimError):
    """Prolog ended a goal with an error, or was stopped.

    Attributes:
        term: the error without its place in Prolog, such as `type_error(evaluable, foo/0)`; None where the
            goal was stopped from outside.
    """

    def __init__(self, diagnostic: Diagnostic, term: Term | None = None) -> None:
        super().__init__(diagnostic)
        self.term = term
