"""Answers of goals, one by one; goals lie on each other in Prolog, and only the uppermost can go on."""

from collections.abc import Generator, Iterator, Mapping

from ropsim.prolog.diagnostics import WRONG_USE
from ropsim.prolog.errors import GoalError
from ropsim.prolog.failures import answer_of, failures_raised
from ropsim.prolog.terms.terms import Term

Answer = Mapping[str, Term]
"""Value of each variable of a goal, by its name in the goal."""


class _Goal:
    """A goal that has begun: its replies, and whether more of them may be requested."""

    __slots__ = ("has_begun", "is_running", "is_wanted", "replies")

    def __init__(self, replies: Generator[Term]) -> None:
        self.replies = replies
        self.has_begun = False
        self.is_running = False
        self.is_wanted = True


class GoalStack:
    """The goals of one Prolog in the order in which they began."""

    def __init__(self) -> None:
        self._goals: list[_Goal] = []

    def next(self, goal: _Goal) -> Term | None:
        """Return the next reply of a goal, None behind the last; goals that began after it are given up."""
        if not goal.has_begun:
            goal.has_begun = True
            self._goals.append(goal)
        for later in reversed(self._goals):
            if later is goal:
                break
            later.is_wanted = False
        self.sweep()
        if not goal.is_wanted or goal.is_running or not self._goals or self._goals[-1] is not goal:
            raise GoalError(
                WRONG_USE.at(
                    None,
                    "a goal that was given up has no more answers",
                    hint="take all answers of a goal before those of one that began earlier",
                )
            )
        goal.is_running = True
        try:
            return next(goal.replies, None)
        finally:
            goal.is_running = False

    def sweep(self) -> None:
        """End the uppermost goals whose answers are not needed any more."""
        while self._goals and not self._goals[-1].is_wanted and not self._goals[-1].is_running:
            self._goals.pop().replies.close()

    def give_up(self) -> None:
        """Abandon all goals: their Prolog has ended."""
        for goal in self._goals:
            goal.is_wanted = False
        self._goals.clear()


class Answers(Iterator[Answer]):
    """The answers of one goal; Prolog computes the next one on request."""

    def __init__(self, replies: Generator[Term], stack: GoalStack) -> None:
        self._goal = _Goal(replies)
        self._stack = stack
        self._ended = False

    def __next__(self) -> Answer:
        """Return the next answer.

        Raises:
            GoalError: the goal ended with an error, was stopped or has been given up.
        """
        if self._ended:
            raise StopIteration
        self._ended = True  # unless there is an answer
        try:
            with failures_raised():
                reply = self._stack.next(self._goal)
                answer = None if reply is None else answer_of(reply)
        except BaseException:
            self.close()
            raise
        if answer is None:
            self.close()
            raise StopIteration
        self._ended = False
        return answer

    def close(self) -> None:
        """Request no more answers."""
        self._ended = True
        self._goal.is_wanted = False
        with failures_raised():
            self._stack.sweep()

    def __del__(self) -> None:
        self.close()
