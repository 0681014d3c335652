"""How much memory a process may have, where the system lets us say so."""

import contextlib
import sys

BESIDE = 256 << 20
"""Addresses that a Prolog takes beside what it works with: code, libraries, reserved space [bytes]."""


def limit_memory(pid: int, memory_bytes: int) -> None:
    """Let a process have so many bytes beside its code; on Linux only, elsewhere its stacks are bounded.

    Args:
        pid: the process.
        memory_bytes: for what it works with.
    """
    if sys.platform == "linux":
        import resource

        most = memory_bytes + BESIDE
        with contextlib.suppress(OSError, ValueError):  # it has ended, or has less already
            resource.prlimit(pid, resource.RLIMIT_AS, (most, most))
