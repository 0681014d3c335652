"""Opening a project with texts that have not been saved: they count instead of the files."""

from collections.abc import Mapping
from functools import partial
from pathlib import Path, PurePosixPath

from ropsim.core import SourceText
from ropsim.userfiles import UNREADABLE, read_project_text
from ropsim.workbench.projects.opening import (
    CELL_FILE,
    PROGRAM_ENDINGS,
    assembled,
    no_cell_file,
    program_files,
)
from ropsim.workbench.projects.project import Project, ProjectError
from ropsim.workbench.robots.robot_files import Reading
from ropsim.workbench.tasks.point_texts import read_point_texts
from ropsim.workbench.tasks.task_texts import read_task_texts
from ropsim.workbench.workspace.workspace import Workspace


def open_overlaid(folder: Path, unsaved: Mapping[str, str], workspace: Workspace | None = None) -> Project:
    """Return the project in a folder as it would be if some texts were saved; no file is written.

    Spans name the texts as `unsaved` does: by their place in the project.

    Args:
        folder: of the project.
        unsaved: texts by their place, `cell.toml`, `programs/NAME` or `kb/NAME.pl`; others are left out.
        workspace: that has read it before, so that only results for changed texts are computed.

    Raises:
        ProjectError: there is no cell file, or the folder may not be read.
    """
    try:
        names = {f"programs/{path.name}" for path in program_files(folder)}
        names |= {name for name in unsaved if _is_program(PurePosixPath(name))}
        if CELL_FILE not in unsaved and not (folder / CELL_FILE).is_file():
            raise ProjectError(no_cell_file(folder))
        programs = {PurePosixPath(name).name: _read(folder, name, unsaved) for name in sorted(names)}
        cell_file = _read(folder, CELL_FILE, unsaved)
        text_of = partial(_read, folder, unsaved=unsaved)
        tasks, points = read_task_texts(folder, unsaved), read_point_texts(folder)
        return assembled(folder, cell_file, programs, text_of, workspace or Workspace(), tasks, points)
    except OSError as error:
        message = f"`{folder}` cannot be opened: {error.strerror or error}"
        raise ProjectError(
            UNREADABLE.at(None, message, hint="look at the folder and its permissions")
        ) from error


def _is_program(place: PurePosixPath) -> bool:
    return place.parent == PurePosixPath("programs") and place.suffix in PROGRAM_ENDINGS


def _read(folder: Path, name: str, unsaved: Mapping[str, str]) -> Reading:
    if name in unsaved:
        return SourceText(name, unsaved[name]), ()
    return read_project_text(folder, name)
