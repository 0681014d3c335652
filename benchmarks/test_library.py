"""The robots of the package's NIROX files: what loading one takes."""

from typing import Any

from measuring import Measure, processor_seconds
from tools import robot_library

from ropsim.core import SourceText, read_bytes
from ropsim.nirox import read_valid_nirox
from ropsim.nirox.schema_text import nirox_schema
from ropsim.robots.library import stored_names

TEXTS = tuple(
    SourceText(f"{name}.stp", read_bytes(robot_library.TARGET / f"{name}.stp").decode("ascii"))
    for name in stored_names()
)


def test_loading_a_robot_of_the_library(benchmark: Any) -> None:
    """The schema is read once in a process, before the first one."""
    measure = Measure(benchmark)
    measure(nirox_schema.__wrapped__)
    schema, *robots = processor_seconds(
        nirox_schema.__wrapped__, *(lambda one=one: read_valid_nirox(one) for one in TEXTS)
    )
    measure.figure("ms for the schema", 1e3 * schema, most=20.0)
    measure.figure("ms for the slowest robot", 1e3 * max(robots), most=20.0)
