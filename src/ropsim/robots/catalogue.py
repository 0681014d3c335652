"""Catalogue of robots, without reading them: the index that tools/robot_library.py writes."""

from functools import lru_cache
from importlib.resources import files
from math import inf
from pathlib import Path

from ropsim.core import frozen_dataclass, read_bytes

INDEX = "index.tsv"
"""Name of the file next to the files of the robots."""
COLUMNS = ("name", "maker", "model", "axes", "payload_kg", "reach_mm", "inverse_kinematics", "data", "source")


@frozen_dataclass
class CatalogueEntry:
    """A built-in robot in a line.

    Attributes:
        name: name in the library.
        maker: empty for a robot that is not sold.
        model: name by the maker, or description.
        axes: how many.
        rated_payload: mass that the maker allows at the interface [kg]; inf where unknown.
        reach: of the wrist, or of the interface of an arm without one, from axis 1 [m].
        solver: class of its inverse kinematics.
        data: available groups of numbers with their kinds, such as `masses` (published), `masses measured` or
            `friction estimated`.
        source: of its axes.
    """

    name: str
    maker: str
    model: str
    axes: int
    rated_payload: float
    reach: float
    solver: str
    data: tuple[str, ...]
    source: str

    @property
    def title(self) -> str:
        """Return maker and model."""
        return f"{self.maker} {self.model}".strip()


@lru_cache(maxsize=1)
def catalogue() -> tuple[CatalogueEntry, ...]:
    """Return the built-in robots in the order of their names."""
    path = Path(str(files("ropsim.robots").joinpath("arms", INDEX)))
    rows = read_bytes(path).decode("utf-8").splitlines()[1:]
    return tuple(_entry(*row.split("\t")) for row in rows)


def catalogue_text(entries: tuple[CatalogueEntry, ...]) -> str:
    """Return the index file of robots."""
    rows = [COLUMNS, *(_row(one) for one in entries)]
    return "".join("\t".join(row) + "\n" for row in rows)


def _entry(
    name: str,
    maker: str,
    model: str,
    axes: str,
    payload: str,
    reach: str,
    solver: str,
    data: str,
    source: str,
) -> CatalogueEntry:
    mass = float(payload) if payload else inf
    there = tuple(one for one in data.split(", ") if one)
    return CatalogueEntry(name, maker, model, int(axes), mass, 1e-3 * int(reach), solver, there, source)


def _row(one: CatalogueEntry) -> tuple[str, ...]:
    payload = "" if one.rated_payload == inf else f"{one.rated_payload:g}"
    reach, data = f"{round(1e3 * one.reach)}", ", ".join(one.data)
    return one.name, one.maker, one.model, str(one.axes), payload, reach, one.solver, data, one.source
