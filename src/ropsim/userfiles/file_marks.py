"""Marks of the files of a project, by which it is known again where its folder has been moved."""

import contextlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TypeAlias

CELL = "cell.toml"
Mark: TypeAlias = tuple[int, int, int, int]
"""Number and last change of the file [ns], last change of its content [ns], and size [bytes]."""
_NUMBERS = 4


def marks_of(folder: Path, names: Iterable[str]) -> dict[str, Mark]:
    """Return the marks of those files of a project that are there, and of `cell.toml`."""
    found: dict[str, Mark] = {}
    for name in {CELL, *names}:
        with contextlib.suppress(OSError, ValueError):
            facts = (folder / name).stat()
            found[name] = (facts.st_ino, facts.st_ctime_ns, facts.st_mtime_ns, facts.st_size)
    return found


def read_marks(found: object) -> dict[str, Mark]:
    """Return the marks that a document holds; none where it holds something else."""
    if not isinstance(found, dict):
        return {}
    marks: dict[str, Mark] = {}
    for name, mark in found.items():
        if isinstance(mark, list) and len(mark) == _NUMBERS and all(isinstance(one, int) for one in mark):
            marks[str(name)] = (mark[0], mark[1], mark[2], mark[3])
    return marks


def has_moved(marks: Mapping[str, Mark], before: Path, now: Path) -> bool:
    """Return whether a folder holds the files that another one held, and that one does not any more.

    A move within a file system keeps number and last change of each file: one of them is enough. A move to
    another disk keeps the attributes of a copy: then `cell.toml` must have the same time and size, and not be
    at its former place. A project that is back at its former place has also moved.
    """
    return _is_of(marks, now) and (before == now or not _is_of(marks, before))


def _is_of(marks: Mapping[str, Mark], folder: Path) -> bool:
    here = marks_of(folder, marks)
    is_same_file = any(here.get(name, ())[:2] == mark[:2] for name, mark in marks.items())
    return is_same_file or (CELL in marks and here.get(CELL, ())[2:] == marks[CELL][2:])
