"""Outputs that are to be set beside the way of a move: told in the unit in which their place is given."""

import pytest

import ropsim
from ropsim import robots
from ropsim.model import Cell, Signal, Tool
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.workbench import environment_of
from support.cells import one_station

ROBOT = robots.load("puma560")
CELL: Cell = one_station(
    "c",
    ROBOT,
    robots.default_controller("puma560"),
    tools={"": Tool("")},
    start=ROBOT.home,
    signals={"glue": Signal("glue", is_input=False)},
)


@pytest.mark.parametrize(
    ("place", "says"),
    [
        ("300 before end", "300 mm before the end, the move is 10 mm long: it is set at its start"),
        ("12.5 s after start", "12.5 s after the start, the move is 0.246 s long: it is set at its end"),
    ],
)
def test_a_place_beside_the_way_is_told_in_its_unit(place: str, says: str) -> None:
    text = f"program p\nunits mm, deg, s\nmov (500, 0, 300)\nlin (500, 0, 290) at {place} do set glue on"
    compiled = ropsim.language.compile(text, environment_of(CELL))
    assert compiled.icr is not None
    (found,) = run(CELL, {"robot": compiled.icr}, RunOptions(Fidelity.KINEMATIC)).findings
    assert (found.code, found.message) == ("M565", f"`glue` is to be set {says}")
