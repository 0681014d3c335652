"""Payloads through barycentric parameters."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.dynamics import compiled
from ropsim.dynamics.inertia import tip_body
from ropsim.model import Link, Payload, RobotModel, combine
from ropsim.spatial import Array
from support.arms import random_arm, random_link, random_states

ROUNDING = 1e-10


def _torques(robot: RobotModel, payload: Payload | None = None) -> Array:
    q, qd, qdd = random_states(robot, 1)[0]
    tau = np.empty(robot.n)
    compiled(robot, payload, Engine.PYTHON).inverse(q, qd, qdd, np.zeros(6), tau)
    return tau


def _in_last_frame(robot: RobotModel, body: Link) -> Payload:
    R = robot.X_nM.rotation()
    return Payload(body.mass, R @ body.com + robot.X_nM.position, R @ body.inertia @ R.T)


def test_a_payload_acts_like_a_last_link_that_has_grown_together_with_it() -> None:
    robot = random_arm(4, "RPR")
    body = random_link(np.random.default_rng(5))
    last = robot.links[-1]
    grown = combine((Payload(last.mass, last.com, last.inertia), _in_last_frame(robot, body)))
    combined = replace(robot, links=(*robot.links[:-1], Link(grown.mass, grown.com, grown.inertia)))
    attained = _torques(robot, Payload(body.mass, body.com, body.inertia))
    np.testing.assert_allclose(attained, _torques(combined), rtol=0, atol=ROUNDING)


def test_the_parameters_of_a_point_mass_are_those_of_the_textbook() -> None:
    robot = random_arm(4, "R")
    massless = replace(robot, links=(Link(0.0, np.zeros(3), np.zeros((3, 3))),))
    carried = tip_body(massless, Payload(2.0, np.zeros(3)))
    x, y, z = robot.X_nM.position
    squares = [y * y + z * z, x * x + z * z, x * x + y * y]
    products = [-x * y, -x * z, -y * z]
    expected = 2.0 * np.array([1.0, x, y, z, *squares, *products])
    np.testing.assert_allclose(carried, expected, rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize("payload", [None, Payload()])
def test_no_payload_leaves_the_link(payload: Payload | None) -> None:
    robot = random_arm(4, "RR")
    assert tip_body(robot, payload)[0] == robot.links[-1].mass
