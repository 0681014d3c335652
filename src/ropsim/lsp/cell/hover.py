"""Hover text for a place of the cell file: meaning, form and default of a key, and pose of an entity."""

from collections.abc import Iterator, Mapping

from ropsim.cellfile import NAMED, meaning_of
from ropsim.core import toml_values
from ropsim.lsp.analysis import names
from ropsim.lsp.analysis.workshop import Surroundings, Workshop
from ropsim.lsp.cell.place import path_at, places_in, questions_in
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.parameters import Position
from ropsim.model import WORLD, Cell
from ropsim.spatial import Pose
from ropsim.tomltext import Path

_LISTED = ("parts", "supplies", "objects", "sinks")


def cell_hover(
    document: Document, position: Position, documents: Mapping[str, Document], workshop: Workshop
) -> tuple[str, ...]:
    """Return the hover text for a place of the cell file, empty if the text is no TOML."""
    places = places_in(document)
    path = path_at(document, position, places) if places is not None else None
    if path is None:
        return ()
    while path and isinstance(path[-1], int) and path[0] not in _LISTED:
        path = path[:-1]  # an item of a list of numbers
    around = workshop.named(document, documents)
    return tuple(_texts(document, path, around))


def _texts(document: Document, path: Path, around: Surroundings) -> Iterator[str]:
    questions = questions_in(document.text, around)
    question = questions.questions.get(path)
    meaning = meaning_of(path, question)
    if meaning or question is not None:
        yield f"**{'.'.join(one for one in path if isinstance(one, str))}**"
    if meaning:
        yield meaning
    if question is not None:
        parts = [question.form]
        if path in questions.needed:
            parts.append("needed")
        elif question.default_words:
            parts.append(f"without it {question.default_words}")
        yield "; ".join(parts)
    cell = around.cell
    if cell is not None:
        yield from places_of(cell, *_thing(document, path, question.names if question else ""))


def _thing(document: Document, path: Path, names_a: str) -> tuple[str, str]:
    """Return the section and the name of the thing at a path: which it is, or which its value names."""
    value: object = toml_values(document.text)
    for step in path:
        value = _inside(value, step)
    if names_a and isinstance(value, str):
        return f"{names_a}s", value
    if len(path) == 2 and path[0] in NAMED:
        return str(path[0]), str(path[1])
    if path[0] in _LISTED and len(path) in (2, 3) and isinstance(value, dict):
        return str(path[0]), str(value.get("name", ""))
    if path[0] in _LISTED and path[-1] == "name" and isinstance(value, str):
        return str(path[0]), value
    return "", ""


def _inside(value: object, step: str | int) -> object:
    if isinstance(value, dict):
        return value.get(step)
    return value[step] if isinstance(value, list) and isinstance(step, int) and step < len(value) else None


def places_of(cell: Cell, section: str, name: str) -> Iterator[str]:
    """Yield where a thing of the cell is, in the world and where it is given in another frame."""
    match section:
        case "frames" if name in cell.frames:
            frame = cell.frames[name]
            yield _in(
                frame.X_PK, "the world frame" if frame.parent == WORLD else f"{frame.parent}, which moves"
            )
        case "locations" if name in cell.locations:
            given = cell.given.get(name, "")
            moving = cell.located.get(name)
            yield _in(cell.locations[name], f"the frame {moving}" if moving else "the world frame")
            if given and given in cell.frames:
                yield _in(cell.frames[given].X_PK.inverse() @ cell.locations[name], f"the frame {given}")
            if name in cell.free:
                yield "its orientation is free"
        case "tools":
            tools = [one.tools[name] for one in cell.stations.values() if name in one.tools]
            if tools:
                yield _in(tools[0].X_MT, "the mechanical interface")
        case "stations" if name in cell.stations:
            yield f"base: {_in(cell.stations[name].X_WB, 'the world frame')}"
        case "parts" | "supplies":
            own = [one for one in cell.parts if name in (one.name, one.supply, one.name.rpartition("_")[0])]
            if own:
                yield _in(own[0].X_WO, "the world frame")
        case "objects":
            for thing in (one for one in cell.objects if one.name == name):
                yield _in(thing.X_PO, thing.parent or "the world frame")
        case "signals" if name in cell.signals:
            yield names.signal_words(cell.signals[name])


def _in(pose: Pose, frame: str) -> str:
    return f"{names.pose_words(pose)} in {frame}"
