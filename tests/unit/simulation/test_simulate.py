"""From references to a recording."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.flow import JointReference
from ropsim.model import Payload
from ropsim.simulation import NoDrivesError, OptionError, SimulationOptions, simulate
from support.arms import drive, random_arm
from support.servo_cases import GOAL, START, CascadeInPython, controller, puma, quintic, standing

CHANNELS = {"q", "qd", "tau", "current", "voltage", "q_ref", "qd_ref", "q_error", "power"}


def test_the_recording_has_all_channels_with_units_and_joint_names() -> None:
    recording = simulate(*puma(), quintic(START, GOAL, 100))
    assert set(recording.channels) == CHANNELS
    assert recording.time.shape == (101,)
    assert recording.duration == pytest.approx(0.1)
    for channel in recording.channels.values():
        assert channel.values.shape == (101, 6)
        assert channel.columns == ("1", "2", "3", "4", "5", "6")
    units = {name: channel.unit for name, channel in recording.channels.items()}
    assert units["q"] == units["q_error"] == "rad"
    assert units["qd"] == "rad/s"
    assert units["tau"] == "N·m"
    assert (units["current"], units["voltage"]) == ("A", "V")


def test_the_error_is_reference_minus_attained() -> None:
    channels = simulate(*puma(), quintic(START, GOAL, 100)).channels
    np.testing.assert_array_equal(channels["q_error"].values, channels["q_ref"].values - channels["q"].values)


def test_the_length_of_slices_does_not_change_a_bit() -> None:
    reference = quintic(START, GOAL, 100)
    first, second = (simulate(*puma(), reference, SimulationOptions(slice_ticks=ticks)) for ticks in (20, 33))
    for name, channel in first.channels.items():
        np.testing.assert_array_equal(channel.values, second.channels[name].values)


def test_decimation_keeps_every_nth_row() -> None:
    reference = quintic(START, GOAL, 100)
    every = simulate(*puma(), reference)
    fourth = simulate(*puma(), reference, SimulationOptions(decimation=4))
    np.testing.assert_array_equal(fourth.time, every.time[::4])
    np.testing.assert_array_equal(fourth.channels["q"].values, every.channels["q"].values[::4])


def test_start_and_payload_come_from_the_options() -> None:
    options = SimulationOptions(start=START, payload=Payload(2.0, np.array([0.0, 0.0, 0.1])))
    loaded = simulate(*puma(), standing(START, 10), options)
    free = simulate(*puma(), standing(START, 10))
    assert loaded.channels["tau"].values[0, 1] != free.channels["tau"].values[0, 1]
    np.testing.assert_allclose(loaded.channels["q"].values[-1], START, rtol=0, atol=1e-9)


def test_the_facts_name_robot_law_and_rates() -> None:
    robot, model = puma()
    facts = simulate(robot, model, standing(START, 1), SimulationOptions(decimation=2)).facts
    (station,) = facts.stations
    assert (station.robot, station.law) == ("puma560", "cascaded_p_pi")
    assert (station.control_hz, station.plant_steps, facts.record_hz) == (1000.0, 2, 500.0)
    own = simulate(robot, model, standing(START, 1), SimulationOptions(law=CascadeInPython(model, robot)))
    assert own.facts.stations[0].law == "CascadeInPython"


def test_prismatic_joints_are_recorded_in_metres_and_newtons() -> None:
    robot = replace(random_arm(3, "PP", (drive(ratio=200.0),) * 2), gravity=np.zeros(3))
    options = SimulationOptions(engine=Engine.PYTHON)
    recording = simulate(robot, controller(2, kv=100.0), standing(np.zeros(2), 3), options)
    assert recording.channels["q"].unit == "m"
    assert recording.channels["tau"].unit == "N"


def test_an_arm_without_drives_is_an_error() -> None:
    with pytest.raises(NoDrivesError, match="has 0 drives"):
        simulate(random_arm(1, "RR"), controller(2), standing(np.zeros(2), 1))


@pytest.mark.parametrize("options", [SimulationOptions(decimation=0), SimulationOptions(slice_ticks=-1)])
def test_counts_below_one_are_an_error(options: SimulationOptions) -> None:
    with pytest.raises(OptionError, match="allowed are whole numbers from 1"):
        simulate(*puma(), standing(START, 1), options)


def test_an_empty_reference_is_an_error() -> None:
    empty = np.zeros((0, 6))
    with pytest.raises(OptionError, match=r"`reference\.ticks` is `0`"):
        simulate(*puma(), JointReference(empty, empty, empty))
