"""What Prolog replied or how it ended, as answers and as errors that say what to do."""

import re
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
from ropsim.prolog.errors import GoalError
from ropsim.prolog.program import CrashError, StoppedError, TooLongError
from ropsim.prolog.reading import UnreadableError
from ropsim.prolog.terms import Atom, Struct, Term

_QUOTED = re.compile(r"`([^`']*)'")
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
    """Return the error that a reply tells."""
    match reply:
        case Struct("stopped", (Atom(why),)) if why in _STOPPED:
            kind, message, hint = _STOPPED[why]
            return GoalError(kind.at(None, message, hint=hint))
        case Struct("error", (Struct("error", (formal,)), str(words))):
            return GoalError(_kind(formal).at(None, _message(words)), formal)
        case Struct("error", (Struct("ball", (Struct("ropsim_door", (str(words),)),)), _)):
            return GoalError(WRONG_USE.at(None, f"a predicate cannot be registered: {_message(words)}"))
        case Struct("error", (Struct("ball", (ball,)), str(words))):
            return GoalError(
                GOAL_ERROR.at(None, f"the goal threw what nothing caught: {_message(words)}"), ball
            )
        case Struct("uncaught", (str(words),)):
            return GoalError(GOAL_ERROR.at(None, _message(words)))
    return GoalError(GOAL_ERROR.at(None, f"Prolog replied {str(reply)[:200]}"))


@contextmanager
def failures_told() -> Iterator[None]:
    """Turn what ends an engine or a reply into errors with words.

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


def quoted(words: str) -> str:
    """Return the words of Prolog with names quoted as in all findings."""
    return _QUOTED.sub(r"`\1`", words)


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


def _message(words: str) -> str:
    lines = [line.strip() for line in words.splitlines() if line.strip()]
    return quoted(" ".join(lines)[:500]) if lines else "an error without words"
