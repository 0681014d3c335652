"""The files of joint controllers that a project names: read, checked and put into its cell."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from ropsim.cellfile import law_file_in_cell_file
from ropsim.core import Diagnostic, SourceText, frozen_dataclass
from ropsim.model import Cell, LawFile, Station
from ropsim.userfiles import Trust, trust_in
from ropsim.workbench.robots.robot_files import TextOf


@frozen_dataclass
class WithLaws:
    """A cell whose joint controllers from files have been read.

    Attributes:
        cell: the cell.
        texts: of the files, by their paths in the project.
        findings: errors in them, and modules that may not run.
    """

    cell: Cell
    texts: Mapping[str, SourceText]
    findings: tuple[Diagnostic, ...]


def has_law_files(cell: Cell) -> bool:
    """Return whether a station of a cell has its joint controller in a file."""
    return any(isinstance(one.controller.gains, LawFile) for one in cell.stations.values())


def with_law_files(folder: Path, cell: Cell, cell_text: SourceText, text_of: TextOf) -> WithLaws:
    """Return a cell with the texts of the files of its joint controllers; nothing of them is run.

    Args:
        folder: of the project; modules run if it is trusted.
        cell: as its file says.
        cell_text: that file.
        text_of: reads a file of the project by its path inside.
    """
    texts: dict[str, SourceText] = {}
    findings: list[Diagnostic] = []
    stations = dict(cell.stations)
    for name, station in cell.stations.items():
        if isinstance(station.controller.gains, LawFile):
            stations[name], text, found = _read(folder, station, station.controller.gains, text_of)
            place = law_file_in_cell_file(cell_text, name)
            findings += [one if one.span is not None else replace(one, span=place) for one in found]
            if text is not None:
                texts[station.controller.gains.path] = text
    if stations == cell.stations:
        return WithLaws(cell, texts, tuple(findings))
    return WithLaws(replace(cell, stations=stations), texts, tuple(findings))


def _read(
    folder: Path, station: Station, file: LawFile, text_of: TextOf
) -> tuple[Station, SourceText | None, tuple[Diagnostic, ...]]:
    from ropsim.controller import (
        law_file_findings,
        untrusted,
    )  # with what generates code: few projects need it

    text, findings = text_of(file.path)
    if text is None:
        return station, None, findings
    is_trusted = file.is_code and trust_in(folder) is Trust.GIVEN
    read = replace(file, text=text.text, is_trusted=is_trusted)
    controller = replace(station.controller, gains=read)
    found = law_file_findings(read, text, controller, station.robot)
    if file.is_code and not is_trusted:
        found = (*found, untrusted(read))
    return replace(station, controller=controller), text, (*findings, *found)
