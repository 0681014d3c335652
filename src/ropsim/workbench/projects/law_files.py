"""The files of controllers that a project names: read, checked and put into its cell."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from ropsim.cellfile import controller_key_in_cell_file
from ropsim.core import Diagnostic, SourceText, frozen_dataclass
from ropsim.model import Cell, ControllerFile, ControllerModel, ProjectModule, Station
from ropsim.userfiles import Trust, trust_in
from ropsim.workbench.projects.imported_modules import imported_modules
from ropsim.workbench.robots.robot_files import TextOf


@frozen_dataclass
class WithLaws:
    """A cell whose controllers from files have been read.

    Attributes:
        cell: the cell.
        texts: of the files, by their paths in the project.
        findings: errors in them, and modules that may not run.
    """

    cell: Cell
    texts: Mapping[str, SourceText]
    findings: tuple[Diagnostic, ...]


def has_law_files(cell: Cell) -> bool:
    """Return whether a station of a cell has its joint controller or another entity in a file."""
    return any(_files(one.controller) for one in cell.stations.values())


def with_law_files(folder: Path, cell: Cell, cell_text: SourceText, text_of: TextOf) -> WithLaws:
    """Return a cell with the texts of the files of its controllers; nothing of them is run.

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
        for keys, file in _files(station.controller).items():
            text, found = text_of(file.path)
            place = controller_key_in_cell_file(cell_text, name, *keys)
            if text is not None:
                is_trusted = file.is_code and trust_in(folder) is Trust.GIVEN
                texts[file.path] = text
                read = replace(file, text=text.text, is_trusted=is_trusted)
                if file.is_code:
                    imported, problems = imported_modules(file.path, text, text_of)
                    texts |= imported
                    modules = tuple(ProjectModule(path, one.text) for path, one in imported.items())
                    read, found = replace(read, modules=modules), (*found, *problems)
                stations[name] = _with_file(stations[name], keys, read)
                found = (*found, *_findings(keys, read, text, stations[name]))
            findings += [one if one.span is not None else replace(one, span=place) for one in found]
    made = replace(cell, stations=stations) if texts else cell
    return WithLaws(made, texts, tuple(dict.fromkeys(findings)))


def _files(controller: ControllerModel) -> dict[tuple[str, ...], ControllerFile]:
    """Return the files of a controller, by the keys that name them."""
    files: dict[tuple[str, ...], ControllerFile] = {}
    if isinstance(controller.gains, ControllerFile):
        files["file",] = controller.gains
    return files | {("entities", one.entity.value): one.file for one in controller.entities}


def _with_file(station: Station, keys: tuple[str, ...], file: ControllerFile) -> Station:
    controller = station.controller
    if keys == ("file",):
        return replace(station, controller=replace(controller, gains=file))
    entities = (
        replace(one, file=file) if one.entity.value == keys[-1] else one for one in controller.entities
    )
    return replace(station, controller=replace(controller, entities=tuple(entities)))


def _findings(
    keys: tuple[str, ...], file: ControllerFile, text: SourceText, station: Station
) -> tuple[Diagnostic, ...]:
    from ropsim.controller import (  # it generates code, which few projects need
        JOINT_CONTROLLER,
        law_file_findings,
        untrusted,
    )

    found = law_file_findings(file, text, station.controller, station.robot)
    entry = JOINT_CONTROLLER if keys == ("file",) else keys[-1]
    return (*found, untrusted(file, entry)) if file.is_code and not file.is_trusted else found
