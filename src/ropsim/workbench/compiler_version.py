"""Which compiler this is: answers of another one are not taken."""

from functools import cache
from pathlib import Path

from ropsim.version import __version__

_PACKAGES = ("core", "flow", "icr", "language", "program", "prolog", "query", "spatial", "tasks", "workbench")
_ENDINGS = (".py", ".pl")
"""Of whose files an answer is made, and how their names end."""


@cache
def compiler_version() -> tuple[object, ...]:
    """Return the version of ropsim, and size and date of each module of the compiler.

    So an answer is made anew after every change of the compiler, also in a folder in which one works on it.
    """
    root = Path(__file__).parents[1]
    found = []
    for package in _PACKAGES:
        for path in sorted(one for one in (root / package).rglob("*") if one.suffix in _ENDINGS):
            state = path.stat()
            found.append((path.relative_to(root).as_posix(), state.st_size, state.st_mtime_ns))
    return __version__, *found
