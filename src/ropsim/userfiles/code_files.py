"""Which files of a project folder are code that a trusted project may run."""

import os
import re
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

CODE_ENDINGS = frozenset({".py", ".pyc", ".fmu", ".so", ".dll", ".dylib", ".pyd", ".pl", ".pro", ".qlf"})
"""Python, FMUs, native libraries, Prolog for the native engine."""

_KNOWLEDGE = re.compile(r"kb/[^/]+\.pl")

SKIPPED = frozenset({"out", "node_modules", "__pycache__"})
"""Folders that are not part of a project's content; hidden ones are not either."""

MOST_ENTRIES = 20_000
"""Further entries are not read: no project is that large, but a home folder may be."""


def code_in(folder: Path) -> tuple[str, ...]:
    """Return the names of code files below a project folder, with `/`; links are not followed.

    The knowledge base `kb/*.pl` is none: it is read as data and never run, in a trusted folder neither.
    """
    names = (
        name
        for name in _names(folder)
        if PurePosixPath(name).suffix.lower() in CODE_ENDINGS and not _KNOWLEDGE.fullmatch(name)
    )
    return tuple(sorted(names))


def _names(folder: Path) -> Iterator[str]:
    seen = 0
    for place, folders, files in os.walk(folder):
        folders[:] = sorted(one for one in folders if one not in SKIPPED and not one.startswith("."))
        seen += len(files) + len(folders)
        if seen > MOST_ENTRIES:
            return
        for name in files:
            yield (Path(place) / name).relative_to(folder).as_posix()
