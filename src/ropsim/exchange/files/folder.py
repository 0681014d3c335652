"""The folder of a file, and the options of reading."""

import os
from collections.abc import Mapping
from dataclasses import field
from pathlib import Path
from types import MappingProxyType

from ropsim.core import frozen_dataclass, read_bytes
from ropsim.exchange.files.packages import Packages

NO_PACKAGES: Mapping[str, str] = MappingProxyType({})
SCHEMES = ("package://", "model://")
"""Beginnings of names that count from the folder of a package."""
_FILE = "file://"
_LARGEST = 20_000_000  # bytes of an included file


@frozen_dataclass
class RobotFolder:
    """The folder from which paths count, and the folders of the packages that robot files refer to.

    Attributes:
        root: the folder; None if no file may be read: then meshes are taken as named.
        packages: folder of each package, from the root on, with `/`.
        beside: folder of the robot file, from the root on, with `/`.
        open: folders whose files are read, in addition to found packages; empty text for the root.
        named_from: folder from which messages name files; None for full names.
        read: paths that were read or checked; not part of the content.
    """

    root: Path | None = None
    packages: Mapping[str, str] = field(default_factory=lambda: NO_PACKAGES)
    beside: str = ""
    open: tuple[str, ...] = ("",)
    named_from: Path | None = None
    read: set[str] = field(default_factory=set, compare=False, repr=False)

    def path(self, name: str, beside: str | None = None) -> str | None:
        """Return the path of a named file from the root on; nothing where it is outside of it.

        Args:
            name: `package://package/path`, `file://path`, `file:///package://package/path`, or a path
                relative to the file that names it.
            beside: folder of the file that names it; None for the folder of the robot file.
        """
        start = self.beside if beside is None else beside
        name = without_file_scheme(name).replace("\\", "/")
        for scheme in SCHEMES:
            if name.startswith(scheme):
                package, _, name = name[len(scheme) :].partition("/")
                if package not in self.packages:
                    return None
                start, name = self.packages[package], name.lstrip("/")
        if "\0" in name or ":" in name:
            return None
        if name.startswith("/"):
            return self._within(name)
        return _normal(f"{start}/{name}" if start else name)

    @property
    def files(self) -> tuple[Path, ...]:
        """Return the files that were read or checked, and folders whose new entries may be packages."""
        if self.root is None:
            return ()
        folders = self.packages.searched if isinstance(self.packages, Packages) else ()
        return (*(self.root / one for one in sorted(self.read)), *folders)

    def absence(self, name: str) -> tuple[str, str]:
        """Return why a named file has no path, a clause behind `is` or `are`, and the next action."""
        name = without_file_scheme(name)
        for scheme in SCHEMES:
            package = name.removeprefix(scheme).partition("/")[0]
            if name.startswith(scheme) and package not in self.packages:
                hint = f"name the folder of the package: `--package {package}=DIR`"
                return "not near to the robot file", hint
        return "outside of the folder of the robot file", "put it beside that file"

    def _within(self, name: str) -> str | None:
        """Return an absolute path from the root on."""
        if self.root is None:
            return None
        try:
            inside = os.path.relpath(name, self.root).replace(os.sep, "/")
        except ValueError:  # on another drive
            return None
        return None if inside.startswith("..") else inside

    def name_of(self, path: str) -> str:
        """Return the name by which messages speak of a file: from `named_from` on if it is in there."""
        if self.root is None:
            return path
        place = self.root / path
        inside = self.named_from is not None and place.is_relative_to(self.named_from)
        return str(place.relative_to(self.named_from) if self.named_from and inside else place)

    def has(self, path: str) -> bool:
        """Return whether a file is there, and not by a link that leads out of the open folders."""
        return self.root is None or self._file(path) is not None

    def size(self, path: str) -> int:
        """Return the bytes of a file in the folder; 0 where it is not there, or no file may be read."""
        place = None if self.root is None else self._file(path)
        return place.stat().st_size if place else 0

    def names_beside(self, ending: str) -> tuple[str, ...]:
        """Return the sorted names of the files with an ending in the folder of the robot file."""
        if self.root is None:
            return ()
        try:
            with os.scandir(self.root / self.beside) as entries:
                return tuple(sorted(one.name for one in entries if one.name.lower().endswith(ending)))
        except OSError:
            return ()

    def text(self, path: str) -> str | None:
        """Return the text of a file in the folder; None if it is missing, too large or not UTF-8."""
        place = self._file(path)
        try:
            if place is None or place.stat().st_size > _LARGEST:
                return None
            return read_bytes(place, _LARGEST).decode("utf-8-sig")
        except (OSError, UnicodeDecodeError):
            return None

    def _file(self, path: str) -> Path | None:
        if self.root is None:
            return None
        self.read.add(path)
        try:
            place = Path(os.path.realpath(self.root / path))
            inside = any(place.is_relative_to(os.path.realpath(self.root / one)) for one in self._open())
            inside = inside and place.is_relative_to(os.path.realpath(self.root))  # packages may be links
            return place if inside and place.is_file() else None
        except (OSError, ValueError):
            return None

    def _open(self) -> tuple[str, ...]:
        return (*self.open, *self.packages.values())


def without_file_scheme(name: str) -> str:
    """Return a name without `file://`, which may stand before `package://`, as in `file:///$(find arm)`."""
    path = name.removeprefix(_FILE)
    inner = path.lstrip("/")
    return inner if inner.startswith(SCHEMES) else path


def _normal(path: str) -> str | None:
    """Return a path without `.` and `..`; nothing where it leads out."""
    parts: list[str] = []
    for part in path.split("/"):
        if part == "..":
            if not parts:
                return None
            parts.pop()
        elif part not in ("", "."):
            parts.append(part)
    return "/".join(parts) or None


NO_ARGUMENTS: Mapping[str, str] = MappingProxyType({})


@frozen_dataclass
class ReadOptions:
    """Options of a reader.

    Attributes:
        tip: name of the link that carries the tool; None for the one that is recognised.
        folder: where meshes and included files are.
        arguments: of a xacro file, by name.
    """

    tip: str | None = None
    folder: RobotFolder = RobotFolder()
    arguments: Mapping[str, str] = field(default_factory=lambda: NO_ARGUMENTS)


STANDARD = ReadOptions()
"""The recognised tip, mesh paths unchanged, no arguments."""
