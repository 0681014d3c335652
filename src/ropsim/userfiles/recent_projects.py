"""The projects that were open last: a list of the user, kept outside of the projects."""

import contextlib
import json
from pathlib import Path

from ropsim.core import read_bytes, replace_private_file, state_folder

VERSION = 1
MOST = 12
"""Projects that are remembered."""


def recent_projects() -> tuple[Path, ...]:
    """Return the folders of the projects that were open last and still exist, newest first."""
    return tuple(folder for folder in _listed() if _is_project(folder))


def remember_project(folder: Path) -> None:
    """Put a project folder at the head of the list; a disk that refuses is no reason to fail."""
    this = folder.resolve()
    folders = [this, *(one for one in _listed() if one != this)][:MOST]
    document = {"version": VERSION, "folders": [str(one) for one in folders]}
    with contextlib.suppress(OSError, UnicodeError):
        replace_private_file(_place(), json.dumps(document, indent=2).encode())


def _is_project(folder: Path) -> bool:
    try:
        return (folder / "cell.toml").is_file()
    except OSError:
        return False


def _place() -> Path:
    return state_folder() / "recent.json"


def _listed() -> tuple[Path, ...]:
    """Return the list; nothing where it is absent, damaged or of a newer ropsim."""
    try:
        document = json.loads(read_bytes(_place()))
    except (OSError, ValueError, RecursionError):
        return ()
    if not isinstance(document, dict) or document.get("version") != VERSION:
        return ()
    folders = document.get("folders")
    return tuple(Path(one) for one in folders if isinstance(one, str)) if isinstance(folders, list) else ()
