"""A program on an arm with closed chains: cuts run as couplings do."""

from dataclasses import replace

import numpy as np

from ropsim import language
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import Recording
from ropsim.model import RobotModel
from ropsim.robots import default_controller
from ropsim.simulation import RunOptions, run
from ropsim.workbench import environment_of
from support.closed_arms import COUPLED_PALLETIZER, palletizer

CUT = palletizer()
CELL = '[cell]\nname = "loops"\n[robot]\nmodel = "palletizer"\n'
PROGRAM = "program main\nunits mm, deg, s\nmov joints(20, 100, -15, 10)\nmov joints(-15, 95, -7, -5)\n"


def ran(robot: RobotModel) -> Recording:
    cell, _ = read_cell(SourceText("cell.toml", CELL), "loops")
    assert cell is not None
    station = replace(cell.stations["robot"], robot=robot, controller=default_controller(CUT))
    cell = replace(cell, stations={"robot": station})
    code = language.compile(PROGRAM, environment_of(cell, station), name="main.task")
    assert code.icr is not None
    return run(cell, {"robot": code.icr}, RunOptions())


def test_a_program_on_cuts_gives_the_recording_of_couplings() -> None:
    cut, coupled = ran(CUT), ran(COUPLED_PALLETIZER)
    assert [str(one) for one in cut.findings] == [str(one) for one in coupled.findings] == []
    assert len(cut.channels["q"].values) > 100
    for name, close in (("q", 1e-9), ("qd", 1e-9), ("tau", 1e-5), ("attained_position", 1e-9)):
        one, other = (recording.channels[name].values for recording in (cut, coupled))
        assert np.abs(one - other).max() < close, name  # found 1e-15 rad, 5e-9 N·m
