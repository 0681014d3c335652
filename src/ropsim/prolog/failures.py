"""Replies and terminations of Prolog, as answers and as errors with hints."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager

from ropsim.core import Kind
from ropsim.prolog.diagnostics import (
    ANSWER_TOO_LARGE,
    CANCELLED,
    CRASHED,
    GOAL_ERROR,
    GOAL_SYNTAX,
    GOAL_UNSAFE,
    INFERENCE_LIMIT,
    TIME_LIMIT,
    WRONG_USE,
)
from ropsim.prolog.error_words import error_words, near_words, shown_words, thrown_words
from ropsim.prolog.errors import GoalError
from ropsim.prolog.program import CrashError, StoppedError, TooLongError
from ropsim.prolog.terms.reading import UnreadableError
from ropsim.prolog.terms.terms import Atom, Struct, Term

_STOPPED: dict[str, tuple[Kind, str, str]] = {
    "time": (
        TIME_LIMIT,
        "the goal was stopped: its time is over",
        "a recursion may not end; or the machine is busy: try it again",
    ),
    "inferences": (
        INFERENCE_LIMIT,
        "the goal was stopped: its inferences are used up",
        "give it more inferences",
    ),
    "cancelled": (CANCELLED, "the goal was cancelled", ""),
}


def answer_of(reply: Term) -> Mapping[str, Term]:
    """Return the answer that a reply is.

    Raises:
        GoalError: the reply is an error.
    """
    match reply:
        case Struct("answer", (tuple(bindings),)):
            return {name: value for name, value in map(_binding, bindings)}
    raise failure_of(reply)


def taken(reply: Term) -> None:
    """Accept that something was done.

    Raises:
        GoalError: the reply says that it was not.
    """
    if reply != Atom("done"):
        raise failure_of(reply)


def failure_of(reply: Term) -> GoalError:
    """Return the error in a reply."""
    match reply:
        case Struct("stopped", (Atom(why),)) if why in _STOPPED:
            kind, message, hint = _STOPPED[why]
            return GoalError(kind.at(None, message, hint=hint))
        case Struct("error", (Struct("error", (formal,)), str(words))):
            message = error_words(formal, words)
            return GoalError(_kind(formal).at(None, message, hint=near_words(words)), formal)
        case Struct("error", (Struct("ball", (Struct("ropsim_door", (str(words),)),)), _)):
            return GoalError(WRONG_USE.at(None, f"a predicate cannot be registered: {shown_words(words)}"))
        case Struct("error", (Struct("ball", (Atom("ropsim_no_reply"),)), _)):
            return GoalError(GOAL_ERROR.at(None, "Prolog gave no answer"))
        case Struct("error", (Struct("ball", (ball,)), _)):
            return GoalError(GOAL_ERROR.at(None, thrown_words(ball)), ball)
        case Struct("uncaught", (str(words),)):
            return GoalError(GOAL_ERROR.at(None, "Prolog could not answer"), Atom(words))
    return GoalError(GOAL_ERROR.at(None, "Prolog gave an answer that is none"), reply)


@contextmanager
def failures_raised() -> Iterator[None]:
    """Turn terminations of an engine and error replies into exceptions with words.

    Raises:
        GoalError: Prolog has crashed or was stopped, or a reply cannot be taken over.
    """
    try:
        yield
    except StoppedError as error:
        kind, message, hint = _STOPPED[error.why]
        raise GoalError(kind.at(None, message, hint=hint)) from error
    except CrashError as error:
        raise GoalError(CRASHED.at(None, f"Prolog ended in the middle of its work: {error}")) from error
    except (TooLongError, UnreadableError) as error:
        raise GoalError(ANSWER_TOO_LARGE.at(None, f"an answer cannot be taken over: {error}")) from error


def _binding(term: Term) -> tuple[str, Term]:
    match term:
        case Struct("=", (Atom(name), value)):
            return name, value
    raise UnreadableError("an answer that is no list of variables")


def _kind(formal: Term) -> Kind:
    match formal:
        case Struct("syntax_error", _):
            return GOAL_SYNTAX
        case Struct("permission_error", (_, Atom("sandboxed"), _)):
            return GOAL_UNSAFE
    return GOAL_ERROR
