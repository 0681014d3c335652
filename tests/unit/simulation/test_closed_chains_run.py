"""A program on an arm with closed chains: cuts run as couplings do."""

from dataclasses import replace
from typing import Any

import numpy as np

from ropsim import language
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import Recording
from ropsim.kinematics import forward
from ropsim.model import Box, FixedObject, MeantContact, RobotModel, Shape, Sphere, Tool
from ropsim.robots import default_controller
from ropsim.simulation import RunOptions, run
from ropsim.spatial import Pose
from ropsim.workbench import environment_of
from support.closed_arms import COUPLED_PALLETIZER, palletizer

CUT = palletizer()
CELL = '[cell]\nname = "loops"\n[robot]\nmodel = "palletizer"\n'
PROGRAM = "program main\nunits mm, deg, s\nmov joints(20, 100, -15, 10)\nmov joints(-15, 95, -7, -5)\n"


def ran(robot: RobotModel, objects: tuple[FixedObject, ...] = (), **more: Any) -> Recording:
    cell, _ = read_cell(SourceText("cell.toml", CELL), "loops")
    assert cell is not None
    contacts = more.pop("contacts", ())
    station = replace(cell.stations["robot"], robot=robot, controller=default_controller(CUT), **more)
    cell = replace(cell, stations={"robot": station}, objects=objects, contacts=contacts)
    code = language.compile(PROGRAM, environment_of(cell, station), name="main.task")
    assert code.icr is not None
    return run(cell, {"robot": code.icr}, RunOptions())


def pressed(robot: RobotModel) -> Recording:
    """Return a run whose tool, a ball, is sent 2 mm into a block beside its target."""
    q_end = np.radians([-15.0, 95.0, -7.0, -5.0])
    X_BM = forward(CUT, q_end)
    top = X_BM.position[2] - 0.02 + 2e-3
    block = FixedObject(
        "block", Pose(np.array([*X_BM.position[:2], top - 0.1])), (Shape(Box((0.4, 0.4, 0.2))),)
    )
    ball = Tool("ball", shapes=(Shape(Sphere(0.02)),))
    contact = MeantContact("press", "ball", ("block",), 2e5, 400.0, 0.2, 5e-3)
    return ran(robot, tools={"ball": ball}, default_tool="ball", objects=(block,), contacts=(contact,))


def test_a_contact_pushes_cuts_back_as_couplings() -> None:
    cut, coupled = pressed(CUT), pressed(COUPLED_PALLETIZER)
    force = cut.rows("contact_wrench")[:, 2]
    assert force.max() > 50.0
    for name, close in (("q", 1e-8), ("contact_wrench", 1e-4)):
        one, other = (recording.rows(name) for recording in (cut, coupled))
        assert np.abs(one - other).max() < close, name


def test_a_program_on_cuts_gives_the_recording_of_couplings() -> None:
    cut, coupled = ran(CUT), ran(COUPLED_PALLETIZER)
    assert [str(one) for one in cut.findings] == [str(one) for one in coupled.findings] == []
    assert len(cut.channels["q"].values) > 100
    for name, close in (("q", 1e-9), ("qd", 1e-9), ("tau", 1e-5), ("attained_position", 1e-9)):
        one, other = (recording.channels[name].values for recording in (cut, coupled))
        assert np.abs(one - other).max() < close, name  # found 1e-15 rad, 5e-9 N·m
