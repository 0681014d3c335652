"""The text of the schema ROPSIM_CONTROL_V1."""

from functools import lru_cache
from importlib.resources import files
from pathlib import Path

from ropsim.core import SourceText, read_bytes
from ropsim.express import Schema, read_schema

FILE = "ropsim_control_v1.exp"
NAME = "ROPSIM_CONTROL_V1"


def control_schema_text() -> SourceText:
    """Return the text of the schema."""
    path = Path(str(files("ropsim.blockdiagram").joinpath("schema", FILE)))
    return SourceText(FILE, read_bytes(path).decode("ascii"))


@lru_cache(maxsize=1)
def control_schema() -> Schema:
    """Return the schema; it is read once in a process."""
    schema, findings = read_schema(control_schema_text())
    assert schema is not None, findings
    return schema
