"""The one door to everything that is kept between processes because it can be made again.

Compiled kernels, Prolog's machine code and started images, and answers of the compiler lie in rooms of the
user's cache folder. Each entry is sealed; each room has a largest size, beyond which the least recently used
entries are removed. A process without this folder, or with a full or read-only disk, works without it: it
makes everything anew.

Two guards keep foreign machine code from being run:

- *Owner and permissions* keep strangers out: see `own_folder`. A folder in which another user
  can have written anything is not read at all.
- *The seal* finds damage and mix-ups: it is a digest of room, name and content, so that a file that was cut
  off, changed, or copied under another name is no entry. It is no signature. A secret key would add nothing:
  who can write into a folder of the user with permissions 0700 can read a key with permissions 0600.

An entry is read once, through the descriptor that was checked, and these bytes are used.
"""

import contextlib
from collections.abc import Callable, Iterator
from hashlib import sha256
from pathlib import Path

from ropsim.core.catalogue import define
from ropsim.core.diagnostic import Diagnostic, Severity
from ropsim.core.disk.own_folder import ForeignFolderError, OwnFolder
from ropsim.core.disk.turns import turn
from ropsim.core.disk.user_folders import CACHE_OVERRIDE, cache_folder, relative_cache_override

_SEAL = 32
"""Bytes of the digest in front of an entry."""
_TURN = "turn-"
"""Start of the names of the files by which processes take turns; they stay, empty."""
_TURNS = 64
"""Number of these files: two things of one file wait for each other, which costs time only."""
_findings: dict[str, Diagnostic] = {}
"""Why folders are not used in this process, by reason."""
FOREIGN_CACHE = define(
    "X918",
    "cache-not-your-own",
    Severity.WARNING,
    "others can have written into the cache folder: it is not used",
    """
Compiled code is kept in the cache folder and run from there. So it is used only where nobody else can have
put something into it: the folder and the folders in it belong to you, no other user can write to them, and
they are no links. Root does not use the cache of another user either.

Nothing is lost: code is compiled anew in each process, which takes longer. Remove the folder, or let
only yourself read and write it (`chmod 700`); `ROPSIM_CACHE_DIR` names another folder by an absolute path.
""",
)

NO_CACHE = define(
    "X919",
    "cache-not-writable",
    Severity.HINT,
    "compiled code cannot be kept for the next start",
    """
The cache folder cannot be made or written: it is read only, the disk is full, or the user has no home
folder. Everything works as usual, but each start compiles its code anew, which takes longer.
`ROPSIM_CACHE_DIR` names another folder by an absolute path.
""",
)


RELATIVE_CACHE = define(
    "X921",
    "cache-path-relative",
    Severity.WARNING,
    "`ROPSIM_CACHE_DIR` is a relative path: it is not used",
    """
A relative path would lead into the folder in which a command runs, and so into a project that another person
may have written. Compiled code is run from the cache, so the variable counts only where it names an absolute
path. The usual cache folder of the user is used instead.
""",
)


class KeptFiles:
    """A room of the cache folder; its entries are bytes under names.

    Args:
        room: name of the folder.
        most: bytes of all entries together.
        largest: bytes of one entry; a larger one is not kept.
        around: returns the cache folder; the environment decides at each use.
    """

    def __init__(self, room: str, most: int, largest: int, around: Callable[[], Path] = cache_folder) -> None:
        self._room, self._most, self._largest, self._around = room, most, largest, around

    def find(self, name: str) -> bytes | None:
        """Return an entry as stored; None unless there is an intact one owned by the user."""
        try:
            with self._opened() as room:
                content = room.read(name, _SEAL + self._largest)
        except ForeignFolderError as error:
            _refused(error)
            return None
        except OSError:
            return None
        seal, entry = content[:_SEAL], content[_SEAL:]
        return entry if seal == self._sealed(name, entry) else None

    def keep(self, name: str, entry: bytes) -> None:
        """Keep an entry in one step; where it cannot be written, or is too large, nothing happens."""
        if len(entry) > self._largest:
            return
        try:
            with self._made() as room:
                room.replace(name, self._sealed(name, entry) + entry)
                self._make_place(room)
        except ForeignFolderError as error:
            _refused(error)
        except OSError as error:
            _lacking(error)

    @contextlib.contextmanager
    def turn(self, number: int) -> Iterator[None]:
        """Have the turn of a number among processes that make an entry; see `ropsim.core.disk.turns`."""
        handle = None
        with contextlib.suppress(OSError), self._made() as room:
            handle = room.lock_file(f"{_TURN}{number % _TURNS}")
        with turn(handle):
            yield

    @contextlib.contextmanager
    def _opened(self) -> Iterator[OwnFolder]:
        with OwnFolder.at(self._folder()) as around, around.inner(self._room) as room:
            yield room

    @contextlib.contextmanager
    def _made(self) -> Iterator[OwnFolder]:
        with OwnFolder.made_at(self._folder()) as around, around.made_inner(self._room) as room:
            yield room

    def _folder(self) -> Path:
        if self._around is cache_folder and (path := relative_cache_override()):
            _unused(path)
        return self._around()

    def _sealed(self, name: str, entry: bytes) -> bytes:
        """Return the digest of an entry in its place."""
        digest = sha256(f"{self._room}/{name}\0".encode())
        digest.update(entry)
        return digest.digest()

    def _make_place(self, room: OwnFolder) -> None:
        """Remove entries that were not used for longest, until there is some place for new ones."""
        entries = sorted(one for one in room.entries() if not one.name.startswith(_TURN))
        size = sum(one.size for one in entries)
        if size <= self._most:
            return
        for one in entries:
            room.remove(one.name)
            size -= one.size
            if size <= 0.75 * self._most:
                return


def kept_findings() -> tuple[Diagnostic, ...]:
    """Return why nothing was kept in this process; empty where all is well."""
    return tuple(_findings.values())


def _refused(error: ForeignFolderError) -> None:
    hint = f"remove it, let only yourself use it (`chmod 700`), or name another folder by `{CACHE_OVERRIDE}`"
    _findings[FOREIGN_CACHE.code] = FOREIGN_CACHE.at(
        None, f"{error}: what is kept there is not used, and code is compiled anew", hint=hint
    )


def _unused(path: str) -> None:
    _findings[RELATIVE_CACHE.code] = RELATIVE_CACHE.at(
        None,
        f"`{CACHE_OVERRIDE}` is `{path}`, a relative path: it is not used",
        hint="write an absolute path, or unset the variable",
    )


def _lacking(error: OSError) -> None:
    _findings[NO_CACHE.code] = NO_CACHE.at(
        None,
        f"compiled code cannot be kept: {error.strerror or error}",
        hint=f"each start compiles anew; name a folder that can be written by `{CACHE_OVERRIDE}`",
    )
