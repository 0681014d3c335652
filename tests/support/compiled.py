"""Lines of the task language to the code that a run is given."""

import ropsim
from ropsim import icr
from ropsim.model import Cell
from ropsim.workbench import environment_of


def code_of(cell: Cell, *lines: str) -> icr.Program:
    """Return the code of a program of a cell; its first lines, name and units, are added."""
    return _code("p", lines, cell, "")


def station_code(cell: Cell, station: str, *lines: str) -> icr.Program:
    """Return the code of the program of a station, which has its name."""
    return _code(station, lines, cell, station)


def _code(name: str, lines: tuple[str, ...], cell: Cell, station: str) -> icr.Program:
    text = "\n".join([f"program {name}", "units mm, deg, s", *lines, ""])
    environment = environment_of(cell, cell.stations[station]) if station else environment_of(cell)
    compiled = ropsim.language.compile(text, environment, name)
    assert compiled.icr is not None, [str(one) for one in compiled.diagnostics]
    return compiled.icr
