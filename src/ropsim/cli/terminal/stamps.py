"""Which files of a project have changed: by time and size, and by content where these may deceive."""

import hashlib
import os
import stat
from collections.abc import Iterator, Mapping
from pathlib import Path

from ropsim.core import frozen_dataclass, read_bytes

SETTLED = 2_000_000_000
"""A file that is older than this when it is read changes its time with its content [ns]."""

MOST_FILES = 2000
"""Further files of a folder are not watched."""

_LEFT_OUT = frozenset(("out", "node_modules", "__pycache__"))


@frozen_dataclass
class Stamp:
    """Identity of a file's content.

    Attributes:
        time: of its last change [ns].
        size: in bytes.
        digest: SHA-256 of its content; empty where it cannot be read.
        is_settled: whether another content would have another time.
    """

    time: int
    size: int
    digest: str
    is_settled: bool


Stamps = Mapping[Path, Stamp]


def stamps(path: Path, now: int, before: Stamps) -> Stamps:
    """Return the stamps of a file, or of all files of a folder but results and hidden ones.

    Args:
        path: of a project or a file.
        now: time of the clock that files are stamped by [ns].
        before: earlier stamps; files that are unchanged are not read again.
    """
    found = {}
    for one in _files(path):
        try:
            facts = one.stat()
        except OSError:
            continue
        old = before.get(one)
        if old and old.is_settled and (old.time, old.size) == (facts.st_mtime_ns, facts.st_size):
            found[one] = old
            continue
        is_settled = facts.st_mtime_ns < now - SETTLED
        digest = _digest(one) if stat.S_ISREG(facts.st_mode) else ""  # a pipe would keep who reads it
        found[one] = Stamp(facts.st_mtime_ns, facts.st_size, digest, is_settled)
    return found


def contents(of: Stamps) -> Mapping[Path, str]:
    """Return the content of each file, to be compared for changes."""
    return {path: stamp.digest for path, stamp in of.items()}


def _files(path: Path) -> Iterator[Path]:
    if not path.is_dir():
        yield path
        return
    count = 0
    for folder, inner, names in os.walk(path):
        inner[:] = sorted(name for name in inner if name not in _LEFT_OUT and not name.startswith("."))
        for name in sorted(names):
            if not name.startswith("."):
                count += 1
                if count > MOST_FILES:
                    return
                yield Path(folder) / name


def _digest(path: Path) -> str:
    try:
        return hashlib.sha256(read_bytes(path)).hexdigest()
    except OSError:
        return ""
