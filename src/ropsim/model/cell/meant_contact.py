"""Contacts that are meant: a tool or part that is pressed on its environment."""

from typing import ClassVar

from ropsim.core import frozen_dataclass
from ropsim.model.findings.number_range import EXTENT, FROM_ZERO, POSITIVE, Ranges

FLOOR = "floor"
"""Name of all below z = 0 of the world, where bodies are pressed on it."""


@frozen_dataclass
class MeantContact:
    """A tool or part that other bodies push back when it is pressed on them.

    Only contacts that are declared act; all others are found after a run, as collisions.

    Attributes:
        name: unique in the cell.
        moving: name of the tool or part.
        standing: names of objects, parts, devices, and of the floor (`FLOOR`).
        stiffness: force over the depth of one flat face in another one [N/m].
        damping: force over the speed of approach [N·s/m].
        friction: Coulomb coefficient; in full while bodies slide, in proportion to speed at the slowest.
        depth: the greatest that is meant [m]; deeper bodies collide.
    """

    RANGES: ClassVar[Ranges] = {
        "stiffness": POSITIVE,
        "damping": POSITIVE,
        "friction": FROM_ZERO,
        "depth": EXTENT,
    }

    name: str
    moving: str
    standing: tuple[str, ...]
    stiffness: float
    damping: float
    friction: float = 0.2
    depth: float = 1e-3
