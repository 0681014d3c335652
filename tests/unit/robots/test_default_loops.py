"""Laws of the standard controllers: every arm of the library is stable, hardly overshoots, settles soon."""

from dataclasses import replace
from math import isfinite

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.controller import CompiledLaw, law_of
from ropsim.flow import MoveEvent, Recording
from ropsim.model import ControllerKind, ElasticGear, Friction, JointType, Payload, Rates, RobotModel, Tool
from ropsim.simulation import RunOptions, linear_loop, run
from ropsim.spatial import Pose
from ropsim.workbench import environment_of
from support.cells import one_station
from support.closed_loops import closed_loop, postures, rated_load

OVERSHOOT = 0.10
"""Most by which an axis may go beyond a small step of its reference, over the step."""
SETTLING = 0.03
"""Most of a cycle that settling may take."""
SECONDS, LONG_SECONDS = 0.4, 4.0
"""How long an answer is looked at, and that of an arm on elastic gears or on its oil [s]."""
KNOWN = {"cobra600": 5.5, "puma560": 2.3, "tx60": 3.5}
"""Rated loads in data sheets of arms whose models have none [kg]."""
MOVES = 12
ARMS = [name for name in robots.names() if robots.load(name).drives]
QUICK = ["manutec_r3", "scara"]
SLOW = [pytest.param(name, marks=pytest.mark.slow) for name in ARMS if name not in QUICK]


def loads(robot: RobotModel) -> list[float]:
    """Return nothing, and the rated load of an arm where that is known [kg]."""
    mass = robot.rated_payload if isfinite(robot.rated_payload) else KNOWN.get(robot.name, 0.0)
    return [0.0, mass] if mass else [0.0]


@pytest.mark.parametrize("name", ARMS)
def test_every_arm_is_stable_and_overshoots_by_a_tenth_at_most(name: str) -> None:
    """Folded, half stretched and stretched, without and with rated load; stable a tick later, too."""
    robot, controller = robots.load(name), robots.default_controller(name)
    ticks = round((LONG_SECONDS if robots.swings(robot) else SECONDS) * controller.rates.control_hz)
    for mass in loads(robot):
        for q in postures(robot, mass):
            loop = linear_loop(robot, controller, q, rated_load(mass))
            assert closed_loop(loop).radius < 1.0
            assert closed_loop(loop, 1).radius < 1.0
            assert closed_loop(loop).overshoots(ticks).max() <= OVERSHOOT


def test_loops_of_fixed_gains_are_not_stable_with_every_load() -> None:
    """What this law is for: at its rated load a wrist moves many times what it moves without."""
    robot = robots.load("lr_mate_200id")
    fixed = robots.cascaded_controller(robot, Rates())
    empty, full = (
        max(closed_loop(linear_loop(robot, fixed, q, rated_load(mass))).radius for q in postures(robot, mass))
        for mass in loads(robot)
    )
    assert empty < 1.0 < full


def test_a_longer_delay_makes_a_loop_unstable() -> None:
    robot, controller = robots.load("scara"), robots.default_controller("scara")
    (q, *_) = postures(robot, 0.0)
    loop = linear_loop(robot, controller, q, Payload())
    radii = [closed_loop(loop, ticks).radius for ticks in (0, 4, 8)]
    assert radii[0] < radii[1] < 1.0 < radii[2]


def springs(softer: float) -> RobotModel:
    """Return an arm with springs in all its axes, which nothing else damps."""
    r3 = robots.load("manutec_r3")
    stiffness = softer * np.array([4.7e5, 3.5e5, 2.1e5, 2e5, 1e5, 2e4])
    drives = (
        replace(drive, transmission=ElasticGear(drive.ratio_at(0.0), float(one)), friction=Friction())
        for drive, one in zip(r3.drives, stiffness, strict=True)
    )
    return replace(r3, drives=tuple(drives))


@pytest.mark.parametrize("softer", [1.0, 0.1])
def test_an_arm_on_springs_is_damped_by_its_loops(softer: float) -> None:
    robot = springs(softer)
    controller = robots.default_controller(robot)
    for mass in loads(robot):
        for q in postures(robot, mass):
            assert closed_loop(linear_loop(robot, controller, q, rated_load(mass))).radius < 1.0


# ---- runs ----


def program(robot: RobotModel) -> str:
    """Return a task text with moves from pose to pose over most of the joint ranges, at full speed."""
    rng = np.random.default_rng(11)
    turns = np.array([joint.measure is JointType.REVOLUTE for joint in robot.axis_joints])
    half = 0.35 * (robot.upper_limits - robot.lower_limits)
    reach = np.where(turns, np.minimum(half, 1.2), half)
    middle = 0.5 * (robot.lower_limits + robot.upper_limits)
    targets = middle + reach * rng.uniform(-1.0, 1.0, (MOVES, robot.n))
    targets *= np.where(turns, np.degrees(1.0), 1e3)
    moves = [f"mov joints({', '.join(f'{value:.3f}' for value in row)})" for row in targets]
    return "\n".join(["program settle", "units mm, deg", *moves, ""])


def ran(robot: RobotModel, mass: float) -> Recording:
    load = rated_load(mass)
    tool = Tool("load", Pose(np.array([0.0, 0.0, 0.1])), load.mass, load.com, load.inertia)
    controller = robots.default_controller(robot)
    cell = one_station("c", robot, controller, tools={"load": tool}, default_tool="load", start=robot.home)
    compiled = ropsim.language.compile(program(robot), environment_of(cell))
    assert compiled.icr is not None, compiled.diagnostics
    return run(cell, {"robot": compiled.icr}, RunOptions())


@pytest.mark.parametrize("name", [*QUICK, *SLOW])
def test_settling_takes_three_per_cent_of_a_cycle_at_most(name: str) -> None:
    robot = robots.load(name)
    for mass in loads(robot):
        recording = ran(robot, mass)
        moves = recording.events_of(MoveEvent)
        assert len(moves) >= 0.7 * MOVES  # others have coupled limits in their way
        assert sum(move.settle for move in moves) <= SETTLING * recording.duration
        assert not {"S720", "S724", "S735"} & {finding.code for finding in recording.findings}


def test_arms_with_electric_motors_get_computed_torque_and_share_its_code() -> None:
    kinds = {name: robots.default_controller(name).kind for name in ARMS}
    others = {name for name, kind in kinds.items() if kind is not ControllerKind.COMPUTED_TORQUE}
    assert others == {"patu655"}
    robot = robots.load("puma560")
    links = tuple(replace(link, mass=1.1 * link.mass) for link in robot.links)
    one, two = (law_of(robots.default_controller(arm), arm) for arm in (robot, replace(robot, links=links)))
    assert isinstance(one, CompiledLaw)
    assert isinstance(two, CompiledLaw)
    assert (one.source, one.functions) == (two.source, two.functions)
    assert (one.parameters != two.parameters).any()
