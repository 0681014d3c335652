"""The files of a project that the studio shows as texts: which there are, and what is in them now."""

import contextlib
import os
import stat
from collections.abc import Iterable, Mapping
from pathlib import Path, PurePosixPath
from typing import TypeAlias

from ropsim.core import Diagnostic
from ropsim.studio.diagnostics import NO_PROJECT, StudioError
from ropsim.studio.document import LARGEST

CELL = "cell.toml"
PROGRAM_ENDINGS = (".task", ".icr")
ROBOT_ENDING = ".toml"
TASK_ENDING = ".pl"

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
    """Return the texts of a project: `cell.toml`, then programs, robot files and tasks, each by name."""
    places = {"programs": PROGRAM_ENDINGS, "robots": (ROBOT_ENDING,), "kb": (TASK_ENDING,)}
    names = [CELL, *(name for place, endings in places.items() for name in _inside(folder, place, endings))]
    found = ((name, _stamp(folder / name)) for name in names)
    return {name: stamp for name, stamp in found if stamp is not None}


def content(path: Path) -> bytes | None:
    """Return what is in a file, cut where no text is that long; None where it cannot be read."""
    try:
        with open(path, "rb", opener=_without_waiting) as stream:
            return stream.read(LARGEST + 1) if stat.S_ISREG(os.fstat(stream.fileno()).st_mode) else None
    except OSError:
        return None


def leaves_project(folder: Path, path: Path) -> bool:
    """Return whether a file is a link that leads out of the project."""
    # Path.resolve raises RuntimeError where links go round
    return not Path(os.path.realpath(path)).is_relative_to(os.path.realpath(folder))


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
    """Return document names by program name: without ending, but code beside a task of that name keeps it."""
    paths = [path for path in map(PurePosixPath, documents) if path.parts[:-1] == ("programs",)]
    names: dict[str, str] = {}
    for path in sorted(paths, key=lambda one: (one.suffix != PROGRAM_ENDINGS[0], one)):
        names[path.stem if path.stem not in names else path.name] = str(path)
    return names


def _without_waiting(path: str, flags: int) -> int:
    """Open a file; a pipe that nobody writes to is no reason to wait."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _inside(folder: Path, place: str, endings: tuple[str, ...]) -> list[str]:
    """Return the files with some endings in a folder of the project, by name."""
    try:
        inside = list((folder / place).iterdir())
    except OSError:
        return []
    return sorted(f"{place}/{path.name}" for path in inside if path.suffix in endings)


def _stamp(path: Path) -> Stamp | None:
    try:
        facts = path.stat()
    except OSError:
        return None
    if not stat.S_ISREG(facts.st_mode):
        return None
    return facts.st_mtime_ns, facts.st_size, facts.st_ino, facts.st_mode
