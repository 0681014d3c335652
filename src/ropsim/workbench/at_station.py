"""Where a program is to run: which station of which cell decides what the program can name."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class AtStation:
    """A station, by names.

    Attributes:
        cell: name of the text of the cell file; empty for a program without a cell.
        folder: name of the project's folder, from which a cell has its own where its file gives none.
        station: name; empty for the first one of the cell.
    """

    cell: str = ""
    folder: str = ""
    station: str = ""


NOWHERE = AtStation()
"""Of a program without a cell."""
