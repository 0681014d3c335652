"""The text of the schema, and its conformance classes."""

from enum import StrEnum
from functools import lru_cache
from importlib.resources import files
from pathlib import Path

from ropsim.core import SourceText, read_bytes
from ropsim.express import Schema, read_schema
from ropsim.model import RobotModel

FILE = "ropsim_nirox_v1.exp"
NAME = "ROPSIM_NIROX_V1"


def nirox_schema_text() -> SourceText:
    """Return the text of the schema."""
    path = Path(str(files("ropsim.nirox").joinpath("schema", FILE)))
    return SourceText(FILE, read_bytes(path).decode("ascii"))


@lru_cache(maxsize=1)
def nirox_schema() -> Schema:
    """Return the schema; it is read once in a process."""
    schema, findings = read_schema(nirox_schema_text())
    assert schema is not None, findings
    return schema


class ConformanceClass(StrEnum):
    """The classes of NIROX files; each includes the requirements of the ones before.

    Masses and geometry must be complete for all moving links, drives for all axes; an arm without closed
    chains needs no cuts.
    """

    CC1 = "kinematics"
    CC2 = "masses"
    CC3 = "drives"
    CC4 = "cuts of closed chains"
    CC5 = "geometry"


def conformance_of(robot: RobotModel) -> ConformanceClass:
    """Return the greatest class whose demands a robot meets; the dynamics need CC2, the drives CC3."""
    weighs = all(link.mass or link.inertia.any() for link in robot.links)
    if not weighs:
        return ConformanceClass.CC1
    if not robot.drives:
        return ConformanceClass.CC2
    drawn = all(link.shapes for link in robot.links)
    return ConformanceClass.CC5 if drawn else ConformanceClass.CC4
