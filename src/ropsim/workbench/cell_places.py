"""Where the cell file gives names to things."""

from ropsim.core import SourceText, Span
from ropsim.workbench.toml_positions import positions

_TABLES = ("locations", "frames", "tools", "signals")


def place_in_cell_file(text: SourceText, name: str) -> Span | None:
    """Return where a location, frame, tool or signal is defined; None where the text names no such thing."""
    try:
        keys = positions(text).keys
    except (ValueError, RecursionError):
        return None
    return next((keys[table, name] for table in _TABLES if (table, name) in keys), None)
