"""Errors of sensors in runs: they tell the past of the arm, of devices and of parts, to the bit."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.dynamics import inverse_dynamics
from ropsim.flow import Fidelity, MessageEvent, Recording
from ropsim.kinematics import forward
from ropsim.model import (
    Box,
    Cell,
    ControllerModel,
    DistanceSensor,
    FixedObject,
    ForceTorqueSensor,
    JointSensors,
    MeantContact,
    Payload,
    Rates,
    Sensor,
    SensorErrors,
    Shape,
    Signal,
    Station,
    Tool,
    WrenchAxis,
)
from ropsim.simulation import RunOptions, run
from ropsim.simulation.state.carried_load import carried_load
from ropsim.spatial import Pose
from support.cells import one_station, with_station
from support.compiled import code_of, station_code
from support.printed import si_numbers

ROBOT = robots.load("puma560")
CONTROLLER = robots.default_controller("puma560")
TOP = 0.1
TABLE = FixedObject("table", Pose(np.array([0.5, 0.0, TOP / 2.0])), (Shape(Box((0.6, 1.0, TOP))),))
LOAD = Payload(2.0, np.array([0.01, 0.0, 0.06]), np.diag([0.01, 0.02, 0.005]))
SPEED = 0.1
ABOVE = "mov (500, 0, 300)"
DOWN = "lin (500, 0, 105) speed 100 mm/s until height < 80 mm store seen"
TICK = 4e-3
PRINTED = 1e-6


def cell_with(
    controller: ControllerModel = CONTROLLER, contacts: tuple[MeantContact, ...] = (), **sensors: Sensor
) -> Cell:
    signals = {
        name: Signal(name, is_input=True, analog=True, sensor=sensor) for name, sensor in sensors.items()
    }
    tip = Shape(Box((0.03, 0.03, 0.1)), Pose(np.array([0.0, 0.0, -0.05])))
    tool = Tool("load", mass=LOAD.mass, com=LOAD.com, inertia=LOAD.inertia, shapes=(tip,))
    return one_station(
        "c",
        ROBOT,
        controller,
        tools={"load": tool},
        default_tool="load",
        start=ROBOT.home,
        signals=signals,
        objects=(TABLE,),
        contacts=contacts,
    )


def distance(**errors: float) -> DistanceSensor:
    return DistanceSensor("", 0.3, errors=SensorErrors(**errors))


def recorded(cell: Cell, *lines: str, fidelity: Fidelity = Fidelity.KINEMATIC, hz: int = 1000) -> Recording:
    return run(cell, {"robot": code_of(cell, *lines)}, RunOptions(fidelity, record_hz=hz))


def told(recording: Recording) -> list[float]:
    return [number for event in recording.events_of(MessageEvent) for number in si_numbers(event.text)]


@pytest.mark.parametrize("delay", [0.0, 0.02, 0.05])
def test_a_condition_is_seen_later_by_the_delay(delay: float) -> None:
    """The place that is kept is the way of the delay behind the place that is looked for."""
    found = told(recorded(cell_with(height=distance(delay=delay)), ABOVE, DOWN, "print seen.z"))[0]
    there = TOP + 0.08 - SPEED * delay
    assert there - SPEED * TICK - PRINTED <= found <= there + PRINTED


@pytest.mark.parametrize("fidelity", Fidelity)
def test_what_a_late_sensor_tells_is_where_the_arm_was(fidelity: Fidelity) -> None:
    cell = cell_with(height=distance(delay=0.03))
    recording = recorded(cell, ABOVE, DOWN, "wait 0.1 s", fidelity=fidelity)
    times = recording.channels["signal.height"].times
    assert times is not None
    q = recording.rows("q")
    moving = [k for k, time in enumerate(times) if time > 0.2]
    for k in moving[:: max(1, len(moving) // 20)]:
        tick = round(times[k] * 1000) - 30
        # the recording has a row for each control tick, as fine as the sensor
        z = forward(ROBOT, q[tick]).position[2]
        assert recording.channels["signal.height"].values[k] == pytest.approx(z - TOP, abs=1e-9)
    assert len(moving) > 20


def test_a_run_with_errors_is_the_same_each_time_and_another_one_with_another_seed() -> None:
    lines = (ABOVE, DOWN, "print seen.z")
    noisy = cell_with(height=distance(noise=1e-3, period=0.008, delay=0.006))
    assert recorded(noisy, *lines) == recorded(noisy, *lines)
    other = with_station(noisy, controller=replace(CONTROLLER, sensors=JointSensors(seed=5)))
    assert told(recorded(other, *lines)) != told(recorded(noisy, *lines))


def test_what_is_read_does_not_depend_on_how_often_it_is_asked_for() -> None:
    cell = cell_with(height=distance(noise=1e-3, period=0.05, delay=0.02))
    once = recorded(cell, ABOVE, "wait 0.2 s", "print height")
    often = recorded(cell, ABOVE, *["wait 0.01 s", "print height"] * 20)
    values = told(often)
    assert values[-1] == told(once)[0]
    assert len(set(values)) <= 6


@pytest.mark.parametrize("fidelity", Fidelity)
def test_slices_of_a_run_do_not_change_what_sensors_tell(fidelity: Fidelity) -> None:
    cell = cell_with(height=distance(noise=1e-3, period=0.01, delay=0.015))
    code = {"robot": code_of(cell, ABOVE, DOWN, "print seen.z")}
    whole, sliced = (run(cell, code, RunOptions(fidelity, longest_step=step)) for step in (None, 0.013))
    assert whole == sliced


def test_the_seed_is_one_for_sensors_inside_and_outside() -> None:
    lines = (ABOVE, "print height")
    seeds = [
        told(recorded(cell_with(replace(CONTROLLER, sensors=JointSensors(seed=k)), height=NOISY), *lines))[0]
        for k in range(4)
    ]
    assert len(set(seeds)) == 4


NOISY = distance(noise=1e-3)


@pytest.mark.parametrize("fidelity", Fidelity)
def test_a_tool_at_rest_is_carried_by_its_weight(fidelity: Fidelity) -> None:
    forces = [
        ForceTorqueSensor("", axis, compensated=False) for axis in (WrenchAxis.X, WrenchAxis.Y, WrenchAxis.Z)
    ]
    cell = cell_with(fx=forces[0], fy=forces[1], fz=forces[2])
    found = told(recorded(cell, ABOVE, "wait 0.5 s", "print fx, fy, fz", fidelity=fidelity))
    still = 1e-5 if fidelity is Fidelity.KINEMATIC else 0.02  # [N]; drives hold to some 0.01 m/s²
    assert found == pytest.approx([0.0, 0.0, -LOAD.mass * 9.81], abs=still)


def test_a_compensated_sensor_reads_nothing_in_the_air() -> None:
    cell = cell_with(fz=ForceTorqueSensor("", WrenchAxis.Z))
    recording = recorded(cell, ABOVE, "lin (500, 0, 200) speed 100 mm/s until fz > 1 N", "print fz")
    assert told(recording) == [0.0]


@pytest.mark.parametrize("fidelity", Fidelity)
def test_a_late_force_is_the_contact_force_of_that_time(fidelity: Fidelity) -> None:
    delay = 0.024
    contact = MeantContact("press", "load", ("table",), 5e4, 100.0)
    late = ForceTorqueSensor("", WrenchAxis.Z, errors=SensorErrors(delay=delay))
    cell = cell_with(contacts=(contact,), fz=late)
    down = "lin (500, 0, 99) speed 10 mm/s until fz > 20 N store touch"
    recording = recorded(cell, "mov (500, 0, 103)", down, "wait 0.1 s", "print touch.z", fidelity=fidelity)
    channel, wrench = recording.channels["signal.fz"], recording.rows("contact_wrench")
    assert channel.times is not None
    seen = [(round(1000 * time), value) for time, value in zip(channel.times, channel.values, strict=True)]
    pressed = [(tick, value) for tick, value in seen if value > 0.0]
    assert len(pressed) >= 3
    for tick, value in pressed:
        assert value == pytest.approx(wrench[tick - round(delay * 1000), 2], rel=0.02, abs=0.05)
    assert pressed[-1][1] > 20.0
    assert told(recording)[0] < 0.1 - 20.0 / contact.stiffness - 0.5 * 0.01 * delay


def test_the_load_of_a_moving_arm_is_what_its_joints_feel() -> None:
    """J\u1d40·w of the carried wrench = the joint efforts with the load less those without it."""
    rng = np.random.default_rng(3)
    q, qd, qdd = rng.uniform(-1.0, 1.0, (3, ROBOT.n))
    hz = 1e4
    path = [q + qd * t + qdd * t * t / 2.0 for t in (-1.0 / hz, 0.0, 1.0 / hz)]
    poses = [forward(ROBOT, one) for one in path]
    wrench = carried_load(LOAD, poses, hz, ROBOT.gravity)
    with_load = inverse_dynamics(ROBOT, q, qd, qdd, payload=LOAD)
    extra = with_load - inverse_dynamics(ROBOT, q, qd, qdd)
    assert _power(path, wrench) == pytest.approx(extra, abs=2e-3)


def _power(path: list[np.ndarray], wrench: np.ndarray) -> np.ndarray:
    """Return Jᵀ·w at the last pose of a path, by differences of poses."""
    found, step = np.empty(ROBOT.n), 1e-6
    at = forward(ROBOT, path[2])
    for joint in range(ROBOT.n):
        moved = forward(ROBOT, path[2] + step * np.eye(ROBOT.n)[joint])
        turn = (moved.rotation() @ at.rotation().T - np.eye(3)) / step
        omega = np.array([turn[2, 1], turn[0, 2], turn[1, 0]])
        found[joint] = wrench[:3] @ (moved.position - at.position) / step + wrench[3:] @ omega
    return found


@pytest.mark.parametrize("fidelity", Fidelity)
def test_the_tool_of_another_arm_is_seen_late_where_it_was(fidelity: Fidelity) -> None:
    """The arm that is measured plans and runs a whole move ahead; it has another control rate."""
    delay, period = 0.04, 0.02
    sensor = DistanceSensor("left", 2.0, errors=SensorErrors(delay=delay, period=period))
    signals = {"height": Signal("height", is_input=True, analog=True, sensor=sensor)}
    stations = {
        name: Station(name, ROBOT, replace(CONTROLLER, rates=Rates(hz)), X_WB=base, program=name)
        for name, hz, base in (("left", 500, Pose()), ("right", 1000, Pose(np.array([5.0, 0.0, 0.0]))))
    }
    cell = Cell("c", stations, signals=signals, objects=(TABLE,))
    looks = ["wait 0.1 s", "print height"] * 8
    left = station_code(cell, "left", ABOVE, "lin (500, 0, 150) speed 100 mm/s")
    right = station_code(cell, "right", *["wait 0.1 s"] * 9, *looks)
    recording = run(cell, {"left": left, "right": right}, RunOptions(fidelity, record_hz=500))
    q = recording.rows("left/q")
    seen = [si_numbers(event.text)[0] for event in recording.events_of(MessageEvent)]
    times = [event.time for event in recording.events_of(MessageEvent)]
    assert len(seen) == 8
    for time, found in zip(times, seen, strict=True):
        tick = round((time - delay) * 500)
        tick -= tick % round(period * 500)
        assert found == pytest.approx(forward(ROBOT, q[tick]).position[2] - TOP, abs=PRINTED)
    assert max(seen) - min(seen) > 0.05
