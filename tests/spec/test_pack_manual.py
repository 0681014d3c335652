"""The manual of packs names all that the result and the facts of a run hold, and nothing else."""

import re
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import get_args, get_type_hints

import pytest

from ropsim.flow import RunFacts, StationFacts
from ropsim.views import ResultFigures
from support.manual import DOCS

PACK, RECORDING = DOCS / "reference" / "pack.md", DOCS / "reference" / "recording.md"
TABLES = [
    (PACK, "Result", 0, ResultFigures),
    (RECORDING, "Facts", 0, RunFacts),
    (RECORDING, "Facts", 1, StationFacts),
]


def rows(page: Path, heading: str, table: int) -> dict[str, str]:
    """Return the rows of a table under a heading by the names in their first cell."""
    section = page.read_text("utf-8").split(f"\n## {heading}\n")[1].split("\n## ")[0]
    lines = re.findall(r"(?:^\|.*\n)+", section, re.MULTILINE)[table].splitlines()[2:]
    return {name: line for line in lines for name in re.findall(r"`(\w+)`", line.split(" | ")[0])}


def records(hint: object) -> Iterator[type]:
    """Yield the records in the type of a field."""
    if isinstance(hint, type) and is_dataclass(hint):
        yield hint
    for argument in get_args(hint):
        yield from records(argument)


@pytest.mark.parametrize(("page", "heading", "table", "kind"), TABLES, ids=["result", "facts", "stations"])
def test_the_table_has_a_row_for_each_field(page: Path, heading: str, table: int, kind: type) -> None:
    assert sorted(rows(page, heading, table)) == sorted(get_type_hints(kind))


@pytest.mark.parametrize(("page", "heading", "table", "kind"), TABLES, ids=["result", "facts", "stations"])
def test_the_row_of_a_record_names_what_it_holds(page: Path, heading: str, table: int, kind: type) -> None:
    told = rows(page, heading, table)
    inner = [
        (name, one.name)
        for name, hint in get_type_hints(kind).items()
        for record in records(hint)
        if record is not StationFacts  # which has a table of its own
        for one in fields(record)
    ]
    assert inner
    assert [(name, field) for name, field in inner if f"`{field}`" not in told[name]] == []


def test_the_manual_of_packs_leads_to_the_facts() -> None:
    assert "(recording.md#facts)" in rows(PACK, "Header", 0)["facts"]
