"""The one door to the disk for everything below the workbench.

Reads whole files, replaces files so that a reader sees the old or the new content and never half
of it, and knows the user's cache folder.
"""

import os
import sys
import tempfile
from pathlib import Path


def read_bytes(path: Path) -> bytes:
    """Return the content of a file.

    Raises:
        OSError: the file cannot be read.
    """
    return path.read_bytes()


def replace_file(path: Path, content: bytes) -> None:
    """Write `content` to `path` in one step: a crash leaves the old file, never half a new one.

    Raises:
        OSError: the folder cannot be written.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        Path(name).chmod(0o666 & ~_umask())
        Path(name).replace(path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def cache_folder() -> Path:
    """Return the folder of generated code and other things that can be made again.

    `ROPSIM_CACHE_DIR` overrides the place that the operating system uses for caches.
    """
    override = os.environ.get("ROPSIM_CACHE_DIR")
    if override:
        return Path(override)
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA", str(Path.home() / "AppData" / "Local")))
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME", str(Path.home() / ".cache")))
    return base / "ropsim"


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
