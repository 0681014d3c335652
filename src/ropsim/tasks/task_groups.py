"""Tasks in the order of lists: of the project, of the user, then of the library by purpose."""

from collections.abc import Iterable, Mapping
from pathlib import PurePosixPath

from ropsim.tasks.kinds import Layer
from ropsim.tasks.terms.known_task import KnownTask

OURS, YOURS = "", "yours"
"""Groups of the tasks of the project and of the user's own folder; no file of the library has such a name."""

GROUPS: Mapping[str, str] = {
    OURS: "Of this project",
    YOURS: "Yours, in all your projects",
    "pick": "Pick and place",
    "pallet": "Pallets",
    "process": "Work on parts",
    "machine": "Machines",
    "grip": "Grip and release, straight to the part",
    "palletize": "Patterns as printed in the paper, straight to the parts",
}
"""Titles of groups in their order; groups of the library have the names of its files.

A file of the library that is not named here has its name for a title, and comes last.
"""


def title_of(group: str) -> str:
    """Return the title above the tasks of a group."""
    return GROUPS.get(group, group)


def group_of(task: KnownTask) -> str:
    """Return the group of a task, mostly a key of `GROUPS`."""
    match task.layer:
        case Layer.PROJECT:
            return OURS
        case Layer.USER:
            return YOURS
        case Layer.LIBRARY:
            return PurePosixPath(task.span.source).stem


def grouped(tasks: Iterable[KnownTask]) -> Mapping[str, tuple[KnownTask, ...]]:
    """Return tasks by their groups, both in the order of lists; groups without a task are left out."""
    found: dict[str, list[KnownTask]] = {group: [] for group in GROUPS}
    for task in tasks:
        found.setdefault(group_of(task), []).append(task)
    return {group: tuple(some) for group, some in found.items() if some}
