"""Programs after compilation, from task text or from ICR text, and the findings of one text."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import field, replace

from ropsim import icr, language
from ropsim.core import Diagnostic, SourceText, frozen_dataclass


@frozen_dataclass
class CompiledProgram:
    """One program.

    Attributes:
        source: its text.
        code: executable form; None where there is none.
        diagnostics: findings, in order of place.
    """

    source: SourceText
    code: language.Code | None
    diagnostics: tuple[Diagnostic, ...]

    @property
    def icr(self) -> icr.Program | None:
        """Return the executable program, which is made on the first request; None where there is none."""
        return self.code.program if self.code is not None else None


@frozen_dataclass
class CompiledProject:
    """All programs of a project by name, and every finding."""

    programs: Mapping[str, CompiledProgram]
    diagnostics: tuple[Diagnostic, ...]


def found_in(programs: Mapping[str, CompiledProgram]) -> tuple[Diagnostic, ...]:
    """Return the findings of programs by station, each once, text after text."""
    texts: dict[str, dict[str, tuple[Diagnostic, ...]]] = {}
    for station, one in programs.items():
        texts.setdefault(one.source.name, {})[station] = one.diagnostics
    return tuple(found for stations in texts.values() for found in found_at(stations))


def found_at(stations: Mapping[str, Sequence[Diagnostic]]) -> tuple[Diagnostic, ...]:
    """Return the findings in one text at the stations that run it, each finding once, in order of place.

    A finding that does not occur at all of them has a note with its stations.

    Args:
        stations: findings by the name of the station.
    """
    if len(stations) == 1:
        return tuple(found for findings in stations.values() for found in dict.fromkeys(findings))
    first: dict[tuple[object, ...], Diagnostic] = {}
    where: dict[tuple[object, ...], dict[str, None]] = {}
    for name, findings in stations.items():
        for one in findings:
            said = (one.code, one.span, one.message)  # hints depend on the station
            first.setdefault(said, one)
            where.setdefault(said, {})[name] = None
    station_notes = (
        one if len(where[said]) == len(stations) else replace(one, notes=(*one.notes, _at_only(where[said])))
        for said, one in first.items()
    )
    return tuple(sorted(station_notes, key=_place))


def _at_only(stations: Collection[str]) -> str:
    names = ", ".join(f"`{name}`" for name in stations)
    return f"at station{'s' if len(stations) > 1 else ''} {names} only"


def _place(found: Diagnostic) -> tuple[bool, int, int]:
    """Return the sort key of findings; findings without a place are last."""
    return (False, found.span.line, found.span.column) if found.span else (True, 0, 0)


@frozen_dataclass
class CheckedText:
    """Results for a program text in an editor.

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
