"""Planar linkages move as the absolute coordinates of their bodies do, which scipy integrates."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim.dynamics import free_motion
from ropsim.kinematics import joint_motion
from ropsim.model import BASE_LINK, JointType, LoopCut, RobotModel, passive_coordinates
from ropsim.spatial import Array, Pose
from support.loops import DOWN, IN_PLANE, at, joint, mechanism, plane_body, rod

CRANK, COUPLER, ROCKER, GROUND = 0.2, 0.8, 0.6, 0.9
MASSES = (1.0, 3.0, 2.0)
CLOSE = 1e-6  # [rad, m] after 1.5 s, three turns; found 1.5e-7
DURATION, STEP = 1.5, 5e-4
ALONG_X = Pose(orientation=np.array([1.0, 0.0, 1.0, 0.0]))


def four_bar() -> RobotModel:
    joints = (joint("crank", at(0.0)), joint("coupler", at(CRANK), 0), joint("rocker", at(GROUND)))
    links = tuple(rod(*one) for one in zip(MASSES, (CRANK, COUPLER, ROCKER), strict=True))
    return mechanism(joints, links, (LoopCut(1, at(COUPLER), 2, at(ROCKER), IN_PLANE),), 0.6, DOWN)


def slider_crank() -> RobotModel:
    slide = joint("slider", ALONG_X, BASE_LINK, JointType.PRISMATIC)
    joints = (joint("crank", at(0.0)), joint("rod", at(CRANK), 0), slide)
    links = (rod(MASSES[0], CRANK), rod(MASSES[1], COUPLER), plane_body(MASSES[2], 0.0, 0.0, 1.0))
    return mechanism(joints, links, (LoopCut(1, at(COUPLER), 2, Pose(), IN_PLANE),), 0.6, DOWN)


Point = tuple[int, float]
"""A body, -1 for the ground, and a place on its axis from its centre of mass [m]; on the ground along x."""


def pins(points: list[tuple[Point, Point]], x: Array) -> Array:
    """Return what parts the points that pins hold together, two numbers for each pin."""
    return np.concatenate([place(one, x) - place(other, x) for one, other in points])


def place(point: Point, x: Array) -> Array:
    body, along = point
    if body < 0:
        return np.array([along, 0.0])
    cx, cy, angle = x[3 * body : 3 * body + 3]
    return np.array([cx + along * np.cos(angle), cy + along * np.sin(angle)])


def integrated(rows: Callable[[Array], Array], M: Array, x: Array, v: Array) -> tuple[Array, Array]:
    """Return places and speeds of free bodies after the motion, by multipliers of Lagrange."""
    n = len(x)
    force = M * np.tile([0.0, DOWN[1], 0.0], n // 3)

    def slopes(at_x: Array) -> Array:
        """Return the slopes of the rows by the complex step, exact to rounding."""
        units = 1e-30j * np.eye(n)
        return np.array([rows(at_x + one).imag / 1e-30 for one in units]).T

    def rates(_: float, state: Array) -> Array:
        x, v = state[:n], state[n:]
        J, h = slopes(x), 1e-5
        drift = (slopes(x + h * v) - slopes(x - h * v)) @ v / (2.0 * h)
        r = len(J)
        whole = np.block([[np.diag(M), J.T], [J, np.zeros((r, r))]])
        return np.concatenate((v, np.linalg.solve(whole, np.concatenate((force, -drift)))[:n]))

    found: Any = solve_ivp(
        rates, (0.0, DURATION), np.concatenate((x, v)), method="DOP853", rtol=1e-11, atol=1e-12
    )
    return found.y[:n, -1], found.y[n:, -1]


def centre(start: tuple[float, float], angle: float, length: float) -> list[float]:
    return [start[0] + 0.5 * length * np.cos(angle), start[1] + 0.5 * length * np.sin(angle), angle]


def states(robot: RobotModel, y: Array) -> Array:
    """Return places and angles of the three bodies from coordinates of the tree."""
    crank = centre((0.0, 0.0), y[0], CRANK)
    end = (CRANK * np.cos(y[0]), CRANK * np.sin(y[0]))
    second = centre(end, y[0] + y[1], COUPLER)
    slides = robot.joints[2].type is JointType.PRISMATIC
    third = [y[2], 0.0, 0.0] if slides else centre((GROUND, 0.0), y[2], ROCKER)
    return np.array([*crank, *second, *third])


FOUR_BAR_PINS: list[tuple[Point, Point]] = [
    ((0, -CRANK / 2), (-1, 0.0)),
    ((0, CRANK / 2), (1, -COUPLER / 2)),
    ((1, COUPLER / 2), (2, ROCKER / 2)),
    ((2, -ROCKER / 2), (-1, GROUND)),
]
SLIDER_PINS: list[tuple[Point, Point]] = [
    ((0, -CRANK / 2), (-1, 0.0)),
    ((0, CRANK / 2), (1, -COUPLER / 2)),
    ((1, COUPLER / 2), (2, 0.0)),
]


def four_bar_rows(x: Array) -> Array:
    return pins(FOUR_BAR_PINS, x)


def slider_rows(x: Array) -> Array:
    return np.concatenate((pins(SLIDER_PINS, x), x[7:9]))


@pytest.mark.parametrize(
    ("robot", "rows", "speed"),
    [(four_bar(), four_bar_rows, 12.0), (slider_crank(), slider_rows, 8.0)],
    ids=["four-bar", "slider-crank through both dead centres"],
)
def test_a_linkage_moves_as_its_bodies_with_multipliers(
    robot: RobotModel, rows: Callable[[Array], Array], speed: float
) -> None:
    found = joint_motion(robot, [robot.home], [[speed]])
    places = [0, *passive_coordinates(robot)]
    y, yd = found.position[0, places], found.speed[0, places]
    x, v = states(robot, y), states(robot, y + 1e-30j * yd).imag / 1e-30
    M = np.concatenate([[link.mass, link.mass, link.inertia[2, 2]] for link in robot.links])
    x_end, v_end = integrated(rows, M, x, v)
    moved = free_motion(robot, y, yd, STEP, round(DURATION / STEP), every=round(DURATION / STEP))
    end = states(robot, moved.y[-1])
    assert np.abs(end - x_end).max() < CLOSE
    assert abs(moved.y[-1, 0] - y[0]) > 2.0 * np.pi
    assert v_end[2] == pytest.approx(moved.yd[-1, 0], rel=1e-7)
