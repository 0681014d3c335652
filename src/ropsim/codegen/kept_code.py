"""Machine code in the cache folder: all that this package keeps and loads goes through here."""

from ropsim.codegen.machine_code import MachineCode, MissingNameError, load, packed, unpacked
from ropsim.core import KeptFiles

GENERATED = KeptFiles("generated", most=256_000_000, largest=16_000_000)
"""Several thousand functions: of each version of ropsim and each robot some dozens."""


def kept_address(name: str) -> int | None:
    """Return the address of a kept function; None where there is none that this process can run.

    Args:
        name: of the entry; it holds a digest of all that decides about the code.
    """
    content = GENERATED.find(name)
    if content is None:
        return None
    try:
        return load(unpacked(content))
    except (ValueError, MissingNameError):
        return None


def keep_code(name: str, code: MachineCode) -> None:
    """Keep a function for other processes, where that can be."""
    GENERATED.keep(name, packed(code))
