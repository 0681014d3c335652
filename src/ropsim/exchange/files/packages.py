"""Packages of ROS around a robot file: folders with a `package.xml`, searched from the file upwards."""

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from ropsim.core import read_bytes

MANIFEST = "package.xml"
"""The file that makes a folder a package (REP 149)."""
MOST_LEVELS = 8
"""Folders above a robot file that are searched at most."""
MOST_DEPTH = 3
"""Folders below each of these."""
MOST_FOLDERS = 3_000
"""Folders of one search."""
_LEFT_OUT = frozenset(("build", "install", "log", "node_modules", "__pycache__"))
_NAME = re.compile(rb"<name>\s*([^<\s]{1,200})\s*</name>")
_LONGEST = 200_000  # bytes of a manifest


class Packages(Mapping[str, str]):
    """Folders of packages by name, from the root folder on, with `/`; a name is searched at first request.

    Given folders come first. Then the folders above the robot file are searched, the nearest first: one is
    the package itself, or has it below it. A folder without a manifest is taken for the package of its
    own name if it lies above the robot file.
    """

    def __init__(self, root: Path, start: Path, top: Path, given: Mapping[str, str]) -> None:
        """Search from a folder upwards.

        Args:
            root: folder from which paths count.
            start: folder of the robot file, inside of the root.
            top: highest folder that is searched, above the start or equal.
            given: folders by package, from the root on.
        """
        self._root, self._given = root, dict(given)
        self._above = list(_above(start, top))
        self._found: dict[str, str | None] = {}
        self._asked: dict[str, None] = {}
        self._manifests: dict[str, Path] = {}
        self._visited: list[Path] = []
        self._levels = 0

    def __getitem__(self, name: str) -> str:
        """Return the folder of a package; raises KeyError where there is none."""
        if name in self._given:
            return self._given[name]
        if name not in self._found:
            place = self._search(name)
            self._found[name] = None if place is None else _from(self._root, place)
        found = self._found[name]
        if found is None:
            raise KeyError(name)
        return found

    def __contains__(self, name: object) -> bool:
        """Return whether there is a package, which counts as requested then."""
        if isinstance(name, str):
            self._asked.setdefault(name)
        return super().__contains__(name)

    def __iter__(self) -> Iterator[str]:
        """Return the names of the packages that were requested and found."""
        return iter((*self._given, *(name for name, place in self._found.items() if place is not None)))

    def __len__(self) -> int:
        """Return how many packages were requested and found."""
        return sum(1 for _ in self)

    @property
    def asked(self) -> tuple[str, ...]:
        """Return the names of the packages that were requested, found or not, in order."""
        return tuple(self._asked)

    @property
    def unasked(self) -> tuple[str, ...]:
        """Return the names of the given packages that were not requested."""
        return tuple(name for name in self._given if name not in self._asked)

    @property
    def searched(self) -> tuple[Path, ...]:
        """Return the searched folders, if a package is missing: one may come in them."""
        return tuple(self._visited) if None in self._found.values() else ()

    def _search(self, name: str) -> Path | None:
        while name not in self._manifests and self._levels < len(self._above):
            for place in self._folders(self._above[self._levels]):
                found = package_name(place)
                if found is not None:
                    self._manifests.setdefault(found, place)
            self._levels += 1
        known = self._manifests.get(name)
        return known or next((place for place in self._above if place.name == name), None)

    def _folders(self, top: Path) -> Iterator[Path]:
        """Yield a folder and those below it, upper ones first."""
        level = [top]
        for depth in range(MOST_DEPTH + 1):
            for place in level:
                if len(self._visited) >= MOST_FOLDERS:
                    return
                self._visited.append(place)
                yield place
            if depth < MOST_DEPTH:
                level = [below for place in level for below in _below(place)]


def own_package(start: Path, top: Path) -> Path | None:
    """Return the nearest folder with a manifest from `start` up to `top`; None where there is none."""
    return next((place for place in _above(start, top) if (place / MANIFEST).is_file()), None)


def package_name(folder: Path) -> str | None:
    """Return the name of the package in a folder; None for a folder that is none."""
    try:
        with os.scandir(folder) as entries:
            if not any(one.name == MANIFEST and one.is_file() for one in entries):
                return None
        match = _NAME.search(read_bytes(folder / MANIFEST, _LONGEST))
    except OSError:
        return None
    return match.group(1).decode("utf-8", "replace") if match else folder.name


def _above(start: Path, top: Path) -> Iterator[Path]:
    """Yield a folder and those above it, up to `top` or a number of levels."""
    for place in (start, *start.parents)[:MOST_LEVELS]:
        yield place
        if place == top:
            return


def _below(place: Path) -> list[Path]:
    """Return the folders in a folder that may hold packages, by name; links are not followed."""
    try:
        with os.scandir(place) as entries:
            names = [one.name for one in entries if one.is_dir(follow_symlinks=False)]
    except OSError:
        return []
    return [place / name for name in sorted(names) if not name.startswith(".") and name not in _LEFT_OUT]


def _from(root: Path, place: Path) -> str:
    return os.path.relpath(place, root).replace(os.sep, "/")
