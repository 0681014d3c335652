"""The arm that the dry run of a program needs."""

from ropsim import icr
from ropsim.model import Cell, Station

_READING = frozenset({"ATTAINED", "CURPOSE"})
"""Instructions that read where the arm is."""


def program_arm(code: icr.Program, cell: Cell | None, station: Station | None) -> icr.Arm | None:
    """Return the arm of a station at the start of a dry run.

    Args:
        code: of the program.
        cell: None for a program without one.
        station: that runs the program; None without a cell.

    Returns:
        None without a cell, and if the program never reads where its arm is.
    """
    if cell is None or station is None:
        return None
    if not any(step.mnemonic in _READING for one in code.procedures for step in one.code):
        return None
    from ropsim.workbench.dry_arm import dry_arm

    return dry_arm(cell, station)
