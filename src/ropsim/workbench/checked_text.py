"""The findings of one program text, for editors: the quick half of `compile_program`."""

from collections.abc import Mapping
from dataclasses import field

from ropsim import language
from ropsim.core import Diagnostic, SourceText, frozen_dataclass
from ropsim.model import Cell, Station
from ropsim.workbench.compiled_project import compile_program, found_at, unbound


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


def check_text(
    text: SourceText,
    cell: Cell | None,
    environments: Mapping[str, language.Environment],
    cache: language.LineCache,
) -> CheckedText:
    """Return the findings of a task text or an ICR text (by its ending) at all stations that run it, quickly.

    The code that comes out of the compiler is not verified once more, which it passes by construction.

    Args:
        text: the program.
        cell: the cell, None for a text outside of a project.
        environments: what the cell gives names to, by the name of the station, one at least.
        cache: kept between versions of the text.
    """
    checked = [
        _at_station(text, cell, cell.stations[name] if cell else None, environment, cache)
        for name, environment in environments.items()
    ]
    found = {name: one.diagnostics for name, one in zip(environments, checked, strict=True)}
    return CheckedText(text, found_at(found), checked[0].tasks, checked[0].variables)


def _at_station(
    text: SourceText,
    cell: Cell | None,
    station: Station | None,
    environment: language.Environment,
    cache: language.LineCache,
) -> CheckedText:
    if text.name.endswith(".icr"):
        return CheckedText(text, compile_program(text, cell, station).diagnostics)
    compiled = language.compile(text.text, environment, text.name, cache)
    missing = () if compiled.icr is None else unbound(compiled.icr, text, cell, station)
    return CheckedText(text, (*compiled.diagnostics, *missing), compiled.tasks, compiled.variables)
