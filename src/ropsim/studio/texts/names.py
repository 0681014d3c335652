"""Names of texts: which a new one may have, and which program a cell runs."""

import re
import tomllib

from ropsim.core import toml_values

DEFAULT_PROGRAM = "main"


def is_new_name(name: str) -> bool:
    """Return whether a new text may have a name; it never leads out of its folder, on any system."""
    found = re.fullmatch(r"(?:programs/(\w[\w \-]{0,100})\.(?:task|icr)|kb/(\w[\w \-]{0,100})\.pl)", name)
    if found is None:
        return False
    stem = (found[1] or found[2]).rstrip().lower()
    return re.fullmatch(r"con|prn|aux|nul|com\d|lpt\d", stem) is None  # devices of Windows


def reserved(name: str) -> str | None:
    """Return the word of the task language that a new program would be called; None where it is none."""
    from ropsim.language import RESERVED_WORDS

    found = re.fullmatch(r"programs/(\w+)\.task", name)
    return found[1] if found and found[1].lower() in RESERVED_WORDS else None


def named_program(cell: str) -> str:
    """Return the program of the first station of a cell file; one with mistakes names the usual one."""
    try:
        tables = toml_values(cell)
    except (tomllib.TOMLDecodeError, RecursionError):
        return DEFAULT_PROGRAM
    stations = tables.get("stations")
    if isinstance(stations, dict) and stations:
        station, table = next(iter(stations.items()))
        usual = station
    else:
        table, usual = tables.get("cell"), DEFAULT_PROGRAM
    name = table.get("program", usual) if isinstance(table, dict) else usual
    return name if isinstance(name, str) else usual
