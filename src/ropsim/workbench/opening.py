"""Opening a project: from a path to cell and program texts."""

from dataclasses import replace
from pathlib import Path

from ropsim.core import Diagnostic, SourceText
from ropsim.model import Cell
from ropsim.workbench.cell_file import read_cell
from ropsim.workbench.project import Project, ProjectError
from ropsim.workbench.project_diagnostics import NO_PROJECT, UNREADABLE
from ropsim.workbench.text_file import missing, read_text_file

PROGRAM_ENDINGS = (".task", ".icr")


def open_project(path: str | Path) -> Project:
    """Return the project at a path: a folder, its `cell.toml`, or one of its programs.

    A program file outside a project folder gives a project without a cell: it can be checked, not run.

    Raises:
        ProjectError: nothing is there, it is no project, or it may not be read.
    """
    try:
        return _open(Path(path), path)
    except OSError as error:  # a folder without permission, a name that is too long
        message = f"`{error.filename or path}` cannot be opened: {error.strerror or error}"
        raise ProjectError(
            UNREADABLE.at(None, message, hint="look at the path and its permissions")
        ) from error


def _open(place: Path, path: str | Path) -> Project:
    if not place.exists():
        raise ProjectError(missing(place, str(path)))
    if place.is_dir():
        return _read_folder(place)
    if place.name == "cell.toml":
        return _read_folder(place.parent)
    if place.suffix in PROGRAM_ENDINGS:
        folder = place.parent.parent
        if place.parent.name == "programs" and (folder / "cell.toml").is_file():
            return _only(_read_folder(folder), place)
        text, findings = read_text_file(place, str(path))
        return Project(place.parent, None, {place.stem: text} if text else {}, None, findings)
    message = f"`{path}` is neither a folder, a `cell.toml` nor a program ({' or '.join(PROGRAM_ENDINGS)})"
    raise ProjectError(NO_PROJECT.at(None, message))


def _only(project: Project, program: Path) -> Project:
    """Return the project with one program only, which is then its default program."""
    wanted = {name: text for name, text in project.sources.items() if Path(text.name).name == program.name}
    cell = project.cell
    if cell is not None and wanted:
        cell = replace(cell, program=next(iter(wanted)))
    return replace(project, cell=cell, sources=wanted)


def _read_folder(folder: Path) -> Project:
    cell_path = folder / "cell.toml"
    if not cell_path.is_file():
        raise ProjectError(
            NO_PROJECT.at(None, f"`{folder}` has no `cell.toml`", hint="see docs/reference/cell-file.md")
        )
    cell_text, findings = read_text_file(cell_path, str(cell_path))
    cell: Cell | None = None
    if cell_text is not None:
        cell, cell_findings = read_cell(cell_text, folder.resolve().name)
        findings = (*findings, *cell_findings)
    sources, source_findings = _read_programs(folder / "programs")
    return Project(folder, cell, sources, cell_text, (*findings, *source_findings))


def _by_ending(path: Path) -> tuple[bool, Path]:
    return path.suffix != PROGRAM_ENDINGS[0], path


def _read_programs(folder: Path) -> tuple[dict[str, SourceText], tuple[Diagnostic, ...]]:
    sources: dict[str, SourceText] = {}
    findings: tuple[Diagnostic, ...] = ()
    # a task comes before code of the same name, which is most likely compiled from an older state of it
    paths = sorted(folder.iterdir(), key=_by_ending) if folder.is_dir() else []
    for path in paths:
        if path.suffix in PROGRAM_ENDINGS and path.is_file():
            text, found = read_text_file(path, str(path))
            findings += found
            if text is not None:
                sources[path.stem if path.stem not in sources else path.name] = text
    return sources, findings
