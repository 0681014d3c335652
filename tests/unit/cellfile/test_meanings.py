"""Each key that the reader of the cell file asks for has a meaning, and a form where it is read."""

import re
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


def test_keys_of_every_kind_of_sensor_have_a_meaning() -> None:
    start = '[robot]\nmodel = "puma560"\n[signals.a]\ninput = 1\nanalog = true\nsensor = { kind = '
    _, (found, *_) = read_cell(SourceText("cell.toml", f'{start}"none such" }}\n'), "cell")
    kinds = re.findall(r"`([^`]*)`", found.message.partition("allowed are")[2])
    assert {"distance", "force"} < set(kinds)
    for kind in kinds:
        questions, _ = asked_in_cell_file(SourceText("cell.toml", f'{start}"{kind}" }}\n'))
        asked = [path for path in questions if path[:3] == ("signals", "a", "sensor")]
        assert len(asked) > 2, kind
        assert [path for path in asked if not meaning_of(path)] == [], kind


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
