"""At which locations of a cell its parts lie when a run starts."""

from collections.abc import Mapping

import numpy as np

from ropsim.model import Cell, Part

NEAR = 0.005
"""A part whose grasp point is so near to a location lies there [m]; a gripper captures it from as far."""


def part_places(cell: Cell) -> Mapping[str, str]:
    """Return the names of the locations at which parts lie, by part; at each location one at most.

    Parts of a supply that are not there yet lie nowhere. Locations in moving frames are unknown.
    """
    found: dict[str, str] = {}
    for part in cell.parts:
        place = _place_of(cell, part, frozenset(found.values())) if part.turn == 0 else ""
        if place:
            found[part.name] = place
    return found


def parts_behind(cell: Cell) -> Mapping[str, str]:
    """Return which part lies before each one that waits in a supply, by the part that waits."""
    queues = {(part.supply, part.turn): part.name for part in cell.parts if part.supply}
    return {name: queues[supply, turn - 1] for (supply, turn), name in queues.items() if turn > 0}


def first_parts(cell: Cell) -> Mapping[str, str]:
    """Return the first part of its supply, by each part that waits in one."""
    first = {part.supply: part.name for part in cell.parts if part.supply and part.turn == 0}
    return {part.name: first[part.supply] for part in cell.parts if part.supply and part.turn > 0}


def _place_of(cell: Cell, part: Part, taken: frozenset[str]) -> str:
    for name, X_WT in cell.locations.items():
        distance = float(np.linalg.norm(X_WT.position - part.X_WO.position))
        if name not in cell.located and name not in taken and distance <= NEAR:
            return name
    return ""
