"""The finding that the system has no memory left: the machine is too small, ropsim is not wrong."""

import errno
import os

from ropsim.core.catalogue import define
from ropsim.core.diagnostic import Diagnostic, Severity

OUT_OF_MEMORY = define(
    "X920",
    "out-of-memory",
    Severity.ERROR,
    "the system has no memory left for the work",
    """
The work needs more memory than this process may have. Nothing was left half-written.

The limit may be the memory of the machine, or one that was set for the process: `ulimit -v` shows it in a
shell, and job systems of clusters and containers set one. Run it with more memory, simulate fewer passes of
a loop, use smaller meshes, or end other programs.
""",
)
_WINDOWS = (8, 14, 1455)
"""Not enough memory, out of memory, the paging file is too small."""


def shortage(error: BaseException) -> Diagnostic | None:
    """Return the finding that an exception means a lack of memory; None where it means something else."""
    match error:
        case MemoryError():
            lacks = True
        case OSError():
            lacks = error.errno == errno.ENOMEM or getattr(error, "winerror", None) in _WINDOWS
        case ImportError():  # a library that cannot be mapped
            lacks = os.strerror(errno.ENOMEM).lower() in str(error).lower()
        case _:
            lacks = False
    if not lacks:
        return None
    hint = "give the process more memory (`ulimit -v` shows a limit), or simulate less at once"
    words = str(error).strip().splitlines()[-1:]
    return OUT_OF_MEMORY.at(
        None, "there is not enough memory" + (f": {words[0]}" if words else ""), hint=hint
    )
