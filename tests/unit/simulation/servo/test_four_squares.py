"""A hydraulic arm draws four squares: parallel PI loops, and the law that knows flow, load and damping.

The errors are those of an independent simulation of the same arm with equations of its own, to the figures
that are stated.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.controller import law_of
from ropsim.flow import JointReference
from ropsim.model import (
    ControllerKind,
    ControllerModel,
    FlowGains,
    Hydraulic,
    JointSensor,
    JointSensors,
    Payload,
    PiGains,
    Rates,
    RobotModel,
)
from ropsim.robots import controller_under
from ropsim.simulation import SimulationOptions, linear_loop, margins, simulate
from support.hydraulic_arm import LOAD, SQUARES, Errors, angles, errors, hydraulic_arm, mistaken, square

NONE, ONES = np.zeros(2), np.ones(2)
SENSORS = JointSensors(
    (
        JointSensor("coordinate", ONES * 2.0 * np.pi / 2.0**16, NONE),
        JointSensor("pressure", ONES * 250e5 / 2.0**12, NONE),
    )
)
"""16 bits a turn, 12 bits of 250 bar."""
FLOW, PI = ControllerKind.FLOW_LOAD_DAMPING, ControllerKind.PARALLEL_PI


@cache
def _standard(kind: ControllerKind) -> ControllerModel:
    return replace(controller_under(hydraulic_arm(), Rates(), kind), sensors=SENSORS)


def _drawn(
    controller: ControllerModel,
    believed: RobotModel | None = None,
    robot: RobotModel | None = None,
    load: Payload = LOAD,
) -> list[Errors]:
    """Return the errors of the squares that an arm draws under a controller whose law believes in another."""
    arm, found = robot or hydraulic_arm(), []
    law = law_of(controller, believed or hydraulic_arm())
    for name in SQUARES:
        wanted = square(name)
        recording = simulate(arm, controller, wanted.reference, SimulationOptions(payload=load, law=law))
        found.append(errors(recording.channels["q"].values[1:], wanted))
    return found


@cache
def _baseline() -> list[Errors]:
    return _drawn(_standard(PI))


def test_parallel_pi_loops_err_as_in_an_independent_simulation() -> None:
    kp = np.array([0.16, 0.20])
    found = _drawn(replace(_standard(PI), gains=PiGains(kp, kp / 1.3)))
    assert [one.path for one in found] == pytest.approx([6.3e-3, 8.1e-3, 7.6e-3, 5.3e-3], abs=0.06e-3)
    assert [one.path_mean for one in found] == pytest.approx([2.3e-3, 3.3e-3, 2.4e-3, 2.4e-3], abs=0.06e-3)
    assert [one.tracking for one in found] == pytest.approx([49e-3, 52e-3, 47e-3, 33e-3], abs=0.6e-3)


def test_the_law_of_flow_load_and_damping_errs_as_in_an_independent_simulation() -> None:
    """Damping there is 7e-6 m/s per newton at all places, here 70/s over the spring of the oil."""
    gains = FlowGains(30.0 * ONES, 90.0 * ONES, 70.0 * ONES, 5.0 * ONES, 3e-3 * ONES, 1e3 * ONES)
    found = _drawn(replace(_standard(FLOW), gains=gains), mistaken(hydraulic_arm()))
    assert [one.path for one in found] == pytest.approx([1.17e-3, 0.93e-3, 0.79e-3, 0.82e-3], rel=0.1)
    assert [one.tracking for one in found] == pytest.approx([1.5e-3, 1.3e-3, 1.6e-3, 1.9e-3], rel=0.1)


def test_gains_by_the_rule_of_parallel_pi_loops_err_as_little_as_the_best_that_were_found() -> None:
    """The best of a grid of gains with the same margins has 8.1 mm at the worst place."""
    assert max(one.path for one in _baseline()) < 1.1 * 8.1e-3


def test_with_a_true_model_only_the_steps_of_the_sensors_are_left() -> None:
    for one in _drawn(_standard(FLOW)):
        assert one.path < 0.1e-3
        assert one.tracking < 0.2e-3


def test_with_a_wrong_model_it_has_a_quarter_of_the_error_of_parallel_pi_loops_at_each_place() -> None:
    for one, baseline in zip(_drawn(_standard(FLOW), mistaken(hydraulic_arm())), _baseline(), strict=True):
        assert one.path < 0.25 * baseline.path
        assert one.path_mean < 0.25 * baseline.path_mean
        assert one.tracking < 0.1 * baseline.tracking
        assert one.end < 1e-3


def _changed(**factors: float) -> RobotModel:
    """Return the arm with other numbers of its cylinders, as factors."""
    drives = []
    for drive in hydraulic_arm().drives:
        assert isinstance(drive.motor, Hydraulic)
        numbers = {name: factor * getattr(drive.motor, name) for name, factor in factors.items()}
        drives.append(replace(drive, motor=replace(drive.motor, **numbers)))
    return replace(hydraulic_arm(), drives=tuple(drives))


def test_no_single_mistake_makes_it_worse_than_parallel_pi_loops() -> None:
    beliefs = (
        _changed(bulk_modulus=0.6),
        _changed(bulk_modulus=1.4),
        _changed(rated_flow=0.9),
        _changed(rated_flow=1.1),
        _changed(leakage=1.5),
        _changed(leakage=0.5),
        _changed(natural_frequency=0.7),
    )
    for believed in beliefs:
        for one, baseline in zip(_drawn(_standard(FLOW), believed), _baseline(), strict=True):
            assert one.path < 0.25 * baseline.path


@pytest.mark.parametrize(
    "robot",
    [
        _changed(bulk_modulus=2.0 / 3.0),
        _changed(leakage=0.3),
        _changed(supply_pressure=11.0 / 14.0),
        _changed(natural_frequency=0.6),
    ],
)
def test_on_another_plant_it_has_a_quarter_of_the_error_of_parallel_pi_loops(robot: RobotModel) -> None:
    """Softer oil, less leakage, a weaker pump, a slower valve, which both laws do not know."""
    both = (_drawn(_standard(kind), robot=robot) for kind in (FLOW, PI))
    for one, baseline in zip(*both, strict=True):
        assert one.path < 0.25 * baseline.path


@pytest.mark.parametrize("mass", [0.0, 25.0, 40.0])
def test_it_knows_its_load(mass: float) -> None:
    """40 kg are more than the forearm: a rod comes to the end of its force there."""
    load = Payload(mass) if mass else Payload()
    both = (_drawn(_standard(kind), load=load) for kind in (FLOW, PI))
    for one, baseline in zip(*both, strict=True):
        assert one.path < (0.2e-3 if mass < 40.0 else 0.15 * baseline.path)


def _with_edges(null_flow: float, overlap: float) -> RobotModel:
    """Return the arm with valves of a null flow, over the rated flow, and an overlap."""
    drives = []
    for drive in hydraulic_arm().drives:
        assert isinstance(drive.motor, Hydraulic)
        leak = null_flow * drive.motor.rated_flow
        drives.append(replace(drive, motor=replace(drive.motor, null_flow=leak, overlap=overlap)))
    return replace(hydraulic_arm(), drives=tuple(drives))


@pytest.mark.parametrize(("null_flow", "overlap"), [(0.03, 0.0), (0.0, 0.03)])
def test_it_knows_edges_that_leak_or_overlap(null_flow: float, overlap: float) -> None:
    robot = _with_edges(null_flow, overlap)
    flow = replace(controller_under(robot, Rates(), FLOW), sensors=SENSORS)
    both = _drawn(flow, robot, robot), _drawn(_standard(PI), robot, robot)
    for one, baseline in zip(*both, strict=True):
        assert one.path < (0.02 if null_flow else 0.2) * baseline.path


@pytest.mark.slow
def test_no_model_within_the_bounds_is_as_wrong_as_a_quarter_of_parallel_pi_loops() -> None:
    """Of 24 that are wrong by chance: ±20 % mass, ±40 % oil, ±10 % flow, ±50 % friction and leakage."""
    off = np.random.default_rng(3).uniform(-1.0, 1.0, (24, 5)) * [0.2, 0.4, 0.1, 0.5, 0.5]
    for factors in (1.0 + off).tolist():
        believed = mistaken(hydraulic_arm(), *factors)
        for one, baseline in zip(_drawn(_standard(FLOW), believed), _baseline(), strict=True):
            assert one.path < 0.25 * baseline.path


@pytest.mark.parametrize("wrong", [False, True])
def test_its_loops_have_their_margins_at_the_squares(wrong: bool) -> None:
    robot, controller = hydraulic_arm(), _standard(FLOW)
    law = law_of(controller, mistaken(robot) if wrong else robot)
    for corner in SQUARES.values():
        loop = linear_loop(robot, controller, angles(np.array(corner) + 0.05), LOAD, law)
        for axis in range(2):
            found = margins(loop, axis)
            assert found.stable
            assert found.gain > 2.0
            assert found.sensitivity < 2.0


@pytest.mark.parametrize("kind", [FLOW, PI])
def test_plain_python_gives_the_same_as_compiled_code(kind: ControllerKind) -> None:
    robot, wanted = _with_edges(0.02, 0.01), square("far high").reference
    reference = JointReference(wanted.q[200:500], wanted.qd[200:500], wanted.qdd[200:500])
    one, other = (
        simulate(robot, _standard(kind), reference, SimulationOptions(payload=LOAD, engine=engine))
        for engine in Engine
    )
    for name in ("q", "pressure_a", "valve_current"):
        a, b = (each.channels[name].values for each in (one, other))
        np.testing.assert_allclose(a, b, rtol=1e-6, atol=1e-9 * np.abs(b).max())
