"""The pose that the arm really has, as a program keeps and uses it."""

from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim.flow import MessageEvent, Recording
from ropsim.model import Cell, Frame, Tool
from ropsim.robots import default_controller, load
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Pose
from ropsim.workbench import environment_of
from support.cells import one_station
from support.printed import si_numbers

FREE = 6.0
"""Ends of all joint ranges, out of the way [rad]."""
NEAR = 1e-6
"""What `print` shows of a length of about a metre: six digits [m]."""


@pytest.fixture(scope="module")
def cell() -> Cell:
    robot = load("puma560")
    robot = replace(robot, joints=tuple(replace(one, lower=-FREE, upper=FREE) for one in robot.joints))
    tools = {"pen": Tool("pen", Pose(np.array([0.0, 0.0, 0.12])), 0.1)}
    table = Frame(Pose.from_tuple((0.4, 0.1, 0.05, 0.8, 0.0, 0.0, 0.6)))
    made = one_station(
        "c", robot, default_controller("puma560"), tools=tools, default_tool="pen", start=robot.home
    )
    return replace(made, frames={"table": table})


def said(cell: Cell, *lines: str, fidelity: Fidelity = Fidelity.KINEMATIC) -> list[str]:
    text = "\n".join(("program p", "units mm, deg, s", *lines))
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert compiled.icr is not None, [str(found) for found in compiled.diagnostics]
    recording: Recording = run(cell, {"robot": compiled.icr}, RunOptions(fidelity))
    return [event.text for event in recording.events if isinstance(event, MessageEvent)]


def test_an_ideal_arm_has_the_pose_that_was_asked_for(cell: Cell) -> None:
    (text,) = said(cell, "lin (450, -150, 100; down, rz 30) store q", "print q.x, q.y, q.z, q.rz")
    assert si_numbers(text) == pytest.approx([0.45, -0.15, 0.1, np.radians(30)], abs=NEAR)


def test_it_is_kept_in_the_frame_in_force_and_goes_where_it_was(cell: Cell) -> None:
    lines = ("set frame table", "mov (50, -150, 100)", "mov (50, -150, 140) store q", "mov (0, 0, 200)")
    (text,) = said(cell, *lines, "mov q store r", "print dist(q, r), q.x, q.y, q.z")
    assert si_numbers(text) == pytest.approx([0.0, 0.05, -0.15, 0.14], abs=NEAR)


def test_a_real_arm_has_a_pose_near_to_it(cell: Cell) -> None:
    (text,) = said(
        cell, "mov (450, -150, 100) store q", "print dist(q, (450, -150, 100))", fidelity=Fidelity.DYNAMIC
    )
    assert 0.0 < si_numbers(text)[0] < 1e-3
