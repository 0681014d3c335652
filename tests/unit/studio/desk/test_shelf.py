"""What the worker keeps between two runs of a cell."""

from dataclasses import replace
from pathlib import Path

from ropsim.studio.testing import Shelf
from ropsim.workbench import open_project

EXAMPLES = Path(__file__).parents[4] / "examples"


def test_what_is_known_is_of_one_cell() -> None:
    cell = open_project(EXAMPLES / "first_cell").cell
    again = open_project(EXAMPLES / "first_cell").cell
    assert cell is not None
    assert again is not None
    shelf = Shelf()
    known = shelf.known_in(cell)
    assert shelf.known_in(again) is known
    assert shelf.known_in(replace(cell, name="another")) is not known
