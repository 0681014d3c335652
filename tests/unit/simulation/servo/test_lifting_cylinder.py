"""A link on a cylinder under fixed gains: it follows, stands as statics say, its oil is judged."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.controller import cascaded_p_pi
from ropsim.flow import JointReference
from ropsim.model import CascadedGains, Payload, Rates, RobotModel
from ropsim.robots.standard_controller import cascaded_controller
from ropsim.simulation import Recorder, Servo
from ropsim.simulation.testing import BELOW, FinishedStation, Track, torn_oil
from support.cylinders import CENTRE, CYLINDER, DRIVE, MASS, lifted
from support.servo_cases import standing

TICKS = 900


@cache
def servo(robot: RobotModel) -> Servo:
    model = cascaded_controller(robot, Rates())
    return Servo.build(robot, model, cascaded_p_pi(model, robot), Engine.PYTHON)


def driven(robot: RobotModel, first: float, last: float, ticks: int) -> Recorder:
    """Return what is recorded of a move, and of half a second of standing after it."""
    u = ((np.arange(ticks) + 1.0) / ticks)[:, None]
    q = first + (10.0 * u**3 - 15.0 * u**4 + 6.0 * u**5) * (last - first)
    rates = np.gradient(q, 1e-3, axis=0)
    reference = JointReference(q, rates, np.gradient(rates, 1e-3, axis=0))
    start = servo(robot).initial_state([first])
    recorder = servo(robot).recorder(start)
    end = servo(robot).run(start, reference, Payload(), recorder)
    servo(robot).run(end, standing(q[-1], 500), Payload(), recorder)
    return recorder


@pytest.fixture(scope="module")
def lift() -> Recorder:
    return driven(lifted(), 0.3, 0.36, TICKS)


def found(recorder: Recorder) -> list[str]:
    lifting, track = lifted(), Track()
    station = FinishedStation(lifting, "main.task", 1000, 1.0, recorder.tally, track, track, ())
    return [one.message for one in torn_oil(station)]


def test_the_regulator_is_as_quick_as_the_softest_place_allows() -> None:
    gains = cascaded_controller(lifted(), Rates()).gains
    assert isinstance(gains, CascadedGains)
    leaks = [
        CYLINDER.bulk_modulus * CYLINDER.leakage * sum(1.0 / one for one in CYLINDER.volumes(out))
        for out in np.linspace(0.0, CYLINDER.stroke, 200)
    ]
    crossover = float(gains.kp[0] / 0.25)
    assert crossover >= 0.69 * min(leaks)
    assert 0.5 < crossover < 20.0
    assert gains.ki[0] / crossover < gains.ke[0]


def test_what_leaks_against_a_slow_rod_turns_no_gain_around() -> None:
    leaky = replace(DRIVE, motor=replace(CYLINDER, leakage=1e-9))
    tight, loose = (cascaded_controller(lifted(one), Rates()).gains for one in (DRIVE, leaky))
    assert isinstance(tight, CascadedGains)
    assert isinstance(loose, CascadedGains)
    assert min(tight.ki[0], loose.ki[0]) > 0.0
    assert tight.ke[0] == pytest.approx(loose.ke[0])


def test_it_follows_its_reference_and_comes_to_rest_there(lift: Recorder) -> None:
    rows = lift.channels()
    error = np.abs(rows["q"] - rows["q_ref"])
    assert 1e-5 < error.max() < 8e-3
    assert error[-1] < 0.3 * error.max()


def test_at_rest_the_forces_of_both_chambers_differ_by_the_load_over_its_lever(lift: Recorder) -> None:
    """After the move to within what dry friction bears, as the rod still creeps."""
    rows = lift.channels()
    for row, rub in ((0, 0.0), (-1, DRIVE.friction.coulomb_positive)):
        q, a, b = (float(rows[name][row, 0]) for name in ("q", "pressure_a", "pressure_b"))
        load = MASS * 9.81 * (CENTRE[0] * np.cos(q) - CENTRE[1] * np.sin(q))
        lever = DRIVE.ratio_at(q)
        force = a * CYLINDER.area_a - b * CYLINDER.area_b
        assert force == pytest.approx(load / lever, rel=1e-9, abs=rub)
        assert float(rows["tau"][row, 0]) == pytest.approx(force * lever)


def test_a_load_that_pushes_on_the_oil_leaves_it_whole_and_one_that_draws_the_rod_out_tears_it(
    lift: Recorder,
) -> None:
    """Edges of a valve open alike: what flows out of chamber b at a pull does not fill chamber a."""
    assert lift.tally.worst(BELOW + "pressure_a")[0] == pytest.approx([0.0])
    assert found(lift) == []
    weak = replace(DRIVE, motor=replace(CYLINDER, supply_pressure=18e5))
    pulled = replace(lifted(weak), gravity=np.array([0.0, 0.0, 9.81]))
    out = driven(pulled, 0.3, 0.33, 300)
    (torn,) = found(out)
    assert torn.startswith("chamber a of joint `lift` would have come to -")
    assert torn.endswith("its oil gives way at -1.013 bar")
    below = float(out.tally.worst(BELOW + "pressure_a")[0][0])
    assert out.channels()["pressure_a"].min() == pytest.approx(-1.01325e5 - below)
