"""Messages of Prolog during loading of a text, as findings."""

from collections.abc import Iterator

from ropsim.core import Diagnostic, SourceText, Span
from ropsim.prolog.diagnostics import LOAD_WARNING, NOT_LOADED
from ropsim.prolog.error_words import shown_words
from ropsim.prolog.failures import failure_of
from ropsim.prolog.terms.terms import Atom, Struct, Term

CHECKED = {"syntax_error", "singletons", "discontiguous", "multitons", "undefined_procedures"}
"""Sorts of messages that `check` reports with better places."""


def loaded_module(reply: Term) -> str:
    """Return the module that a text became.

    Raises:
        GoalError: loading was stopped, or ended with an error.
    """
    match reply:
        case Struct("loaded", (Atom(module), tuple())):
            return module
    raise failure_of(reply)


def load_findings(text: SourceText, reply: Term) -> Iterator[Diagnostic]:
    """Yield a finding for each message of loading.

    Raises:
        GoalError: loading was stopped, or ended with an error.
    """
    match reply:
        case Struct("loaded", (Atom(module), tuple(messages))):
            pass
        case _:
            raise failure_of(reply)
    for message in messages:
        match message:
            case Struct("message", (Atom(kind), int(line), Atom(sort), str(words))) if sort not in CHECKED:
                yield _finding(text, module, (kind, line, words))


def _finding(text: SourceText, module: str, said: tuple[str, int, str]) -> Diagnostic:
    kind, line, words = said
    lines = [one for one in words.splitlines() if one.strip()] or ["refused"]
    first, more = lines[0], [one for one in lines[1:] if "$" not in one]  # those are calls inside of Prolog
    span = Span.whole_line(text.name, min(max(line, 1), len(text.lines)))
    message = shown_words(first, module)
    notes = (shown_words(" ".join(more), module),) if more else ()
    if kind == "error":
        return NOT_LOADED.at(
            span, message, notes=notes, hint="texts that are not trusted may do less: see P105"
        )
    return LOAD_WARNING.at(span, message, notes=notes)
