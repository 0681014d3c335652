"""The answer to a name that no task has."""

from collections.abc import Iterable

from ropsim.core import Diagnostic, did_you_mean
from ropsim.tasks.diagnostics import NOT_DEFINED


def not_defined(name: str, names: Iterable[str]) -> Diagnostic:
    """Return the finding that there is no task of a name, with a near one of those that there are."""
    hint = did_you_mean(name, names) or "`ropsim task list` shows what there is"
    return NOT_DEFINED.at(None, f"Task not defined: `{name}`", hint=hint)
