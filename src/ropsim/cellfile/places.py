"""Places where the cell file names entities."""

from collections.abc import Iterable, Sequence

from ropsim.core import SourceText, Span, toml_values
from ropsim.model import ROBOT
from ropsim.tomltext import positions

_TABLES = ("locations", "frames", "tools", "signals", "stations", "devices")


def place_in_cell_file(text: SourceText, name: str, tables: Iterable[str] = _TABLES) -> Span | None:
    """Return where a location, frame, tool, signal, station or device is defined; None where none is.

    Args:
        text: the cell file.
        name: name of the requested entity.
        tables: in which it may stand, in this order.
    """
    try:
        keys = positions(text).keys
        return next((keys[table, name] for table in tables if (table, name) in keys), None)
    except (ValueError, RecursionError):
        return None


def program_in_cell_file(text: SourceText | None, station: str) -> Span | None:
    """Return where a valid cell file names the program of a station, else the station; else None."""
    if text is None:
        return None
    places = positions(text)
    if station == ROBOT and (ROBOT,) in places.keys:
        said = ("cell", "program")
        return places.value(said) if said in places.keys else places.key((ROBOT,))
    path = ("stations", station)
    return places.value((*path, "program")) if (*path, "program") in places.keys else places.key(path)


def controller_key_in_cell_file(text: SourceText | None, station: str, *keys: str) -> Span | None:
    """Return where a cell file has a value of the controller of a station; None without a text or a value."""
    if text is None:
        return None
    places = positions(text)
    path = (*(("controller",) if station == ROBOT else ("stations", station, "controller")), *keys)
    return places.value(path) if path in places.keys else None


def mesh_in_files(texts: Sequence[SourceText], file: str) -> Span | None:
    """Return where valid cell and robot files have the mesh `file`, or else the start of the first of them.

    Args:
        texts: the cell file, then files of robots.
        file: path of the mesh as written.
    """
    found = (_mesh(text, file) for text in texts)
    return next((span for span in found if span), texts[0].span(1) if texts else None)


def _mesh(text: SourceText, file: str) -> Span | None:
    paths: list[tuple[tuple[str | int, ...], object]] = [((), toml_values("\n".join(text.lines)))]
    while paths:
        path, value = paths.pop(0)
        if value == file and path[-1:] == ("mesh",):
            return positions(text).value(path)
        if isinstance(value, dict):
            paths += [((*path, key), item) for key, item in value.items()]
        elif isinstance(value, list):
            paths += [((*path, k), item) for k, item in enumerate(value)]
    return None
