"""When meant contacts are looked at again, and how much energy the held force of a bounce may change."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import forward, jacobian
from ropsim.model import Cell, FixedObject, MeantContact, Shape, Sphere, Tool
from ropsim.simulation import RunOptions, run
from ropsim.simulation.testing import start_run, touching_of
from ropsim.spatial import Array, Pose
from support.cells import one_station
from support.compiled import code_of
from support.pressed import BLOCK, MASS, RADIUS, contact, gantry, pressed_cell, springs

LOOSE = springs(np.zeros(2), np.zeros(2))
LEVER = 0.3
"""Of a ball at a tool, off the axis of the last joint [m]."""


def quiet_time(cell: Cell, qd: Array) -> float:
    """Return for how long a contact is not looked at, at the start of a cell and these speeds [s]."""
    touching = touching_of(cell, "robot")
    assert touching is not None
    touching.run = start_run(cell, RunOptions())
    found = touching.exerted(np.asarray(cell.first.q_start), qd, 0)
    assert found.quiet > 0
    return found.quiet / cell.first.controller.rates.control_hz


def test_a_fast_arm_is_looked_at_before_it_can_touch() -> None:
    cell = pressed_cell(contact(), start=(0.0, 0.9))
    qd = np.array([-8.0, -8.0])
    assert quiet_time(cell, qd) * np.linalg.norm(qd) < 0.9 - RADIUS


def test_a_tool_that_turns_fast_is_looked_at_before_it_can_touch() -> None:
    """The mechanical interface stands still, and a ball beside its axis goes round far beyond the limits."""
    robot = robots.load("puma560")
    shape = Shape(Sphere(RADIUS), Pose(np.array([LEVER, 0.0, 0.0])))
    at = forward(robot, robot.home).position
    wall = FixedObject("block", Pose(at - np.array([0.0, 0.0, 1.0])), BLOCK.shapes)
    cell = one_station(
        "turned",
        robot,
        robots.default_controller("puma560"),
        tools={"tip": Tool("tip", shapes=(shape,))},
        default_tool="tip",
        objects=(wall,),
        start=robot.home,
        contacts=(MeantContact("press", "tip", ("block",), 1e5, 200.0, 0.2, 5e-3),),
    )
    qd = np.zeros(robot.n)
    qd[-1] = 1000.0
    assert np.abs(jacobian(robot, robot.home)[:3] @ qd).max() < 1e-9
    assert quiet_time(cell, qd) * LEVER * qd[-1] < 1.0 + LEVER


@pytest.mark.parametrize(("hz", "stiffness"), [(1000, 1e6), (250, 1e5)])
def test_a_bounce_changes_its_energy_by_no_more_than_a_quarter_of_the_square(
    hz: int, stiffness: float
) -> None:
    """Half a tick ahead the held force is the leapfrog rule: y' = y + T·v', v' = v - ω²·T·y.

    In contact v² + ω²·y² - ω²·T·v·y is constant. Depths at the first and behind the last tick, below |v|·T,
    leave v² less by up to (ω·T)²/4 of it, once before and once behind. There is next to no damping.
    """
    square = stiffness / MASS / hz**2
    changes = []
    for start in np.linspace(0.02, 0.03, 9):
        cell = pressed_cell(
            contact(stiffness, 1e-3, 0.0), start=(0.0, float(start)), hz=hz, robot=gantry(0.0)
        )
        law = springs(np.zeros(2), np.zeros(2), -20.0)  # falls at 10 m/s²
        recording = run(
            cell,
            {"robot": code_of(cell, "wait 0.09 s")},
            RunOptions(laws={"robot": law}, record_hz=hz),
        )
        z, speed = recording.rows("q")[:, 1], recording.rows("qd")[:, 1]
        energy = 0.5 * speed**2 + 10.0 * z
        first = int(np.argmax(speed > 0.0))
        behind = first + int(np.argmax(z[first:] > RADIUS + 1e-4))
        assert behind > first > 0
        changes.append((energy[behind] - energy[0]) / (energy[0] - 10.0 * RADIUS))
    assert -square / 4.0 < min(changes)
    assert max(changes) < square / (4.0 - square)
    assert max(np.abs(changes)) > square / 20.0
