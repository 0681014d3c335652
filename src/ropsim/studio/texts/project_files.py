"""The files of a project that the studio shows as texts: their names and present contents."""

import contextlib
import errno
import stat
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path, PurePosixPath
from typing import TypeAlias

from ropsim.core import Diagnostic, read_inside, remove_left_files
from ropsim.studio.diagnostics import NO_PROJECT, StudioError
from ropsim.studio.texts.document import LARGEST

CELL = "cell.toml"
PROGRAM_ENDINGS = (".task", ".icr")
ROBOT_ENDING = ".toml"
TASK_ENDING = ".pl"
_FOLDERS = ("programs", "robots", "kb", "points")
"""Folders of a project that the studio writes to."""

Stamp: TypeAlias = tuple[int, int, int, int]
"""Time of the last change [ns], size, number and permissions of a file: one of them changes with it."""


def project_folder(path: Path) -> Path:
    """Return the absolute folder of the project that a path names: folder, its `cell.toml`, or a program.

    Raises:
        StudioError: U950, there is none.
    """
    with contextlib.suppress(OSError, RuntimeError):  # a name that is too long, links that go round
        place = path.resolve()
        if place.name == CELL:
            place = place.parent
        elif place.parent.name == "programs" and place.suffix in PROGRAM_ENDINGS:
            place = place.parent.parent
        if path.exists() and ((place / CELL).exists() or stamps(place)):
            return place
        if path.exists():
            raise StudioError(_nothing_at(path, "is no project: it has no `cell.toml`"))
    raise StudioError(_nothing_at(path, "does not exist"))


def _nothing_at(path: Path, found: str) -> Diagnostic:
    hint = "`ropsim new my_cell` makes a project, `ropsim studio my_cell` opens it"
    return NO_PROJECT.at(None, f"`{path}` {found}", hint=hint)


def stamps(folder: Path) -> dict[str, Stamp]:
    """Return the texts of a project: `cell.toml`, then programs, robot files and tasks, each by name.

    Raises:
        OSError: the system cannot list the files.
    """
    places = {"programs": PROGRAM_ENDINGS, "robots": (ROBOT_ENDING,), "kb": (TASK_ENDING,)}
    names = [CELL, *(name for place, endings in places.items() for name in files_in(folder, place, endings))]
    found = ((name, stamp(folder / name)) for name in names)
    return {name: one for name, one in found if one is not None}


def present(folder: Path) -> dict[str, Stamp] | None:
    """Return the texts of a project; None where there is no project folder any more.

    A folder that is removed while it is read counts as removed: its existence is checked before and after.

    Raises:
        OSError: the system cannot list the files.
    """
    before = _identity(folder)
    found = stamps(folder) if before is not None else {}
    while (after := _identity(folder)) != before:  # another one has taken its place
        before, found = after, stamps(folder) if after is not None else {}
    return found if after is not None else None


def remove_leftovers(folder: Path) -> None:
    """Remove temporary files of a killed save from the folders of a project's texts."""
    for place in (folder, *(folder / name for name in _FOLDERS)):
        if not place.is_symlink():
            remove_left_files(place)


def content(folder: Path, name: str) -> bytes | None:
    """Return the content of a file of a project, cut at the maximum length; None without a file.

    Raises:
        LeadsOutError: it is a link that leads out of the project.
        OSError: it cannot be read.
    """
    with contextlib.suppress(FileNotFoundError, NotADirectoryError):
        return read_inside(folder, name, LARGEST + 1)
    return None


def is_text_of_project(name: str) -> bool:
    """Return whether a project may have a text of this name; it never leads out of the project."""
    path = PurePosixPath(name)
    match path.parts[:-1]:
        case ("programs",):
            return path.suffix in PROGRAM_ENDINGS
        case ("robots",):
            return path.suffix == ROBOT_ENDING
        case ("kb",):
            return path.suffix == TASK_ENDING
        case _:
            return name == CELL


def program_names(documents: Iterable[str]) -> Mapping[str, str]:
    """Return document names by program name: without ending, unless code and a task share the name."""
    paths = [path for path in map(PurePosixPath, documents) if path.parts[:-1] == ("programs",)]
    names: dict[str, str] = {}
    for path in sorted(paths, key=lambda one: (one.suffix != PROGRAM_ENDINGS[0], one)):
        names[path.stem if path.stem not in names else path.name] = str(path)
    return names


def files_in(folder: Path, place: str, endings: tuple[str, ...]) -> list[str]:
    """Return the files with some endings in a folder of the project, by name."""
    inside: list[Path] = []
    with _absence():
        inside = list((folder / place).iterdir())
    return sorted(f"{place}/{path.name}" for path in inside if path.suffix in endings)


def stamp(path: Path) -> Stamp | None:
    """Return the stamp of a file, None where there is none."""
    with _absence():
        facts = path.stat()
        if stat.S_ISREG(facts.st_mode):
            return facts.st_mtime_ns, facts.st_size, facts.st_ino, facts.st_mode
    return None


def _identity(folder: Path) -> tuple[int, int] | None:
    """Return the identity of a folder; None without one."""
    with _absence():
        facts = folder.stat()
        if stat.S_ISDIR(facts.st_mode):
            return facts.st_dev, facts.st_ino
    return None


@contextlib.contextmanager
def _absence() -> Iterator[None]:
    """Treat a missing file as an answer; other errors are raised."""
    try:
        yield
    except OSError as error:
        if error.errno not in (errno.ENOENT, errno.ENOTDIR, errno.ELOOP):
            raise
