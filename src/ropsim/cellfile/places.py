"""Where the cell file gives names to things."""

from ropsim.cellfile.tomltext.positions import positions
from ropsim.cellfile.tomltext.values import toml_values
from ropsim.core import SourceText, Span

_TABLES = ("locations", "frames", "tools", "signals")


def place_in_cell_file(text: SourceText, name: str) -> Span | None:
    """Return where a location, frame, tool or signal is defined; None where the text names no such thing."""
    try:
        keys = positions(text).keys
    except (ValueError, RecursionError):
        return None
    return next((keys[table, name] for table in _TABLES if (table, name) in keys), None)


def mesh_in_cell_file(text: SourceText | None, file: str) -> Span | None:
    """Return where a valid cell file has the mesh `file`, or else its start; None where there is no text."""
    if text is None:
        return None
    places = positions(text)
    paths: list[tuple[tuple[str | int, ...], object]] = [((), toml_values("\n".join(text.lines)))]
    while paths:
        path, value = paths.pop(0)
        if value == file and path[-1:] == ("mesh",):
            return places.value(path)
        if isinstance(value, dict):
            paths += [((*path, key), item) for key, item in value.items()]
        elif isinstance(value, list):
            paths += [((*path, k), item) for k, item in enumerate(value)]
    return places.start
