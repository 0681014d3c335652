"""Each key that the reader of the cell file asks for has a meaning, and a form where it is read."""

from pathlib import Path

import pytest

from ropsim.cellfile import asked_in_cell_file, meaning_of, read_cell
from ropsim.cellfile.meanings import MEANINGS
from ropsim.core import SourceText
from ropsim.tomltext import Sort

EXAMPLES = Path(__file__).parents[3] / "examples"
REFERENCE = Path(__file__).parents[3] / "docs" / "reference" / "cell-file.md"
CELLS = sorted(EXAMPLES.glob("*/cell.toml"))


@pytest.mark.parametrize("cell", CELLS, ids=lambda one: one.parent.name)
def test_what_is_asked_for_has_a_meaning(cell: Path) -> None:
    questions, _ = asked_in_cell_file(SourceText("cell.toml", cell.read_text("utf-8")))
    assert questions
    assert [path for path in questions if not meaning_of(path)] == []


def test_meanings_are_of_keys_that_the_manual_has() -> None:
    manual = REFERENCE.read_text("utf-8")
    keys = {name.rpartition(".")[2] for name in MEANINGS} - {"*"}
    assert [key for key in sorted(keys) if key not in manual] == []


def test_asking_changes_nothing_that_is_found() -> None:
    text = SourceText("cell.toml", '[robot]\nmodel = "puma560"\nstart = [0, 0]\n')
    before = read_cell(text, "cell")
    questions, needed = asked_in_cell_file(text)
    assert read_cell(text, "cell") == before
    assert questions["robot", "start"].sort is Sort.NUMBERS
    assert questions["robot", "start"].count == 6
    assert ("robot", "model") in needed


def test_a_text_that_is_no_toml_is_asked_nothing() -> None:
    assert asked_in_cell_file(SourceText("cell.toml", "[robot")) == ({}, frozenset())
