"""What the worker keeps between two runs of a cell."""

from dataclasses import replace
from pathlib import Path

from ropsim.studio.desk.finished import Shelf
from ropsim.workbench import open_project

EXAMPLES = Path(__file__).parents[4] / "examples"


def test_plans_are_those_of_one_cell() -> None:
    cell = open_project(EXAMPLES / "first_cell").cell
    again = open_project(EXAMPLES / "first_cell").cell
    assert cell is not None
    assert again is not None
    shelf = Shelf()
    plans = shelf.plans_of(cell)
    assert shelf.plans_of(again) is plans
    assert shelf.plans_of(replace(cell, name="another")) is not plans
