"""Programs after compilation, from task text or from ICR text."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from ropsim import icr, language, program
from ropsim.core import Diagnostic, SourceText, did_you_mean, frozen_dataclass
from ropsim.model import Cell, Station
from ropsim.workbench.environment import environment_of
from ropsim.workbench.project_diagnostics import UNBOUND


@frozen_dataclass
class CompiledProgram:
    """One program.

    Attributes:
        source: its text.
        program: structured program; None for an ICR text.
        icr: executable program; None where there is none.
        diagnostics: findings, in order of place.
    """

    source: SourceText
    program: program.Program | None
    icr: icr.Program | None
    diagnostics: tuple[Diagnostic, ...]


@frozen_dataclass
class CompiledProject:
    """All programs of a project by name, and every finding."""

    programs: Mapping[str, CompiledProgram]
    diagnostics: tuple[Diagnostic, ...]


def compile_program(text: SourceText, cell: Cell | None, station: Station | None = None) -> CompiledProgram:
    """Return the compiled form of a task text or an ICR text (by its ending).

    Args:
        text: of the program.
        cell: None for a program without one.
        station: that runs it; None for the first one of the cell.
    """
    if not text.name.endswith(".icr"):
        compiled = language.compile(text.text, environment_of(cell, station), name=text.name)
        findings = compiled.diagnostics
        if compiled.icr is not None and not any(one.is_error for one in findings):
            findings = (*findings, *icr.verify(compiled.icr))
            findings = (*findings, *unbound(compiled.icr, text, cell, station))
        return CompiledProgram(text, compiled.program, compiled.icr, findings)
    code, findings = icr.read_text(text.text, text.name)
    if code is not None:
        findings = (*findings, *icr.verify(code), *unbound(code, text, cell, station))
    return CompiledProgram(text, None, code, findings)


def found_in(programs: Mapping[str, CompiledProgram]) -> tuple[Diagnostic, ...]:
    """Return the findings of programs by station, each once, text after text."""
    texts: dict[str, dict[str, tuple[Diagnostic, ...]]] = {}
    for station, one in programs.items():
        texts.setdefault(one.source.name, {})[station] = one.diagnostics
    return tuple(found for stations in texts.values() for found in found_at(stations))


def found_at(stations: Mapping[str, Sequence[Diagnostic]]) -> tuple[Diagnostic, ...]:
    """Return what was found in one text at the stations that run it, each finding once, in order of place.

    What was not found at all of them has a note that says at which it was.

    Args:
        stations: findings by the name of the station.
    """
    if len(stations) == 1:
        return tuple(found for findings in stations.values() for found in dict.fromkeys(findings))
    first: dict[tuple[object, ...], Diagnostic] = {}
    where: dict[tuple[object, ...], dict[str, None]] = {}
    for name, findings in stations.items():
        for one in findings:
            said = (one.code, one.span, one.message)  # hints list what the station has instead
            first.setdefault(said, one)
            where.setdefault(said, {})[name] = None
    told = (
        one if len(where[said]) == len(stations) else replace(one, notes=(*one.notes, _at_only(where[said])))
        for said, one in first.items()
    )
    return tuple(sorted(told, key=_place))


def _at_only(stations: Collection[str]) -> str:
    names = ", ".join(f"`{name}`" for name in stations)
    return f"at station{'s' if len(stations) > 1 else ''} {names} only"


def _place(found: Diagnostic) -> tuple[bool, int, int]:
    """Return by what findings are put in order; those without a place are the last."""
    return (False, found.span.line, found.span.column) if found.span else (True, 0, 0)


def unbound(
    code: icr.Program, text: SourceText, cell: Cell | None, station: Station | None
) -> tuple[Diagnostic, ...]:
    """Return the channels and tools that a program names and its station does not have (rule V11).

    Args:
        code: the program.
        text: where it comes from, for places.
        cell: None for a program without one.
        station: that runs it; None for the first one of the cell.
    """
    if cell is None:
        return ()
    station = station or cell.first
    signals = [("signals", "IO", channel.name, tuple(cell.signals)) for channel in code.channels]
    tools = [
        ("tools", "TOOLDEF", tool.name, tuple(station.tools)) for tool in code.tools if tool.pose is None
    ]
    return tuple(
        UNBOUND.at(
            code.declared_at.get(f"{record} {name}") or language.named_at(text, name),
            f"`{code.name}` names `{name}`, which is not under [{table}]",
            hint=did_you_mean(name, known) or f"add `[{table}.{name}]` to cell.toml",
        )
        for table, record, name, known in (*signals, *tools)
        if name not in known
    )
