"""Hints of findings: a changed joint controller and a meant contact are named."""

from dataclasses import replace

import numpy as np

from ropsim import robots
from ropsim.model import Cell, ComputedTorqueGains, ControllerFile, ControllerKind, MeantContact
from ropsim.robots import controller_under
from ropsim.simulation.testing import (
    Circumstances,
    FinishedStation,
    PressedOn,
    Tally,
    Track,
    contact_words,
    loop_words,
)

ROBOT = robots.load("puma560")
STANDARD = robots.default_controller("puma560")
CONTACT = MeantContact("tip", "pointer", ("table",), 2e5, 100.0, 0.1, 0.01)


def test_a_standard_controller_is_not_blamed() -> None:
    assert loop_words(ROBOT, STANDARD) == ""
    assert Circumstances().hint("slow down") == "slow down"


def test_gains_or_a_law_of_the_user_are_named() -> None:
    assert isinstance(STANDARD.gains, ComputedTorqueGains)
    gains = replace(STANDARD.gains, kp=2.0 * STANDARD.gains.kp)
    assert "`ropsim controller response CELL`" in loop_words(ROBOT, replace(STANDARD, gains=gains))
    fixed = controller_under(ROBOT, STANDARD.rates, ControllerKind.CASCADED_P_PI)
    assert "gains" in loop_words(ROBOT, fixed)
    own = replace(STANDARD, kind=ControllerKind.FILE, gains=ControllerFile("controllers/mine.py"))
    assert "your own" in loop_words(ROBOT, own)


def test_a_contact_comes_first_on_the_line_on_which_it_pressed() -> None:
    cell = Cell("cell", {}, contacts=(CONTACT,))
    lines = Track([0, 100], [3.0, 4.0])
    pressed = PressedOn(cell, np.array([0.0, 50.0, 150.0]), np.array([0.0, 0.0, 12.0]))
    station = FinishedStation(
        ROBOT, "a.task", 1000, 0.2, Tally((), 0), lines, Track(), (), frozenset(), "", pressed
    )
    assert station.circumstances(50).contact == ""
    hint = station.circumstances(140).hint("slow down")
    assert hint.startswith("it was held back by contact `tip`, with up to 12 N")
    assert hint.endswith("otherwise slow down")
    assert contact_words(cell, 0.0) == ""
