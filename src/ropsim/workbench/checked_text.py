"""The findings of one program text, for editors."""

from collections.abc import Mapping
from dataclasses import field, replace

from ropsim import language
from ropsim.core import Diagnostic, SourceText, frozen_dataclass
from ropsim.workbench.compiled_project import found_at


@frozen_dataclass
class CheckedText:
    """What an editor shows of a program text.

    Attributes:
        source: the text.
        diagnostics: the findings of `ropsim check`, in order of place.
        tasks: how each task that the text can call is called.
        variables: type of each variable in a word of the language, by task and name.
    """

    source: SourceText
    diagnostics: tuple[Diagnostic, ...]
    tasks: Mapping[str, language.TaskForm] = field(default_factory=dict)
    variables: Mapping[str, Mapping[str, str]] = field(default_factory=dict)


def at_stations(checked: Mapping[str, CheckedText]) -> CheckedText:
    """Return the findings of one text at all stations that run it, by the names of these, one at least."""
    first = next(iter(checked.values()))
    found = {name: one.diagnostics for name, one in checked.items()}
    return replace(first, diagnostics=found_at(found))
