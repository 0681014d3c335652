"""Folders among which the user chooses a project: names below a few places, nothing of their contents."""

import contextlib
import os
from collections.abc import Sequence
from pathlib import Path

from ropsim.studio.texts.project_files import CELL
from ropsim.studio.wire.messages import Folders, FolderState

MOST = 500
"""Number of folders of a place that are listed, the first by name."""


def places_of(project: Path) -> tuple[Path, ...]:
    """Return the places below which folders are listed: that of the projects, and the home of the user.

    Args:
        project: folder of the project that is open; the one around it has the projects, unless it is the
            root of the file system.
    """
    around = project.resolve().parent
    found = [around] if around != around.parent else []
    with contextlib.suppress(RuntimeError):  # a user without a home
        found.append(Path.home().resolve())
    return tuple(found)


def folders_in(wanted: str, places: Sequence[Path]) -> Folders:
    """Return the folders in a place; hidden ones are left out.

    Args:
        wanted: requested path; empty, or not below one of the places, stands for the first of these.
        places: below which folders are listed.
    """
    place = _allowed(wanted, places)
    if place is None:
        return Folders("", "", ())
    found: list[FolderState] = []
    with contextlib.suppress(OSError):  # it was removed, or is not readable
        with os.scandir(place) as entries:
            names = sorted(one.name for one in entries if _is_shown(one, places))
        found = [_state(place / name) for name in names[:MOST]]
    parent = place.parent if _is_below(place.parent, places) else None
    return Folders(str(place), str(parent) if parent else "", tuple(found))


def _allowed(wanted: str, places: Sequence[Path]) -> Path | None:
    with contextlib.suppress(OSError, RuntimeError, ValueError):  # an invalid path, or links in a circle
        place = Path(wanted).expanduser().resolve() if wanted else None
        if place and place.is_dir() and _is_below(place, places):
            return place
    return places[0] if places else None


def _is_shown(entry: "os.DirEntry[str]", places: Sequence[Path]) -> bool:
    with contextlib.suppress(OSError):
        return not entry.name.startswith(".") and entry.is_dir() and _is_below(Path(entry).resolve(), places)
    return False


def _is_below(place: Path, places: Sequence[Path]) -> bool:
    return any(place.is_relative_to(one) for one in places)


def _state(folder: Path) -> FolderState:
    return FolderState(folder.name, str(folder), project=_is_file(folder / CELL))


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:
        return False
