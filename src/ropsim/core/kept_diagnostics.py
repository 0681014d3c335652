"""Diagnostics of the folder in which results are kept between processes (X918, X919)."""

from ropsim.core.catalogue import define
from ropsim.core.diagnostic import Severity

FOREIGN_CACHE = define(
    "X918",
    "cache-not-your-own",
    Severity.WARNING,
    "others can have written into the cache folder: it is not used",
    """
Compiled code is kept in the cache folder and run from there. So it is used only where nobody else can have
put something into it: the folder and the folders in it belong to you, no other user can write to them, and
they are no links. Root does not use the cache of another user either.

Nothing is lost: code is compiled anew in each process, which takes longer. Remove the folder, or take the
permission to write from others (`chmod 700`); `ROPSIM_CACHE_DIR` names another folder by an absolute path.
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
