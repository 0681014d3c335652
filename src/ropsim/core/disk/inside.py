"""Files inside of a folder: no link leads out of it, and a save reaches its file by handle.

A path is resolved first. The place must lie in the folder, which may be reached by a link itself. Then each
folder on the way is opened in the one before it, without following links: a link that another program puts
there meanwhile is an error. Windows has no handles of folders: there the checked resolved path is used.
"""

import contextlib
import errno
import os
import stat
from collections.abc import Callable, Iterator
from pathlib import Path, PurePath, PureWindowsPath

from ropsim.core.catalogue import define
from ropsim.core.diagnostic import Diagnostic, Severity
from ropsim.core.disk.files import on_disk, replace_file
from ropsim.core.disk.handles import closed_on_error, stream_of
from ropsim.core.disk.temporary_file import temporary_file
from ropsim.core.span import Span

_BY_HANDLE = os.open in os.supports_dir_fd and os.rename in os.supports_dir_fd
_NOFOLLOW, _BINARY = getattr(os, "O_NOFOLLOW", 0), getattr(os, "O_BINARY", 0)
_FOLDER = os.O_RDONLY | getattr(os, "O_DIRECTORY", 0)
_READ = os.O_RDONLY | _BINARY | _NOFOLLOW | getattr(os, "O_NONBLOCK", 0)  # an empty pipe must not block
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | _BINARY | _NOFOLLOW
_NO_LINKS = (errno.EPERM, errno.ENOTSUP, errno.EOPNOTSUPP, errno.ENOSYS, errno.EMLINK)
"""Error numbers of file systems without hard links."""
OUTSIDE_PROJECT = define(
    "U962",
    "outside-project",
    Severity.ERROR,
    "a file of a project does not lie in the project folder",
    """
A project is complete in its folder, and a project from somebody else must not look around on your disk. One
rule holds for every file of a project, for reading and for writing: `cell.toml`, programs, robot files,
meshes, lists of points, texts of tasks and their manifest. A path may neither begin with `/` or a drive nor
contain `..`, and all links on it must stay in the folder. A link from one place of the project to another one
is fine, and so is a project folder that is reached by a link.

Copy the file into the project, robot files best into `robots/`, meshes into `geometry/`.

```toml
[robot]
model = "robots/my_arm.toml"
```
""",
)


class LeadsOutError(OSError):
    """A path leads out of its folder; `strerror` says how."""


def _nothing() -> None:
    """Allow the replacement."""


def place_inside(folder: Path, name: str | PurePath) -> Path:
    """Return where a path inside of a folder leads, all links followed; it need not exist.

    Raises:
        LeadsOutError: out of the folder.
        OSError: the path cannot be resolved.
    """
    root = os.path.realpath(folder)
    try:
        place = Path(os.path.realpath(folder / name))  # Path.resolve raises RuntimeError where links go round
    except ValueError as error:  # a zero byte
        raise OSError(errno.EINVAL, str(error)) from error
    if not place.is_relative_to(root):
        raise LeadsOutError(errno.EXDEV, "is a link that leads out of the project folder")
    return place


def stated_inside(folder: Path, path: str) -> Path:
    """Return the target of a path that is written in a file of the folder.

    It must be one on every system: neither absolute nor with a drive or `..`.

    Raises:
        LeadsOutError: out of the folder.
        OSError: the path cannot be resolved.
    """
    check_stated(path)
    return place_inside(folder, path)


def check_stated(path: str) -> None:
    """Make sure that a path written in a file of a folder does not lead out of it, as far as its text says.

    Raises:
        LeadsOutError: it is absolute, or has a drive or `..`.
    """
    strict = PureWindowsPath(path)  # understands both kinds of slash, and drives
    if strict.anchor or ".." in strict.parts:
        raise LeadsOutError(errno.EXDEV, "leads out of the project folder")


def read_inside(folder: Path, name: str | PurePath, most: int) -> bytes:
    """Return the content of an ordinary file inside of a folder, at most `most` bytes of it.

    Raises:
        LeadsOutError: the path leads out of the folder.
        OSError: the file does not exist, or cannot be read.
    """
    place = place_inside(folder, name)
    with _folder_of(folder, place) as around:
        handle = os.open(place.name if around is not None else place, _READ, dir_fd=around)
    with closed_on_error(handle):
        if not stat.S_ISREG(os.fstat(handle).st_mode):
            raise FileNotFoundError(errno.ENOENT, "is no ordinary file", str(name))
    with stream_of(handle, "rb") as stream:
        return stream.read(most)


def replace_inside(
    folder: Path, name: str | PurePath, content: bytes, may_replace: Callable[[], None] = _nothing
) -> None:
    """Write a file inside of a folder in one step; missing folders are made.

    A replaced file keeps its permissions. A link that stays inside remains, its target is replaced.

    Args:
        folder: root.
        name: path inside of it.
        content: of the file from now on.
        may_replace: called at the last moment, when the content is on the disk; raises an exception to forbid
            it.

    Raises:
        LeadsOutError: the path leads out of the folder.
        OSError: the file cannot be written, or there is something other than a file; nothing was changed.
    """
    place = place_inside(folder, name)
    with _folder_of(folder, place, _made) as around:
        if around is None:
            may_replace()
            replace_file(place, content)
            return
        mode = _mode(place.name, around)
        with temporary_file(around, content, mode, on_disk) as new:
            may_replace()
            os.replace(new, place.name, src_dir_fd=around, dst_dir_fd=around)
        with contextlib.suppress(OSError):  # some file systems cannot
            os.fsync(around)


def create_inside(folder: Path, name: str | PurePath, content: bytes) -> None:
    """Write a new file inside of a folder in one step; nothing that is there already is written over.

    Raises:
        LeadsOutError: the path leads out of the folder.
        FileExistsError: the file exists.
        OSError: the file cannot be written.
    """
    place = place_inside(folder, name)
    with _folder_of(folder, place, _made) as around:
        if around is None:
            os.close(os.open(place, _NEW, 0o666))
            replace_file(place, content)
            return
        with temporary_file(around, content, None, on_disk) as new:
            try:
                os.link(new, place.name, src_dir_fd=around, dst_dir_fd=around, follow_symlinks=False)
            except OSError as error:
                if error.errno not in _NO_LINKS:
                    raise
                os.close(os.open(place.name, _NEW, 0o666, dir_fd=around))
                os.replace(new, place.name, src_dir_fd=around, dst_dir_fd=around)
        with contextlib.suppress(OSError):
            os.fsync(around)


def _opened(part: str, around: int) -> int:
    """Open a folder inside of another one."""
    return os.open(part, _FOLDER | _NOFOLLOW, dir_fd=around)


def _made(part: str, around: int) -> int:
    """Open a folder inside of another one; make it where there is none."""
    with contextlib.suppress(FileExistsError):
        os.mkdir(part, dir_fd=around)
    return _opened(part, around)


@contextlib.contextmanager
def _folder_of(folder: Path, place: Path, enter: Callable[[str, int], int] = _opened) -> Iterator[int | None]:
    """Hold the folder of a resolved place by a handle; None on systems without handles of folders."""
    root = Path(os.path.realpath(folder))
    inside = place.relative_to(root)
    if enter is _made:
        root.mkdir(parents=True, exist_ok=True)
    if not _BY_HANDLE:
        if enter is _made:
            place.parent.mkdir(parents=True, exist_ok=True)
        yield None
        return
    handle = os.open(root, _FOLDER | _NOFOLLOW)
    try:
        for part in inside.parts[:-1]:
            inner = enter(part, handle)
            os.close(handle)
            handle = inner
        yield handle
    finally:
        os.close(handle)


def _mode(name: str, around: int) -> int | None:
    """Return the permissions of a file, None where there is none.

    Raises:
        OSError: it is no ordinary file.
    """
    try:
        mode = os.stat(name, dir_fd=around, follow_symlinks=False).st_mode
    except FileNotFoundError:
        return None
    if not stat.S_ISREG(mode):
        kind = errno.EISDIR if stat.S_ISDIR(mode) else errno.ELOOP if stat.S_ISLNK(mode) else errno.EINVAL
        raise OSError(kind, os.strerror(kind), name)
    return stat.S_IMODE(mode)


def outside_project(name: str, error: LeadsOutError, span: Span | None = None) -> Diagnostic:
    """Return the finding that a file does not lie in the project folder.

    Args:
        name: of the file, as messages use it.
        error: how its path leads out.
        span: where the path is written.
    """
    message = f"`{name[:200]}` {error.strerror}"
    return OUTSIDE_PROJECT.at(span, message, hint="copy the file into the project")
