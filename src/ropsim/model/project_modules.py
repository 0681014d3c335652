"""Modules in Python of a project and their imports of each other; texts are read here, nothing is run."""

import ast
from collections.abc import Callable, Iterator
from pathlib import PurePosixPath

from ropsim.core import frozen_dataclass


@frozen_dataclass
class ProjectModule:
    """A module of the project that another one imports.

    Attributes:
        path: of its file in the project.
        text: of the file.
    """

    path: str
    text: str


@frozen_dataclass
class Import:
    """A statement that imports.

    Attributes:
        line: where it stands, from 1.
        level: number of dots before the name.
        name: of the module, with dots; empty for `from . import x`.
        names: that it takes from the module, which may be modules themselves.
    """

    line: int
    level: int
    name: str
    names: tuple[str, ...] = ()


def imports_in(text: str) -> tuple[Import, ...]:
    """Return the statements of a module that import, also inside of functions; none where it is no Python."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ()
    found = list[Import]()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found += [Import(node.lineno, 0, one.name) for one in node.names]
        elif isinstance(node, ast.ImportFrom):
            names = tuple(one.name for one in node.names)
            found.append(Import(node.lineno, node.level, node.module or "", names))
    return tuple(found)


def import_folders(importer: str, level: int) -> tuple[PurePosixPath, ...]:
    """Return the folders of the project in which a name is searched, in their order; none for one outside.

    A name without dots is searched in the folder of the module and then at the root of the project, before
    any installed package; one with dots from the folder of the module upwards.

    Args:
        importer: path of the module in the project.
        level: number of dots.
    """
    beside = PurePosixPath(importer).parent
    if level == 0:
        return (beside,) if beside == PurePosixPath() else (beside, PurePosixPath())
    if level - 1 > len(beside.parts):
        return ()
    return (beside if level == 1 else (beside / "x").parents[level - 1],)


def module_files(place: PurePosixPath) -> tuple[str, str]:
    """Return the files that a module at a place of the project may be: itself, or its package."""
    return f"{place}.py", str(place / "__init__.py")


def places_of(found: Import, folder: PurePosixPath) -> Iterator[PurePosixPath]:
    """Yield where modules lie that a statement may import from a folder: packages, then names in them."""
    place = folder
    for part in found.name.split(".") if found.name else ():
        place = place / part
        yield place
    yield from (place / name for name in found.names if name.isidentifier())


def file_at(place: PurePosixPath, is_there: Callable[[str], bool]) -> str:
    """Return the file of the module at a place; empty where there is none.

    Args:
        place: in the project.
        is_there: whether the project has a file.
    """
    return next((one for one in module_files(place) if is_there(one)), "")
