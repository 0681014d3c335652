"""Opening a project: from a path to cell and program texts."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path, PurePath

from ropsim.cellfile import robot_files
from ropsim.controller import MODULE_NOT_TRUSTED
from ropsim.core import Diagnostic, SourceText
from ropsim.model import Cell
from ropsim.userfiles import UNREADABLE, code_in, inert_code, missing_file, read_project_text, read_text_file
from ropsim.workbench.project_diagnostics import NO_PROJECT
from ropsim.workbench.projects.law_files import has_law_files, with_law_files
from ropsim.workbench.projects.project import Project, ProjectError, cell_name
from ropsim.workbench.robots.robot_files import Reading, TextOf, read_robot_files, robots_read
from ropsim.workbench.tasks.point_texts import NO_POINTS, PointTexts, read_point_texts
from ropsim.workbench.tasks.task_texts import NO_TASKS, TaskTexts, read_task_texts
from ropsim.workbench.workspace.workspace import Workspace

CELL_FILE = "cell.toml"
PROGRAM_ENDINGS = (".task", ".icr")


def open_project(path: str | Path, workspace: Workspace | None = None) -> Project:
    """Return the project at a path: a folder, its `cell.toml`, or one of its programs.

    A program file outside a project folder makes a project without a cell: it can be checked, not run.

    Args:
        path: of the project.
        workspace: that has read it before, so that only results for changed texts are computed.

    Raises:
        ProjectError: nothing is there, it is no project, or it may not be read.
    """
    try:
        return _open(Path(path), path, workspace or Workspace())
    except OSError as error:  # a folder without permission, a name that is too long
        message = f"`{error.filename or path}` cannot be opened: {error.strerror or error}"
        raise ProjectError(
            UNREADABLE.at(None, message, hint="look at the path and its permissions")
        ) from error


def _open(place: Path, path: str | Path, workspace: Workspace) -> Project:
    if not place.exists():
        raise ProjectError(missing_file(place, str(path)))
    if place.is_dir():
        return _read_folder(place, workspace)
    if place.name == CELL_FILE:
        return _read_folder(place.parent, workspace)
    if place.suffix in PROGRAM_ENDINGS:
        if (folder := project_of(place)) is not None:
            return _only(_read_folder(folder, workspace), place)
        text, findings = read_text_file(place, str(path))
        sources = {place.stem: text} if text else {}
        return Project(place.parent, None, sources, None, findings, workspace=workspace)
    message = f"`{path}` is neither a folder, a `cell.toml` nor a program ({' or '.join(PROGRAM_ENDINGS)})"
    raise ProjectError(NO_PROJECT.at(None, message))


def project_of(program: Path) -> Path | None:
    """Return the folder of the project to which a program belongs; None for a file on its own."""
    folder = program.parent.parent
    return folder if program.parent.name == "programs" and (folder / CELL_FILE).is_file() else None


def _only(project: Project, program: Path) -> Project:
    """Return the project with one program only, which is then its default program."""
    wanted = {name: text for name, text in project.sources.items() if Path(text.name).name == program.name}
    cell = project.cell
    if cell is not None and wanted:
        if len(cell.stations) > 1:  # the others go on with their own programs
            return project
        station = replace(cell.first, program=next(iter(wanted)))
        cell = replace(cell, stations={station.name: station})
    return replace(project, cell=cell, sources=wanted)


def _read_folder(folder: Path, workspace: Workspace) -> Project:
    if not (folder / CELL_FILE).is_file():
        raise ProjectError(no_cell_file(folder))
    programs, read = _programs(folder), partial(_text, folder)
    cell_file = read(CELL_FILE)
    tasks = read_task_texts(folder, {}, lambda place: str(folder / place))
    points = read_point_texts(folder, lambda place: str(folder / place))
    project = assembled(folder, cell_file, programs, read, workspace, tasks, points)
    return replace(project, diagnostics=(*project.diagnostics, *_inert(folder, project.diagnostics)))


def _inert(folder: Path, found: Sequence[Diagnostic]) -> tuple[Diagnostic, ...]:
    """Return the hint on code of a project that is not run; nothing where errors name all of it already."""
    named = {one.data["file"] for one in found if one.code == MODULE_NOT_TRUSTED.code}
    return () if named.issuperset(code_in(folder)) else inert_code(folder)


def around_programs(
    folder: Path, cell_text: SourceText, text_of: TextOf, workspace: Workspace
) -> tuple[Diagnostic, ...]:
    """Return the findings of a project that stand in no text of a program, for a text of its cell file.

    Args:
        folder: of the project; its programs are read from the disk.
        cell_text: of `cell.toml`, saved or not.
        text_of: reads any other file of the project, by its path inside.
        workspace: that reads the project.
    """
    programs = _programs(folder)
    project = assembled(folder, (cell_text, ()), programs, text_of, workspace)
    return (*project.around_programs, *_inert(folder, project.around_programs))


def no_cell_file(folder: Path) -> Diagnostic:
    """Return the finding that a folder is no project."""
    return NO_PROJECT.at(None, f"`{folder}` has no `{CELL_FILE}`", hint="see docs/reference/cell-file.md")


def program_files(folder: Path) -> list[Path]:
    """Return the programs of a project folder, including unreadable ones: reading them reports the reason."""
    programs = folder / "programs"
    paths = programs.iterdir() if programs.is_dir() else ()
    return [path for path in paths if path.suffix in PROGRAM_ENDINGS and _is_program(path)]


def _is_program(path: Path) -> bool:
    """Return whether a path with the name of a program is one; folders and locks of editors are none.

    A lock is a hidden link into nowhere.
    """
    return path.is_file() or not (path.is_dir() or path.name.startswith("."))


def assembled(
    folder: Path,
    cell_file: Reading,
    programs: Mapping[str, Reading],
    text_of: TextOf,
    workspace: Workspace,
    tasks: TaskTexts = NO_TASKS,
    points: PointTexts = NO_POINTS,
) -> Project:
    """Return the project that a cell file and programs make.

    Args:
        folder: of the project.
        cell_file: content of `cell.toml`, or why it cannot be read.
        programs: the same of each program by its file name.
        text_of: the same of any other file of the project, by its path inside.
        workspace: that reads the project.
        tasks: texts of the tasks that its programs can call.
        points: texts of the lists of points that they can use.
    """
    cell_text, findings = cell_file
    cell: Cell | None = None
    laws: Mapping[str, SourceText] = {}
    robots = read_robot_files(folder, robot_files(cell_text), text_of)
    if cell_text is not None:
        read = workspace.cell(cell_text, cell_name(folder), robots_read(robots))
        lists = workspace.point_findings(cell_text, cell_name(folder), points)
        cell, findings = read.cell, (*findings, *read.diagnostics, *points.findings, *lists)
        if cell is not None and has_law_files(cell):
            with_laws = with_law_files(folder, cell, cell_text, text_of)
            cell, laws, findings = with_laws.cell, with_laws.texts, (*findings, *with_laws.findings)
    sources: dict[str, SourceText] = {}
    # a task comes before code of the same name, which is most likely compiled from an older state of it
    for name in sorted(map(PurePath, programs), key=_by_ending):
        text, found = programs[str(name)]
        findings = (*findings, *found)
        if text is not None:
            sources[name.stem if name.stem not in sources else name.name] = text
    return Project(folder, cell, sources, cell_text, findings, robots, tasks, points, workspace, laws)


def _programs(folder: Path) -> Mapping[str, Reading]:
    return {path.name: _text(folder, f"programs/{path.name}") for path in program_files(folder)}


def _text(folder: Path, name: str) -> Reading:
    return read_project_text(folder, name, str(folder / name))


def _by_ending(name: PurePath) -> tuple[bool, PurePath]:
    return name.suffix != PROGRAM_ENDINGS[0], name
